// Any bytes of the format MARROW_FUZZED_FORMAT are an error in one sentence, or a solid; and what a
// document keeps of it is read as it was written.
#include <cmath>
#include <cstdint>

#include "document/command.h"
#include "fuzz/check.h"
#include "io/mesh_import.h"
#include "support/soundness.h"

using namespace marrow;

extern "C" int LLVMFuzzerTestOneInput(const uint8_t* data, size_t size) {
  const std::string bytes(reinterpret_cast<const char*>(data), size);
  documentInGlb(bytes);
  const auto mesh = importMesh(bytes, MeshFormat::MARROW_FUZZED_FORMAT);
  if (!mesh) {
    const Status status = mesh.status();
    check(status == Status::unreadable || status == Status::tooMany || status == Status::notSolid,
          "a reader's error");
    const std::string sentence = mesh.message();
    check(!sentence.empty() && sentence.back() == '.', "a sentence: " + sentence);
    check(sentence.find('\n') == std::string::npos, "one line: " + sentence);
    return 0;
  }
  const MeshReport report = inspect(*mesh);
  check(report.closed && report.manifold && report.volume > 0, "a solid");
  for (const Vec3 p : mesh->positions) {
    check(std::fabs(p.x) <= 1 && std::fabs(p.y) <= 1 && std::fabs(p.z) <= 1, "of size one");
  }
  const auto document = apply({}, ImportPart{std::make_shared<const Mesh>(*mesh), "thing"});
  if (document) check(faultOf(*document).empty(), "sound: " + faultOf(*document));
  return 0;
}
