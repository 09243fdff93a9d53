// What the platform is to do in its workshop (workshop.h).
#pragma once

#include <cstdint>
#include <string>

namespace marrow {

/// Begin this work in place of what is under way; an empty request: only give that up.
struct WorkOrder {
  uint64_t number = 0;
  std::string request;
};

}  // namespace marrow
