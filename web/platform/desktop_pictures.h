// Reference pictures without a browser: PNG and JPEG.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "keep/pictures.h"

namespace marrow {

/// A picture file as it is kept in a document: at most kLargestSide across and kLargestFile large.
struct PictureText {
  static constexpr int kLargestSide = 2048;
  static constexpr size_t kLargestFile = 2u << 20;

  std::string image;  // data URL
  int width = 0, height = 0;
};
/// Nothing where the bytes are no PNG or JPEG.
std::optional<PictureText> pictureText(const std::vector<uint8_t>& file);

/// The pixels of a data URL; nothing where it holds no PNG or JPEG.
std::optional<Pixels> pixelsOf(const std::string& image);

}  // namespace marrow
