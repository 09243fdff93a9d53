#include "bench/placed_joints.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <memory>

#include "bench/creatures.h"
#include "document/evaluation.h"

namespace marrow::bench {
namespace {

constexpr double kJointReach = 0.05;
constexpr double kTipReach = 0.08;
constexpr double kMirrorReach = 0.01;
constexpr double kNever = std::numeric_limits<double>::infinity();

Vec2 toPoint(const Json& json) { return {json.at(0).get<double>(), json.at(1).get<double>()}; }

std::vector<Vec2> toPoints(const Json& json) {
  std::vector<Vec2> points;
  for (const Json& point : json) points.push_back(toPoint(point));
  return points;
}

PlacedDrawing toDrawing(const Json& json) {
  PlacedDrawing drawing;
  drawing.name = json.at("name");
  drawing.biped = json.at("kind") == "biped";
  drawing.symmetric = json.at("symmetry") == "exact";
  if (json.contains("points")) {
    drawing.points = toPoints(json["points"]);
  } else {
    const std::string file = strokes::sharedFolder() + "/" + json.at("outline").get<std::string>();
    const std::string text = strokes::readText(file);
    if (!text.empty()) drawing.points = toPoints(Json::parse(text).at("points"));
  }
  const Json joints = json.value("joints", Json::object());
  for (const auto& [name, at] : joints.items()) {
    drawing.joints.push_back({name, toPoint(at)});
  }
  drawing.straight = json.value("straight", drawing.straight);
  drawing.bent = json.value("bent", drawing.bent);
  for (const Json& limb : json.value("limbs", Json::array())) {
    drawing.limbs.push_back({limb.at("name"), toPoint(limb.at("tip")), toPoint(limb.at("base"))});
  }
  for (const Json& limb : json.value("allowed", Json::array())) {
    drawing.limbs.push_back({limb.at("name"), toPoint(limb.at("tip")), {}, false});
  }
  return drawing;
}

bool contains(const std::vector<std::string>& names, const std::string& name) {
  return std::find(names.begin(), names.end(), name) != names.end();
}

bool endsWith(const std::string& text, const std::string& end) {
  return text.size() >= end.size() && text.compare(text.size() - end.size(), end.size(), end) == 0;
}

/// What was rigged, seen from the front.
struct Rigged {
  std::vector<Vec2> joints, terminals;
  double size = 0;  // larger side of the outline's box
};

Rigged rigged(const PlacedDrawing& drawing) {
  Document document;
  auto part = std::make_shared<PartSource>();
  part->id = partId(takePartNumber(document));
  part->name = drawing.name;
  part->stroke = drawing.points;
  document.parts.push_back(std::move(part));
  Evaluation evaluation;
  evaluation.update(document);
  Rigged result;
  for (const Rig::Joint& joint : evaluation.rig().joints) {
    const Vec2 at{joint.position.x, joint.position.y};
    result.joints.push_back(at);
    if (joint.kind == JointKind::terminal) result.terminals.push_back(at);
  }
  Vec2 low = drawing.points.front(), high = low;
  for (const Vec2 p : drawing.points) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  result.size = std::max(high.x - low.x, high.y - low.y);
  return result;
}

double nearest(const std::vector<Vec2>& points, Vec2 to) {
  double least = kNever;
  for (const Vec2 p : points) least = std::min(least, distance(p, to));
  return least;
}

/// How much room the outline leaves around a point.
double room(const std::vector<Vec2>& outline, Vec2 at) {
  double least = kNever;
  for (size_t i = 0; i < outline.size(); ++i) {
    const Vec2 a = outline[i], way = outline[(i + 1) % outline.size()] - a;
    const double square = dot(way, way);
    const double t = square > 0 ? std::clamp(dot(at - a, way) / square, 0.0, 1.0) : 0;
    least = std::min(least, distance(at, a + way * t));
  }
  return least;
}

/// Something that a rig lacks, or has too much of.
struct Miss {
  std::string drawing, what;
  double off = 0;  // share of the size; infinite: there was no rig
};

/// How many of what was wanted is there.
struct Share {
  size_t found = 0, all = 0;
  Miss worst;

