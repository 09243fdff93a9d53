// Keys by name, as they come from the page.
#pragma once

#include <string>

#include "input.h"

namespace marrow {

/// A single character of ASCII means the key that writes it. No key for a name that is not known.
KeyEvent keyNamed(const std::string& name);

}  // namespace marrow
