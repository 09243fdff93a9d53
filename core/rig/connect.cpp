#include "rig/connect.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <unordered_map>
#include <utility>

#include "rig/attach_place.h"

namespace marrow {
namespace {

constexpr uint32_t kNone = 0xFFFFFFFF;
constexpr double kFar = std::numeric_limits<double>::infinity();
// What differs by less than this part of its scale is equal: rounding must not decide who holds a
// part, or the twins of a symmetric creature would part company.
constexpr double kTie = 1e-9;
// By this share of the smaller radius.
constexpr double kPlainlyAway = 1;
// Of two that could hold a child, what a share of the smaller volume in common counts for against
// depth relative to the radius.
constexpr double kShareWeight = 0.5;
// A body is as many times as large as the limbs that were drawn before it; less will do for what is
// as many times as long as thick. A single one is taken for a limb only where it is far smaller: a
// neck that was drawn before the head holds that.
constexpr double kPlainlyLarger = 4, kLargerThanSlender = 1.5, kSlender = 2.5, kFarLarger = 12;

/// How long a part is against its thickness.
double slendernessOf(const RigPart& part) {
  double length = 0, radius = 0;
  for (const auto& branch : part.part->skeleton.branches) {
    length = std::max(length, branch.length());
    for (const BranchSample& sample : branch.samples) radius = std::max(radius, sample.radius);
  }
  return radius > 0 ? length / (2 * radius) + 1 : 1;
}

class Connecting {
 public:
  Connecting(const std::vector<RigPart>& parts, const ConnectOptions& options)
      : parts_(parts), options_(options) {
    const size_t count = parts.size();
    proxies_.reserve(count);
    for (const RigPart& part : parts) proxies_.push_back(proxyOf(part));
    parent_.assign(count, kNone);
    free_.resize(count);
    image_.assign(count, kNone);
    bodies_.resize(count);
    boxes_.resize(count);
    slenderness_.assign(count, 1);
    tree_volume_.assign(count, 0);
    is_body_.assign(count, false);
    for (uint32_t i = 0; i < count; ++i) {
      free_[i] = proxies_[i].exists;
      if (proxies_[i].exists) {
        bodies_[i].emplace(parts[i]);
        boxes_[i] = bodies_[i]->box();
        slenderness_[i] = slendernessOf(parts[i]);
        tree_volume_[i] = bodies_[i]->volume();
      }
      if (i == 0 || parts[i].source != parts[i - 1].source) continue;
      if (parts[i].placed->twin == parts[i - 1].placed->twin) continue;
      image_[i] = i - 1;
      image_[i - 1] = i;
    }
  }

  std::vector<Connection> run() {
    const uint32_t count = static_cast<uint32_t>(parts_.size());
    for (uint32_t i = 0; i < count; ++i) {
      if (proxies_[i].exists && parts_[i].source->attachment) attachAsTold(i);
    }
    for (uint32_t i = 0; i < count; ++i) {
      if (free_[i]) attachToEarlier(i);
    }
    attachLikeImages();
    while (joinTrees(Join::limbs)) {
    }
    attachLikeImages();
    for (uint32_t i = 0; i < count; ++i) {
      const uint32_t image = image_[i];
      if (free_[i] && image < i && free_[image] && canHold(image, i) && meets(i, image)) {
        attachTo(i, image);
      }
    }
    for (const Join how : {Join::later, Join::any}) {
      while (joinTrees(how)) {
      }
    }
    while (attachSurfaces()) {
    }
    std::sort(result_.begin(), result_.end(),
              [](const Connection& a, const Connection& b) { return a.child < b.child; });
    return std::move(result_);
  }

 private:
  uint32_t treeOf(uint32_t part) const {
    while (parent_[part] != kNone) part = parent_[part];
    return part;
  }
  bool canHold(uint32_t parent, uint32_t child) const {
    return proxies_[parent].holds && treeOf(parent) != child;
  }

  bool isTakenOff(uint32_t part) const {
    const auto& told = parts_[part].source->attachment;
    return told && told->part.empty();
  }

