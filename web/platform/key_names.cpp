#include "platform/key_names.h"

#include <array>
#include <utility>

namespace marrow {

Key keyNamed(const std::string& name) {
  static constexpr std::array<std::pair<const char*, Key>, 18> kNames{{
      {"undo", Key::undo},
      {"redo", Key::redo},
      {"remove", Key::remove},
      {"escape", Key::escape},
      {"front", Key::front},
      {"right", Key::right},
      {"top", Key::top},
      {"frameAll", Key::frame_all},
      {"help", Key::help},
      {"backspace", Key::backspace},
      {"enter", Key::enter},
      {"leftArrow", Key::left_arrow},
      {"rightArrow", Key::right_arrow},
      {"home", Key::home},
      {"end", Key::end},
      {"selectAll", Key::select_all},
      {"deleteForward", Key::delete_forward},
      {"none", Key::none},
  }};
  for (const auto& [known, key] : kNames) {
    if (name == known) return key;
  }
  return Key::none;
}

}  // namespace marrow
