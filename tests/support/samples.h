// The sample creatures of the gallery.
#pragma once

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>
#include <utility>
#include <vector>

#include "io/document_json.h"
#include "io/json.h"

namespace marrow {

struct SampleFile {
  std::string name;  // of the file
  std::string text;
  Json tree;
  Document document;  // empty where the text cannot be read
};

/// By name; read once.
inline const std::vector<SampleFile>& sampleFiles() {
  static const std::vector<SampleFile> all = [] {
    std::vector<SampleFile> found;
    const std::string folder = MARROW_TEST_DATA_DIR "/../../public/samples";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.path().extension() != ".json") continue;
      SampleFile sample;
      sample.name = entry.path().stem().string();
      std::ifstream file(entry.path(), std::ios::binary);
      sample.text.assign(std::istreambuf_iterator<char>(file), {});
      if (auto tree = parseJson(sample.text)) sample.tree = *tree;
      if (sample.tree.is_object() && !field(sample.tree, "format")) continue;  // no drawing
      if (auto document = readDocument(sample.text)) sample.document = *document;
      found.push_back(std::move(sample));
    }
    std::sort(found.begin(), found.end(),
              [](const SampleFile& a, const SampleFile& b) { return a.name < b.name; });
    return found;
  }();
  return all;
}

}  // namespace marrow