  void attachAsTold(uint32_t child) {
    if (isTakenOff(child)) {
      free_[child] = false;
      return;
    }
    const Attachment& told = *parts_[child].source->attachment;
    uint32_t parent = kNone;
    for (uint32_t i = 0; i < parts_.size() && parent == kNone; ++i) {
      if (parts_[i].placed->id == told.part) parent = i;
    }
    if (parent == kNone || !proxies_[parent].holds) return;
    const bool twin = parts_[child].placed->twin;
    const bool swap = twin && image_[parent] != kNone;
    if (swap) parent = image_[parent];
    if (!canHold(parent, child)) return;
    Vec3 at = parts_[parent].placed->frame.toWorld(told.at);
    if (twin && !swap && parts_[child].source->mirror) {
      at = mirrored(at, *parts_[child].source->mirror);
    }
    Connection connection;
    connection.child = child;
    connection.parent = parent;
    connection.test = AttachTest::user;
    placeOnParent(proxies_[parent], at, connection);
    placeOnChild(proxies_[child], connection.parent_position, connection);
    add(connection);
  }

  /// What is known of two parts whose boxes meet.
  struct Pair {
    double depth = -1;  // of bones of one of them in the other's balls; −1: or less
    double share = -1;  // of the smaller one's volume that they have in common; below 0: not asked
  };
  Pair& pairOf(uint32_t one, uint32_t other) {
    const uint64_t key = uint64_t{std::min(one, other)} * parts_.size() + std::max(one, other);
    const auto [found, is_new] = pairs_.try_emplace(key);
    if (is_new) found->second.depth = std::max(-1.0, depthOf(proxies_[one], proxies_[other]));
    return found->second;
  }
  double shareOf(Pair& pair, uint32_t one, uint32_t other) {
    if (pair.share < 0) pair.share = sharedVolume(*bodies_[one], *bodies_[other]);
    return pair.share;
  }
  bool mayMeet(uint32_t one, uint32_t other) const { return boxes_[one].meets(boxes_[other]); }
  bool meets(uint32_t child, uint32_t other) {
    if (!mayMeet(child, other)) return false;
    const double share = shareOf(pairOf(child, other), child, other);
    if (share > options_.share) return true;
    // What has no bones of its own, as a nose, is put on a surface: there little is in common.
    if (share > 0 && proxies_[child].holds != proxies_[other].holds) return true;
    return share > 0 && (hasEndIn(child, other) ||
                         ballOverlap(proxies_[child], proxies_[other]) > options_.overlap);
  }
  /// How well one could hold the other: more is better. Of parts that meet.
  double score(uint32_t child, uint32_t other) {
    Pair& pair = pairOf(child, other);
    return pair.depth + kShareWeight * shareOf(pair, child, other);
  }

  bool hasEndIn(uint32_t child, uint32_t other) const {
    const PartProxy& proxy = proxies_[child];
    for (size_t j = 0; j < proxy.points.size(); ++j) {
      if (!proxy.isEnd(j) || !proxies_[other].box.has(proxy.points[j])) continue;
      if (penetration(proxies_[other], proxy.points[j]) > kTie) return true;
    }
    return false;
  }

  /// How many times as large as the tree of `limb` a body is that could hold it as a limb; 0 where
  /// it could not.
  double timesLarger(uint32_t limb, uint32_t body) const {
    const uint32_t tree = treeOf(limb);
    if (!proxies_[body].holds || !free_[tree]) return 0;
    const double times = bodies_[body]->volume() / tree_volume_[tree];
    if (times > kPlainlyLarger) return times;
    return times > kLargerThanSlender && slenderness_[limb] > kSlender ? times : 0;
  }
  bool isLimbOf(uint32_t limb, uint32_t body) const {
    return is_body_[body] && timesLarger(limb, body) > 0;
  }

  /// Whether the limbs of a part were drawn before it.
  bool hasEarlierLimbs(uint32_t body) {
    limbs_.clear();
    for (uint32_t i = 0; i < body; ++i) {
      if (!proxies_[i].holds || !mayMeet(body, i) || i == image_[body]) continue;
      const double times = timesLarger(i, body);
      const uint32_t tree = treeOf(i);
      if (!(times > 0) || std::count(limbs_.begin(), limbs_.end(), tree) || !meets(i, body))
        continue;
      if (times > kFarLarger) return true;
      limbs_.push_back(tree);
    }
    return limbs_.size() > 1;
  }

