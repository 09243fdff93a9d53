#include "support/polygons.h"

#include "bench/inputs.h"

namespace marrow::bench {

std::vector<Family> polygonsThatGrow() {
  return {
      {"blob", [](Random& random, int n) { return randomBlob(random, n); }},
      {"jagged star", [](Random& random, int n) { return randomStar(random, n, 0.7); }},
      {"spiral band",
       [](Random& random, int n) {
         const double turns = std::min(3.0, n / 40.0);  // coarser ones would cross themselves
         return spiralBand(n / 2, turns, random.between(1.5, 3.5));
       }},
  };
}

}  // namespace marrow::bench
