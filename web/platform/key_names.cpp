#include "platform/key_names.h"

#include <array>
#include <utility>

namespace marrow {

KeyEvent keyNamed(const std::string& name) {
  static constexpr std::array<std::pair<const char*, Key>, 14> kNames{{
      {"undo", Key::undo},
      {"redo", Key::redo},
      {"selectAll", Key::select_all},
      {"open", Key::open},
      {"save", Key::save},
      {"saveAs", Key::save_as},
      {"escape", Key::escape},
      {"backspace", Key::backspace},
      {"enter", Key::enter},
      {"leftArrow", Key::left_arrow},
      {"rightArrow", Key::right_arrow},
      {"home", Key::home},
      {"end", Key::end},
      {"deleteForward", Key::delete_forward},
  }};
  if (name.size() == 1 && name[0] > 32 && name[0] < 127) return {Key::none, name[0]};
  for (const auto& [known, key] : kNames) {
    if (name == known) return {key};
  }
  return {};
}

}  // namespace marrow