  /// What could hold a part.
  struct Candidate {
    uint32_t part;   // none where it cannot
    double at_most;  // its score; −∞ once that is known
    double score;
  };

  /// Calls visit with all parts, the mirror image of each pair that the child's own image prefers
  /// first, so that what is a tie for both goes to either side.
  template <typename Visit>
  void forOthers(uint32_t child, uint32_t end, const Visit& visit) const {
    const bool swap = parts_[child].placed->twin;
    for (uint32_t i = 0; i < end; ++i) {
      uint32_t other = i;
      if (swap && image_[i] != kNone && image_[i] < end) other = image_[i];
      if (proxies_[other].exists && other != child && other != image_[child]) visit(other);
    }
  }

  void attachToEarlier(uint32_t child) {
    is_body_[child] = hasEarlierLimbs(child);
    candidates_.clear();
    forOthers(child, child, [&](uint32_t other) {
      if (!mayMeet(child, other) || !canHold(other, child)) return;
      candidates_.push_back({other, pairOf(child, other).depth + kShareWeight, -kFar});
    });
    // Most are too bad whatever they share; how much that is takes long.
    double best = -kFar;
    while (true) {
      Candidate* next = nullptr;
      for (Candidate& candidate : candidates_) {
        if (!next || candidate.at_most > next->at_most) next = &candidate;
      }
      if (!next || next->at_most < best - 2 * kTie) break;
      if (next->at_most == -kFar) break;
      next->at_most = -kFar;
      if (!meets(child, next->part) || isLimbOf(next->part, child)) {
        next->part = kNone;
        continue;
      }
      next->score = score(child, next->part);
      best = std::max(best, next->score);
    }
    const auto first =
        std::find_if(candidates_.begin(), candidates_.end(),
                     [&](const Candidate& c) { return c.part != kNone && c.score >= best - kTie; });
    if (best > -kFar && first != candidates_.end()) attachTo(child, first->part);
  }

  /// Which trees are hung on others that their parts meet.
  enum class Join {
    limbs,  // what is plainly smaller than the part that it meets
    later,  // that, and what was drawn later than the other tree's root
    any
  };
  /// Whether any was hung.
  bool joinTrees(Join how) {
    bool any = false;
    for (uint32_t root = 0; root < parts_.size(); ++root) {
      if (free_[root]) any = joinTree(root, how) || any;
    }
    return any;
  }

  bool joinTree(uint32_t root, Join how) {
    uint32_t best_part = kNone, parent = kNone;
    double best = -kFar;
    for (uint32_t part = 0; part < parts_.size(); ++part) {
      if (!proxies_[part].exists || treeOf(part) != root || !canBecomeRoot(part)) continue;
      forOthers(part, static_cast<uint32_t>(parts_.size()), [&](uint32_t other) {
        if (!proxies_[other].holds || !mayMeet(part, other)) return;
        const uint32_t tree = treeOf(other);
        if (tree == root || !meets(part, other)) return;
        if (!(score(part, other) > best + kTie)) return;
        // What the user took off is not to be taken back from the other side.
        if (isTakenOff(tree) && (tree > root || isLimbOf(other, part))) return;
        if (how != Join::any && !isLimbOf(part, other)) {
          if (how == Join::limbs || (tree > root && free_[tree]) || isLimbOf(other, part)) return;
        }
        best = score(part, other);
        best_part = part;
        parent = other;
      });
    }
    if (parent == kNone) return false;
    makeRoot(best_part);
    attachTo(best_part, parent);
    return true;
  }

  Connection* connectionOf(uint32_t child) {
    const auto found =
        std::find_if(result_.begin(), result_.end(),
                     [&](const Connection& connection) { return connection.child == child; });
    return found == result_.end() ? nullptr : &*found;
  }

  /// Whether its tree can be turned round so that it hangs on this part.
  bool canBecomeRoot(uint32_t part) {
    if (parent_[part] == kNone) return free_[part];
    for (; parent_[part] != kNone; part = parent_[part]) {
      if (connectionOf(part)->test == AttachTest::user) return false;
    }
    return true;
  }

