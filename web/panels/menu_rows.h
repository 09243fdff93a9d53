// What the sheets about drawings and pictures are made of.
#pragma once

#include "keep/thumbnails.h"
#include "panels/layout.h"

namespace marrow {

/// A sheet below the toolbar; on a narrow canvas as any other.
PanelBox menuBox(const UiState& ui, float width);

/// A row to press: icon, words, and at its right the key that does the same.
bool menuRow(const char* id, const char* icon, const char* text, const char* keys, float height,
             bool enabled = true);

/// A picture with round corners in the given place; a pale field until it is there.
void thumbnailAt(const Thumbnail* thumbnail, ImVec2 low, ImVec2 high, float rounding);

/// A card to press: a thumbnail above a name.
bool thumbnailCard(const char* id, const Thumbnail* thumbnail, const char* name, float width);

/// A row to press: a thumbnail, a name, and words in a quieter colour below it.
bool thumbnailRow(const char* id, const Thumbnail* thumbnail, const char* name, const char* words,
                  float height);

/// A button with a ground of its own.
bool paleButton(const char* id, const char* text, float width, float height, const char* tooltip,
                bool danger = false);
/// A button in the accent's colour.
bool accentButton(const char* id, const char* text, float width, float height);

/// The text, cut with an ellipsis where it is wider than that.
std::string shortened(const std::string& text, float width);

}  // namespace marrow
