#include "rig/refine.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "document/joint_id.h"
#include "rig/connect.h"
#include "rig/joined.h"
#include "rig/names.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = JoinedSkeleton::kNone;
constexpr double kAlways = std::numeric_limits<double>::infinity();

double sane(double threshold) {
  return threshold > 0 ? std::min(threshold, Refinement::kLargest) : 0;
}
double chosen(const std::optional<double>& part, const std::optional<double>& model,
              double otherwise) {
  return sane(part ? *part : model ? *model : otherwise);
}

class Refining {
 public:
  Refining(const std::vector<RigPart>& parts, const std::vector<Connection>& connections,
           const Refinement& model)
      : parts_(parts),
        connections_(connections),
        model_(model),
        joined_(joinSkeletons(parts, connections)),
        plane_scales_(planeScales()),
        names_(parts, joined_, defaultEpsilons()) {}

  Rig run() {
    setThresholds();
    addJoints();
    placeClusters();
    setBonesAndKinds();
    carryTheRest();
    for (const Connection& connection : connections_) {
      if (joined_.parts[connection.child].skeleton) rig_.connections.push_back(connection);
    }
    return std::move(rig_);
  }

 private:
  using Node = JoinedSkeleton::Node;
  using Way = JoinedSkeleton::Way;

  struct Thresholds {
    double merge, prune, collapse;  // world
  };
  /// A place in the part with its ball.
  struct Ball {
    Vec3 point;
    double radius;  // of the plane
  };
  /// What may become a joint on a way, between its ends.
  struct Candidate {
    double at;      // distance from the way's start
    double level;   // of the sample
    uint32_t node;  // or kNone
    uint32_t part, branch, sample;
  };
  /// What was taken into one joint.
  struct Cluster {
    Vec3 position;
    double radius = 0;
    uint32_t count = 0;
  };

  /// By part: the scale of the outline of the part that holds all others of its tree, in its own
  /// plane. (Whichever of them the user made the root: that is to change no joint.)
  std::vector<double> planeScales() const {
    std::vector<uint32_t> holder(parts_.size(), kNone);
    for (const Connection& connection : connections_) {
      if (joined_.parts[connection.child].skeleton) holder[connection.child] = connection.parent;
    }
    std::vector<double> scales(parts_.size());
    for (uint32_t i = 0; i < parts_.size(); ++i) {
      if (!joined_.parts[i].skeleton) continue;
      uint32_t top = i;
      while (holder[top] != kNone) top = holder[top];
      scales[i] =
          parts_[top].part->outline.scale() * joined_.parts[top].scale / joined_.parts[i].scale;
    }
    return scales;
  }
  std::vector<double> defaultEpsilons() const {
    std::vector<double> epsilons = plane_scales_;
    for (double& epsilon : epsilons) epsilon *= Refinement::kSimplify;
    return epsilons;
  }

  void setThresholds() {
    std::vector<double> scales;
    for (const uint32_t root : joined_.roots) {
      const uint32_t part = joined_.nodes[root].part;
      scales.push_back(parts_[part].part->outline.scale() * joined_.parts[part].scale);
    }
    thresholds_.resize(parts_.size());
    epsilons_.resize(parts_.size());
    for (size_t i = 0; i < parts_.size(); ++i) {
      if (!joined_.parts[i].skeleton) continue;
      const PartSource& source = *parts_[i].source;
      const Refinement& own = source.refine;
      const double scale = scales[joined_.parts[i].tree];
      thresholds_[i] = {chosen(own.merge, model_.merge, Refinement::kMerge) * scale,
                        chosen(own.prune, model_.prune, Refinement::kPrune) * scale,
                        chosen(own.collapse, model_.collapse, Refinement::kCollapse) * scale};
      epsilons_[i] = chosen(own.simplify, model_.simplify, Refinement::kSimplify);
    }
  }

  /// ε_s of a branch in its part's plane.
  double epsilon(uint32_t part, uint32_t branch) const {
    double value = epsilons_[part];
    const auto& branches = parts_[part].source->branches;
    if (!branches.empty()) {
      const auto found = branches.find(branchKey(branch));
      if (found != branches.end()) value = sane(found->second);
    }
    return value * plane_scales_[part];
  }

  const Thresholds& thresholdsOf(const Way& way) const {
    return thresholds_[joined_.nodes[endOf(way)].part];
  }
  uint32_t endOf(const Way& way) const { return joined_.order[way.end - 1]; }

