// marrow_creatures FOLDER FIRST COUNT: writes documents of random creatures, FIRST.json and so on.
#include "support/creatures.h"

#include <cstdio>
#include <cstdlib>
#include <fstream>
#include <string>

#include "io/document_json.h"

int main(int argc, char** argv) {
  using namespace marrow;
  if (argc != 4) {
    std::fprintf(stderr, "marrow_creatures FOLDER FIRST COUNT\n");
    return 2;
  }
  const std::string folder = argv[1];
  const uint64_t first = std::strtoull(argv[2], nullptr, 10);
  const uint64_t count = std::strtoull(argv[3], nullptr, 10);
  for (uint64_t number = first; number < first + count; ++number) {
    Random random(number);
    CreatureOptions options;
    options.mirrored = 0.4;
    const int parts = number % 25 == 0 ? 40 : 1 + random.below(12);
    const Document creature = randomCreature(random, parts, options);
    std::ofstream file(folder + '/' + std::to_string(number) + ".json", std::ios::binary);
    file << writeDocument(creature);
    if (!file.flush()) {
      std::fprintf(stderr, "%s cannot be written to\n", folder.c_str());
      return 1;
    }
  }
  return 0;
}
