// The command line.
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <string>
#include <vector>

#include "cli/commands.h"
#include "cli/files.h"

namespace marrow {
namespace {

constexpr char kUsage[] =
    "Usage: marrow part STROKE.json [options]\n"
    "Makes an inflated part with a skeleton of a closed stroke,\n"
    "{\"name\", \"closed\", \"points\": [[x, y], …]}, y up.\n"
    "\n"
    "  --eps-s X       how far bones may leave the axis, 0.001 … 1000 (default 5)\n"
    "  --thickness X   scales the depth, 0.001 … 1000 (default 1)\n"
    "  --json OUT      everything about the part: outline, skeletons, joints, mesh, timings\n"
    "  --obj OUT       the mesh, and the bones as lines\n"
    "  --svg OUT       a picture of outline, skeletons, joints and radii\n"
    "\n"
    "       marrow rig DOCUMENT.json [options]\n"
    "Makes one character with one skeleton of a document's parts. A GLB that Marrow wrote holds "
    "its\n"
    "document and is read like one.\n"
    "\n"
    "  --eps-s X       refinement of the whole model, 0 … 2000, larger is coarser: how far bones\n"
    "                  may leave the axis (default 5),\n"
    "  --eps-m X       within which junctions become one (default 30),\n"
    "  --eps-t X       how long a side branch must be to stay (default 30),\n"
    "  --eps-c X       how long a bone between joints must be to stay (default 10).\n"
    "                  They take the place of what the document sets for the whole model; what it\n"
    "                  sets for a single part or branch still counts there\n"
    "  --json OUT      joints, bones, connections, roots, timings\n"
    "  --obj OUT       the visible parts' meshes where they are in space, and the bones as lines\n"
    "  --svg OUT       a picture from three sides\n"
    "  --glb OUT       the skinned model for Blender, three.js and game engines, with its poses;\n"
    "                  the drawing lies in it, to be opened again. With it, --gltf, --merge or\n"
    "                  --parts, the JSON also tells of the merged body and of the weights\n"
    "  --gltf OUT      the same as a text\n"
    "  --merge         one watertight body around all parts (the default)\n"
    "  --parts         each part a mesh of its own\n"
    "  --no-weights    the meshes follow no bone\n"
    "  --blend R       how far around the seams between parts the body is soft, 0 … 1000 units\n"
    "                  (default: as the document has it)\n"
    "  --scale X       metres per unit, 1e-09 … 1e+09 (default 0.01)\n"
    "\n"
    "       marrow pose DOCUMENT.json [--pose NAME] [options]\n"
    "Gives the watertight body in one of the document's poses, or at rest.\n"
    "\n"
    "  --dual          skinned by dual quaternions, not linearly\n"
    "  --blend R       as above\n"
    "  --obj OUT, --stl OUT, --ply OUT   the mesh; STL and PLY are binary\n"
    "\n"
    "  --help          this text\n"
    "\n"
    "Without an output a summary is printed. Exit code 0, or 2 when something is wrong.\n";

int run(const std::vector<std::string>& words) {
  for (const std::string& word : words) {
    if (word == "--") break;
    if (word == "--help" || word == "-h") {
      std::fputs(kUsage, stdout);
      return std::fflush(stdout) == 0 ? kFine : kRefused;
    }
  }
  if (words.empty()) {
    std::fputs(kUsage, stderr);
    return kRefused;
  }
  const std::vector<std::string> rest(words.begin() + 1, words.end());
  if (words[0] == "part") return runPart(rest);
  if (words[0] == "rig") return runRig(rest);
  if (words[0] == "pose") return runPose(rest);
  return refuse("unknown command " + words[0] + " (marrow --help tells more)");
}

}  // namespace

void warn(const std::string& fault) {
  const std::string line = printable("marrow: " + fault) + '\n';
  std::fputs(line.c_str(), stderr);
}

int refuse(const std::string& fault) {
  warn(fault);
  return kRefused;
}

bool isFinite(const Evaluation& character) {
  const auto isSomewhere = [](Vec3 p) { return std::isfinite(dot(p, p)); };
  for (const Rig::Joint& joint : character.rig().joints) {
    if (!isSomewhere(joint.position) || !std::isfinite(joint.radius)) return false;
  }
  for (const PlacedPart& placed : character.placed()) {
    const Part* part = character.parts()[placed.source].part.get();
    if (!part) continue;
    for (const Vec3 p : part->mesh.positions) {
      if (!isSomewhere(placed.frame.toWorld(p))) return false;
    }
  }
  return true;
}

double milliseconds() {
  const auto now = std::chrono::steady_clock::now().time_since_epoch();
  return std::chrono::duration<double, std::milli>(now).count();
}

}  // namespace marrow

int main(int count, char** words) {
  std::set_new_handler([] {
    std::fputs("marrow: not enough memory\n", stderr);
    std::_Exit(marrow::kRefused);
  });
#ifdef SIGPIPE
  std::signal(SIGPIPE, SIG_IGN);
#endif
  return marrow::run({words + (count > 0 ? 1 : 0), words + count});
}
