#include "solid/clean.h"

namespace marrow {

void collapseSlivers(const std::vector<Vec3>&, size_t, std::vector<std::array<uint32_t, 3>>&,
                     std::vector<uint32_t>&) {}

}  // namespace marrow