  void count(double off, double reach, const std::string& drawing, const std::string& what) {
    ++all;
    if (off <= reach) ++found;
    if (off > worst.off) worst = {drawing, what, off};
  }
};

std::string percent(double share) {
  char text[32];
  std::snprintf(text, sizeof text, "%.1f %%", 100 * share);
  return text;
}

QualityRow toRow(const char* what, const Share& share, double wanted) {
  QualityRow row{what, 0, wanted, true, "%", ""};
  row.value =
      share.all ? 100.0 * static_cast<double>(share.found) / static_cast<double>(share.all) : 0;
  row.note = std::to_string(share.found) + " of " + std::to_string(share.all);
  if (share.worst.off > 0) {
    row.note += "; worst " + share.worst.drawing + ", " + share.worst.what + ": " +
                percent(share.worst.off);
  }
  return row;
}

class Tally {
 public:
  void add(const PlacedDrawing& drawing) {
    const Rigged rig = rigged(drawing);
    if (rig.joints.empty()) misses_.push_back({drawing.name, "no rig", kNever});
    std::vector<WantedLimb> limbs = drawing.limbs;
    if (drawing.biped) {
      ++bipeds_;
      joints_ += rig.joints.size();
      for (const PlacedJoint& joint : drawing.joints) {
        if (joint.name == "root") continue;  // where the pelvis is
        addJoint(drawing, rig, joint);
        if (isEnd(joint.name)) limbs.push_back({joint.name, joint.position, {}});
      }
    } else {
      for (const WantedLimb& limb : limbs) {
        if (!limb.wanted) continue;
        const double off = nearest(rig.joints, limb.tip) / rig.size;
        tips_.count(off, kTipReach, drawing.name, limb.name);
        note(off, kTipReach, drawing.name, limb.name + "'s tip");
        bases_.count(nearest(rig.joints, limb.base) / rig.size, kTipReach, drawing.name, limb.name);
      }
      ++others_;
    }
    addUnwanted(drawing, rig, limbs);
    if (drawing.symmetric) {
      for (const Vec2 p : rig.joints) {
        const double off = nearest(rig.joints, {-p.x, p.y}) / rig.size;
        mirrored_.count(off, kMirrorReach, drawing.name, "a joint");
      }
    }
  }

  std::vector<QualityRow> rows() const {
    std::vector<QualityRow> rows;
    rows.push_back(toRow("joints placed by hand, within 5 % of one of ours", all_, 92));
    QualityRow count{"joints of a biped, mean", 0, 24, false, "", ""};
    count.value = bipeds_ ? static_cast<double>(joints_) / static_cast<double>(bipeds_) : 0;
    count.note = std::to_string(bipeds_) + " bipeds";
    rows.push_back(count);
    rows.push_back(toRow("placed: elbows and knees, straight", straight_, 90));
    rows.push_back(toRow("placed: elbows and knees, bent", bent_, 90));
    rows.push_back(toRow("placed: pelvis and chest", trunk_, 80));
    rows.push_back(toRow("placed: shoulders and hips", bases_of_limbs_, 90));
    rows.push_back(toRow("placed: hands and feet", ends_, 95));
    rows.push_back(toRow("placed: neck and head", head_, 90));
    rows.push_back(unwanted("ends nobody wanted, a biped", bipeds_, unwanted_of_bipeds_));
    rows.push_back(toRow("other creatures: limb tips within 8 % of a joint of ours", tips_, 95));
    rows.push_back(toRow("other creatures: limb bases within 8 % of a joint of ours", bases_, 80));
    rows.push_back(unwanted("ends nobody wanted, another creature", others_, unwanted_of_others_));
    rows.push_back(
        toRow("joints with a mirror image within 1 %, exactly symmetric drawings", mirrored_, 98));
    return rows;
  }

  /// The worst first.
  std::vector<Miss> misses() const {
    std::vector<Miss> sorted = misses_;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Miss& a, const Miss& b) { return a.off > b.off; });
    return sorted;
  }

 private:
  static bool isEnd(const std::string& name) {
    return name == "head" || endsWith(name, "_hand") || endsWith(name, "_foot");
  }