  bool isPruned(const Way& way) const {
    return !way.keeps && !joined_.isInner(endOf(way)) && isJunction(way.start) &&
           way.length < thresholdsOf(way).prune;
  }
  bool isJunction(uint32_t node) const { return joined_.nodes[node].degree > 2; }

  void addJoints() {
    joint_of_.assign(joined_.nodes.size(), -1);
    for (const RigPart& part : parts_) ids_.push_back(quotedPart(part.placed->id));
    rig_.joints.reserve(2 * joined_.nodes.size());
    clusters_.reserve(2 * joined_.nodes.size());
    size_t way = 0;
    for (const uint32_t root : joined_.roots) {
      rig_.roots.push_back(static_cast<uint32_t>(rig_.joints.size()));
      addNode(root, -1);
      const uint32_t tree = joined_.parts[joined_.nodes[root].part].tree;
      for (; way < joined_.ways.size(); ++way) {
        const Way& next = joined_.ways[way];
        if (joined_.parts[joined_.nodes[next.start].part].tree != tree) break;
        if (!isPruned(next)) addWay(next);
      }
    }
  }

  void addWay(const Way& way) {
    const uint32_t end = endOf(way);
    const Thresholds& limit = thresholdsOf(way);
    const bool merges =
        isJunction(way.start) && isJunction(end) && !way.keeps && way.length < limit.merge;
    const bool collapses = joined_.isInner(way.start) && joined_.isInner(end) && !way.keeps &&
                           way.length < limit.collapse;
    if (merges || collapses) {
      joint_of_[end] = joint_of_[way.start];
      takeIn(end);
      return;
    }
    int32_t last = joint_of_[way.start];
    collectCandidates(way);
    dropCrowded(way, limit.collapse);
    for (const Candidate& candidate : candidates_) {
      last = candidate.node != kNone ? addNode(candidate.node, last) : addSample(candidate, last);
    }
    addNode(end, last);
  }

  void collectCandidates(const Way& way) {
    candidates_.clear();
    double before = 0;
    for (uint32_t i = way.first; i < way.end; ++i) {
      const uint32_t id = joined_.order[i];
      const Node& node = joined_.nodes[id];
      const auto& edge = joined_.edges[node.edge];
      if (edge.branch != kNone) addSamples(node.part, edge, edge.b == node.parent, before);
      before += edge.length;
      if (i + 1 < way.end) candidates_.push_back({before, kAlways, id, node.part, 0, 0});
    }
  }

  void addSamples(uint32_t part, const JoinedSkeleton::Edge& edge, bool backwards, double before) {
    const auto& branch = joined_.parts[part].skeleton->branches[edge.branch];
    const double epsilon_s = epsilon(part, edge.branch), scale = joined_.parts[part].scale;
    const double start = alongAt(branch, backwards ? edge.u_b : edge.u_a);
    const size_t first = candidates_.size();
    for (uint32_t k = static_cast<uint32_t>(edge.u_a) + 1; k < edge.u_b; ++k) {
      if (!isKept(branch.levels[k], epsilon_s)) continue;
      const double at = before + std::abs(branch.samples[k].along - start) * scale;
      candidates_.push_back({at, branch.levels[k], kNone, part, edge.branch, k});
    }
    if (backwards) std::reverse(candidates_.begin() + static_cast<long>(first), candidates_.end());
  }

  /// Whether it is a sample without which a bone would leave the body.
  static bool isNeeded(const Candidate& candidate) {
    return candidate.node == kNone && candidate.level == kAlways;
  }