  void makeRoot(uint32_t part) {
    tree_volume_[part] = tree_volume_[treeOf(part)];
    std::vector<Connection*> turned;
    for (uint32_t child = part; parent_[child] != kNone; child = parent_[child]) {
      turned.push_back(connectionOf(child));
    }
    for (Connection* connection : turned) {
      std::swap(connection->child, connection->parent);
      parent_[connection->child] = connection->parent;
      free_[connection->child] = false;
      place(*connection);
    }
    parent_[part] = kNone;
    free_[part] = true;
  }

  void attachTo(uint32_t child, uint32_t parent) {
    Connection connection;
    connection.child = child;
    connection.parent = parent;
    place(connection);
    add(connection);
  }

  void place(Connection& connection) {
    const uint32_t child = connection.child, parent = connection.parent;
    connection.test = hasEndIn(child, parent) ? AttachTest::joint : AttachTest::overlap;
    placeAtOverlap({proxies_[child], *bodies_[child]}, {proxies_[parent], *bodies_[parent]},
                   connection);
  }

  /// What has no bones and lies on what has none either, as a pupil on an eye, hangs where that
  /// hangs. Whether any was hung.
  bool attachSurfaces() {
    bool any = false;
    for (uint32_t child = 0; child < parts_.size(); ++child) {
      if (!free_[child] || proxies_[child].holds || isTakenOff(child)) continue;
      double best = 0;
      std::optional<Connection> below;
      forOthers(child, static_cast<uint32_t>(parts_.size()), [&](uint32_t other) {
        if (proxies_[other].holds || !mayMeet(child, other)) return;
        const Connection* held = connectionOf(other);
        if (!held) return;
        const double share = shareOf(pairOf(child, other), child, other);
        if (!(share > best + kTie)) return;
        best = share;
        below = *held;
      });
      if (!below) continue;
      Connection connection;
      connection.child = child;
      connection.parent = below->parent;
      connection.test = AttachTest::overlap;
      placeOnParent(proxies_[connection.parent], below->parent_position, connection);
      placeOnChild(proxies_[child], connection.parent_position, connection);
      add(connection);
      any = true;
    }
    return any;
  }

  /// Where a part lies just on the verge, rounding must not tell it from its twin.
  void attachLikeImages() {
    for (uint32_t i = 0; i < parts_.size(); ++i) {
      if (free_[i] && image_[i] != kNone && !free_[image_[i]]) attachLikeImage(i);
    }
  }

  void attachLikeImage(uint32_t child) {
    const Connection* found = connectionOf(image_[child]);
    if (!found || found->test == AttachTest::user) return;
    const uint32_t mirrored_parent = image_[found->parent];
    const uint32_t parent = mirrored_parent == kNone ? found->parent : mirrored_parent;
    if (parent == child || !canHold(parent, child)) return;
    if (!(ballOverlap(proxies_[child], proxies_[parent]) > -kPlainlyAway)) return;
    attachTo(child, parent);
  }

  void add(const Connection& connection) {
    // What has no bones of its own holds nothing, so it stays out of the trees.
    if (proxies_[connection.child].holds) {
      tree_volume_[treeOf(connection.parent)] += tree_volume_[connection.child];
      parent_[connection.child] = connection.parent;
    }
    free_[connection.child] = false;
    result_.push_back(connection);
  }

  const std::vector<RigPart>& parts_;
  const ConnectOptions& options_;
  std::vector<PartProxy> proxies_;
  std::vector<std::optional<PartBody>> bodies_;    // of those that have a proxy
  std::vector<Box3> boxes_;                        // of the bodies
  std::vector<double> slenderness_, tree_volume_;  // of parts, of their roots
  std::vector<char> is_body_;                      // whose limbs were drawn before it
  std::vector<uint32_t> limbs_;
  std::unordered_map<uint64_t, Pair> pairs_;  // by both parts; what was asked for
  std::vector<Candidate> candidates_;
  std::vector<uint32_t> parent_;  // of the trees so far
  std::vector<uint32_t> image_;   // the other one of a part and its twin
  std::vector<char> free_;        // may still be attached
  std::vector<Connection> result_;
};

}  // namespace

std::vector<Connection> connectParts(const std::vector<RigPart>& parts,
                                     const ConnectOptions& options) {
  return Connecting(parts, options).run();
}

}  // namespace marrow
