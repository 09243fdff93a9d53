// Keys by name, as the platforms and their scripts give them.
#pragma once

#include <string>

#include "input.h"

namespace marrow {

/// "undo", "frameAll", … ; Key::none for any other name.
Key keyNamed(const std::string& name);

}  // namespace marrow