  /// Leaves what is at least `room` away from inner ends of the way, and from all candidates that
  /// matter more: nodes before samples, and samples that stay longer under growing ε_s; and what
  /// bones need to stay inside. Whether these are themselves dropped makes no difference, so that
  /// neither more room nor fewer candidates ever leaves more of them.
  void dropCrowded(const Way& way, double room) {
    const size_t count = candidates_.size();
    crowded_.assign(count, false);
    double last_node = joined_.isInner(way.start) ? 0 : -kAlways;
    const double end = joined_.isInner(endOf(way)) ? way.length : kAlways;
    // Forwards and backwards, what is more important than the samples from there on.
    stack_.clear();
    for (size_t i = 0; i < count; ++i) {
      const Candidate& candidate = candidates_[i];
      const bool is_node = candidate.node != kNone;
      while (!stack_.empty() && !is_node && stack_.back().second < candidate.level) {
        stack_.pop_back();
      }
      const double nearest = is_node || stack_.empty() ? last_node : stack_.back().first;
      crowded_[i] =
          !isNeeded(candidate) && (candidate.at - nearest < room || end - candidate.at < room);
      if (is_node) {
        stack_.clear();
        last_node = candidate.at;
      } else {
        stack_.push_back({candidate.at, candidate.level});
      }
    }
    stack_.clear();
    double next_node = kAlways;
    for (size_t i = count; i-- > 0;) {
      const Candidate& candidate = candidates_[i];
      if (candidate.node != kNone) {
        stack_.clear();
        next_node = candidate.at;
        continue;
      }
      while (!stack_.empty() && stack_.back().second <= candidate.level) stack_.pop_back();
      const double nearest = stack_.empty() ? next_node : stack_.back().first;
      if (nearest - candidate.at < room && !isNeeded(candidate)) crowded_[i] = true;
      stack_.push_back({candidate.at, candidate.level});
    }
    size_t kept = 0;
    for (size_t i = 0; i < count; ++i) {
      if (!crowded_[i]) candidates_[kept++] = candidates_[i];
    }
    candidates_.resize(kept);
  }

  int32_t addJoint(std::string id, std::string name, uint32_t part, uint32_t branch,
                   int32_t parent) {
    Rig::Joint joint;
    joint.id = std::move(id);
    joint.name = std::move(name);
    joint.part = part;
    joint.branch = branch;
    joint.parent = parent;
    rig_.joints.push_back(std::move(joint));
    clusters_.emplace_back();
    return static_cast<int32_t>(rig_.joints.size() - 1);
  }

  int32_t addNode(uint32_t node, int32_t parent) {
    const Node& at = joined_.nodes[node];
    std::string id = ids_[at.part];
    if (at.branch == kNone) {
      id += "/n" + std::to_string(at.joint);
    } else if (at.hangs_by) {
      id += "/h";
    } else {
      id += "/a:" + ids_[at.hangs];
    }
    joint_of_[node] =
        addJoint(std::move(id), names_.ofNode(node), at.part, names_.branchOf(node), parent);
    takeIn(node);
    return joint_of_[node];
  }

  int32_t addSample(const Candidate& at, int32_t parent) {
    std::string id = ids_[at.part];
    id += '/' + branchKey(at.branch) + '.' + std::to_string(at.sample);
    const int32_t joint = addJoint(std::move(id), names_.ofSample(at.part, at.branch, at.sample),
                                   at.part, at.branch, parent);
    takeIn(joint, at.part, ballAt(at.part, at.branch, at.sample));
    return joint;
  }

  void takeIn(uint32_t node) {
    const Node& at = joined_.nodes[node];
    if (at.branch != kNone) {
      takeIn(joint_of_[node], at.part, ballOn(at.part, at.branch, at.u));
    } else {
      const auto& joint = joined_.parts[at.part].skeleton->joints[at.joint];
      takeIn(joint_of_[node], at.part, {joint.place(), joint.radius});
    }
  }
  void takeIn(int32_t joint, uint32_t part, const Ball& ball) {
    Cluster& cluster = clusters_[static_cast<size_t>(joint)];
    cluster.position = cluster.position + parts_[part].placed->frame.toWorld(ball.point);
    cluster.radius += ball.radius * joined_.parts[part].scale;
    ++cluster.count;
  }

  void placeClusters() {
    for (size_t i = 0; i < rig_.joints.size(); ++i) {
      const Cluster& cluster = clusters_[i];
      rig_.joints[i].position = cluster.position / cluster.count;
      rig_.joints[i].radius = cluster.radius / cluster.count;
    }
  }

  /// At a sample: the inscribed radius, as much larger than it as at the part's joints around it.
  Ball ballAt(uint32_t part, uint32_t branch, uint32_t sample) const {
    const PartSkeleton& skeleton = *joined_.parts[part].skeleton;
    const auto& shape = skeleton.branches[branch];
    const auto next = std::lower_bound(shape.at.begin(), shape.at.end(), sample);
    const size_t k = static_cast<size_t>(next - shape.at.begin());
    const BranchSample& own = shape.samples[sample];
    const Vec3 point{own.point.x, own.point.y, own.depth};
    if (*next == sample) return {point, skeleton.joints[shape.joints[k]].radius};
    const auto ratio = [&](size_t joint) {
      const double inscribed = shape.samples[shape.at[joint]].radius;
      return inscribed > 0 ? skeleton.joints[shape.joints[joint]].radius / inscribed : 1;
    };
    const double t = (sample - static_cast<double>(shape.at[k - 1])) /
                     (static_cast<double>(shape.at[k]) - shape.at[k - 1]);
    const double from = ratio(k - 1);
    return {point, own.radius * (from + (ratio(k) - from) * t)};
  }

