// What lies beside the document: where drawings are kept, and what was made to be looked at.
#pragma once

#include "keep/keeping.h"
#include "keep/pictures.h"
#include "keep/thumbnails.h"

namespace marrow {

struct Shelf {
  explicit Shelf(Clock clock) : thumbnails(clock) {}

  Keeping keeping;
  Thumbnails thumbnails;
  Pictures pictures;
};

/// What a panel asks for about files.
struct FileAction {
  enum class Kind : uint8_t {
    begin,      // a new drawing
    open,       // `what`: a path where the platform has no dialogs
    save,       // as above
    save_as,    // as above
    sample,     // `what`: its file
    thumbnail,  // of a sample: `what` is its file
    list,       // kept drawings
    peek,       // the thumbnail of a kept drawing; `what` is its slot
    restore,    // as above
    dismiss,    // as above
    rename,     // the drawing, to `what`
    picture,    // choose a picture to draw after
    make,       // a file of the character, as UiState::exporting says; `what`: its name or path
    give_up,    // that file
  };
  Kind kind = Kind::begin;
  std::string what;
};

}  // namespace marrow