  void addJoint(const PlacedDrawing& drawing, const Rigged& rig, const PlacedJoint& joint) {
    const std::string& name = joint.name;
    const double off = nearest(rig.joints, joint.position) / rig.size;
    const auto count = [&](Share& share) { share.count(off, kJointReach, drawing.name, name); };
    count(all_);
    if (contains(drawing.straight, name)) count(straight_);
    if (contains(drawing.bent, name)) count(bent_);
    if (name == "hip" || name == "torso") count(trunk_);
    if (endsWith(name, "_shoulder") || endsWith(name, "_hip")) count(bases_of_limbs_);
    if (endsWith(name, "_hand") || endsWith(name, "_foot")) count(ends_);
    if (name == "neck" || name == "head") count(head_);
    note(off, kJointReach, drawing.name, name);
  }

  /// Each limb that may be there takes the nearest of our ends in it; the others nobody wanted.
  void addUnwanted(const PlacedDrawing& drawing, const Rigged& rig,
                   const std::vector<WantedLimb>& limbs) {
    struct Pair {
      double apart;
      size_t end, limb;
    };
    std::vector<Pair> pairs;
    for (size_t end = 0; end < rig.terminals.size(); ++end) {
      for (size_t limb = 0; limb < limbs.size(); ++limb) {
        const Vec2 tip = limbs[limb].tip;
        const double apart = distance(rig.terminals[end], tip);
        // A thick limb's end is anywhere in its last ball.
        if (apart <= std::max(kTipReach * rig.size, room(drawing.points, tip))) {
          pairs.push_back({apart, end, limb});
        }
      }
    }
    std::stable_sort(pairs.begin(), pairs.end(),
                     [](const Pair& a, const Pair& b) { return a.apart < b.apart; });
    std::vector<bool> end_taken(rig.terminals.size()), limb_taken(limbs.size());
    for (const Pair& pair : pairs) {
      if (end_taken[pair.end] || limb_taken[pair.limb]) continue;
      end_taken[pair.end] = limb_taken[pair.limb] = true;
    }
    for (size_t end = 0; end < rig.terminals.size(); ++end) {
      if (end_taken[end]) continue;
      ++(drawing.biped ? unwanted_of_bipeds_ : unwanted_of_others_);
      const Vec2 at = rig.terminals[end];
      misses_.push_back({drawing.name,
                         "an end nobody wanted at " + std::to_string(std::lround(at.x)) + ", " +
                             std::to_string(std::lround(at.y)),
                         0});
    }
  }

  static QualityRow unwanted(const char* what, size_t drawings, size_t ends) {
    QualityRow row{what, 0, 0.25, false, "", ""};
    row.value = drawings ? static_cast<double>(ends) / static_cast<double>(drawings) : 0;
    row.note = std::to_string(ends) + " in " + std::to_string(drawings) + " drawings";
    return row;
  }

  void note(double off, double reach, const std::string& drawing, const std::string& what) {
    if (off > reach) misses_.push_back({drawing, what, off});
  }

  Share all_, straight_, bent_, trunk_, bases_of_limbs_, ends_, head_, tips_, bases_, mirrored_;
  size_t bipeds_ = 0, joints_ = 0, others_ = 0, unwanted_of_bipeds_ = 0, unwanted_of_others_ = 0;
  std::vector<Miss> misses_;
};

Tally tally() {
  Tally tally;
  for (const PlacedDrawing& drawing : placedDrawings()) tally.add(drawing);
  return tally;
}

}  // namespace

std::vector<PlacedDrawing> placedDrawings() {
  std::vector<std::string> files;
  const std::string folder = MARROW_TEST_DATA_DIR "/characters";
  for (const auto& entry : std::filesystem::directory_iterator(folder)) {
    if (entry.path().extension() == ".json") files.push_back(entry.path().string());
  }
  std::sort(files.begin(), files.end());
  std::vector<PlacedDrawing> drawings;
  for (const std::string& file : files) {
    PlacedDrawing drawing = toDrawing(Json::parse(strokes::readText(file)));
    if (!drawing.points.empty()) drawings.push_back(std::move(drawing));
  }
  return drawings;
}

std::vector<QualityRow> placedJoints() { return tally().rows(); }

void missedJoints() {
  const Tally all = tally();
  for (const Miss& miss : all.misses()) {
    const std::string off = miss.off > 0 && miss.off < kNever ? ": " + percent(miss.off) : "";
    std::fprintf(stderr, "%s: %s%s\n", miss.drawing.c_str(), miss.what.c_str(), off.c_str());
  }
  printQuality(all.rows());
}

}  // namespace marrow::bench