  /// On the bone of the part's own skeleton, where the connection is: it stays there whatever ε_s.
  Ball ballOn(uint32_t part, uint32_t branch, double u) const {
    const auto& shape = joined_.parts[part].skeleton->branches[branch];
    size_t k = 1;
    while (k + 1 < shape.at.size() && shape.at[k] <= u) ++k;
    const uint32_t low = shape.at[k - 1], high = shape.at[k];
    const Ball a = ballAt(part, branch, low), b = ballAt(part, branch, high);
    const double t = (u - low) / (high - static_cast<double>(low));
    return {lerp(a.point, b.point, t), a.radius + (b.radius - a.radius) * t};
  }

  void setBonesAndKinds() {
    std::vector<uint32_t> degrees(rig_.joints.size());
    for (uint32_t i = 0; i < rig_.joints.size(); ++i) {
      if (rig_.joints[i].parent < 0) continue;
      const uint32_t parent = static_cast<uint32_t>(rig_.joints[i].parent);
      rig_.bones.push_back({parent, i});
      ++degrees[parent];
      ++degrees[i];
    }
    for (size_t i = 0; i < degrees.size(); ++i) {
      rig_.joints[i].kind = degrees[i] < 2    ? JointKind::terminal
                            : degrees[i] == 2 ? JointKind::sleeve
                                              : JointKind::junction;
    }
  }

  void carryTheRest() {
    for (uint32_t i = 0; i < parts_.size(); ++i) {
      if (joined_.parts[i].skeleton || !parts_[i].part) continue;
      const auto held = std::find_if(connections_.begin(), connections_.end(),
                                     [&](const Connection& c) { return c.child == i; });
      rig_.carried.push_back({i, held == connections_.end() ? -1 : carrier(*held)});
    }
  }

  /// The end of the bone nearest to where the part hangs, among those of the part that holds it.
  int32_t carrier(const Connection& held) const {
    int32_t best = -1;
    double nearest = kAlways;
    for (size_t i = 0; i < rig_.joints.size(); ++i) {
      const Rig::Joint& joint = rig_.joints[i];
      if (joint.part != held.parent) continue;
      const Vec3 from = joint.parent < 0 ? joint.position
                                         : rig_.joints[static_cast<size_t>(joint.parent)].position;
      const Vec3 along = joint.position - from, to = held.parent_position - from;
      const double whole = dot(along, along);
      const double t = whole > 0 ? std::clamp(dot(to, along) / whole, 0.0, 1.0) : 0;
      const double d = length(to - along * t);
      // A bone of its own rather than the root that it begins at.
      const bool begins_there = best >= 0 && joint.parent == best && d <= nearest;
      if (!(d < nearest || begins_there)) continue;
      best = static_cast<int32_t>(i);
      nearest = d;
    }
    // None is left of it: what became of the place where its bones begin.
    uint32_t node = joined_.parts[held.parent].entry;
    while (best < 0) {
      best = joint_of_[node];
      node = joined_.nodes[node].parent;
    }
    return best;
  }

  const std::vector<RigPart>& parts_;
  const std::vector<Connection>& connections_;
  const Refinement& model_;
  const JoinedSkeleton joined_;
  const std::vector<double> plane_scales_;  // by part, what ε_s is multiplied by
  const JointNames names_;
  std::vector<Thresholds> thresholds_;  // by part
  std::vector<double> epsilons_;        // by part, at the reference perimeter
  std::vector<std::string> ids_;        // by part
  std::vector<int32_t> joint_of_;       // by node: of the rig, −1 where it is no end of a way
  std::vector<Candidate> candidates_;
  std::vector<char> crowded_;
  std::vector<std::pair<double, double>> stack_;  // place and level
  std::vector<Cluster> clusters_;                 // by joint
  Rig rig_;
};

}  // namespace

std::string branchKey(uint32_t branch) { return 'b' + std::to_string(branch); }

Rig refineRig(const std::vector<RigPart>& parts, const std::vector<Connection>& connections,
              const Refinement& model) {
  return Refining(parts, connections, model).run();
}

Rig makeRig(const std::vector<RigPart>& parts, const Refinement& model) {
  return refineRig(parts, connectParts(parts), model);
}

}  // namespace marrow
