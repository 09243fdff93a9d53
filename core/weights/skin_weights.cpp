#include "weights/skin_weights.h"

#include <algorithm>
#include <cmath>

#include "base/box.h"

namespace marrow {
namespace {

constexpr double kLeast = 5e-4;  // weights below are not worth an influence

bool isFinite(Vec3 p) { return std::isfinite(p.x) && std::isfinite(p.y) && std::isfinite(p.z); }

double square(Vec3 v) { return dot(v, v); }

bool isBefore(const Influence& a, const Influence& b) {
  return a.weight != b.weight ? a.weight > b.weight : a.bone < b.bone;
}

/// The first ones, in order again: what was not quite equal may be so now.
void scaleToOne(Influences& influences, size_t count) {
  double sum = 0;
  for (size_t i = 0; i < count; ++i) sum += influences[i].weight;
  for (size_t i = 0; i < count; ++i) influences[i].weight /= sum;
  for (size_t i = 1; i < count; ++i) {
    for (size_t k = i; k > 0 && isBefore(influences[k], influences[k - 1]); --k) {
      std::swap(influences[k], influences[k - 1]);
    }
  }
}

/// Takes from the first ones what is not kept of them, the largest that goes being given, unless
/// nothing would be left; how many are left.
size_t fade(Influences& influences, size_t count, double gone) {
  if (count == 0 || !(shareKept(influences[0].weight, gone) > 0)) return count;
  size_t left = 0;
  for (size_t i = 0; i < count; ++i) {
    influences[i].weight *= shareKept(influences[i].weight, gone);
    if (influences[i].weight > 0) left = i + 1;
  }
  std::fill(influences.begin() + static_cast<std::ptrdiff_t>(left), influences.end(), Influence{});
  return left;
}

Influences only(uint32_t bone) {
  Influences influences{};
  influences[0] = {bone, 1};
  return influences;
}

/// The largest of many.
Influences largest(std::vector<Influence>& all) {
  double least = 0;
  for (const Influence& one : all) least = std::max(least, one.weight);
  least = std::min(least, kLeast);
  const auto isSmall = [&](const Influence& one) { return one.weight < least; };
  all.erase(std::remove_if(all.begin(), all.end(), isSmall), all.end());
  std::sort(all.begin(), all.end(), isBefore);
  Influences influences{};
  size_t count = 0;
  for (; count < all.size() && count < influences.size(); ++count) influences[count] = all[count];
  scaleToOne(influences, fade(influences, count, count < all.size() ? all[count].weight : 0));
  return influences;
}

/// Without triangles of vertices that are not there.
std::vector<Vec3> normalsOf(const Mesh& mesh) {
  const auto isBroken = [&](const std::array<uint32_t, 3>& triangle) {
    return *std::max_element(triangle.begin(), triangle.end()) >= mesh.positions.size();
  };
  if (std::none_of(mesh.triangles.begin(), mesh.triangles.end(), isBroken)) {
    return vertexNormals(mesh);
  }
  Mesh sound = mesh;
  sound.triangles.erase(std::remove_if(sound.triangles.begin(), sound.triangles.end(), isBroken),
                        sound.triangles.end());
  return vertexNormals(sound);
}

/// Per bone the one that is its mirror image, to a hundredth of the size of all; no bone's number
/// where none is, or several are.
std::vector<uint32_t> mirrorImages(const std::vector<Segment>& bones, const Plane& plane) {
  Box3 box;
  for (const auto& [a, b] : bones) {
    if (isFinite(a)) box.include(a);
    if (isFinite(b)) box.include(b);
  }
  const double near = box.isEmpty() ? 0 : 0.01 * distance(box.low, box.high);
  const uint32_t count = static_cast<uint32_t>(bones.size());
  std::vector<uint32_t> images(count, count);
  for (uint32_t bone = 0; bone < count; ++bone) {
    const Vec3 a = mirrored(bones[bone][0], plane), b = mirrored(bones[bone][1], plane);
    double best = HUGE_VAL;
    for (uint32_t other = 0; other < count; ++other) {
      const auto& [c, d] = bones[other];
      const double off = std::min(std::max(distance(c, a), distance(d, b)),
                                  std::max(distance(c, b), distance(d, a)));
      if (!(off <= near && off < best)) continue;
      best = off;
      images[bone] = other;
    }
  }
  std::vector<uint32_t> mutual = images;
  for (uint32_t bone = 0; bone < count; ++bone) {
    if (images[bone] < count && images[images[bone]] != bone) mutual[bone] = count;
  }
  return mutual;
}

uint32_t nearestBone(const std::vector<Segment>& bones, Vec3 point) {
  uint32_t nearest = 0;
  double best = HUGE_VAL;
  for (uint32_t bone = 0; bone < bones.size(); ++bone) {
    const double d = distanceTo(bones[bone], point);
    if (!(d < best)) continue;
    best = d;
    nearest = bone;
  }
  return nearest;
}

}  // namespace

/// Weights of bones, to be summed up in any order.
class WeightSums {
 public:
  explicit WeightSums(size_t bones) : sums_(bones, 0), seen_(bones, 0) {}

  void add(uint32_t bone, double weight) {
    if (!seen_[bone]) bones_.push_back(bone);
    seen_[bone] = 1;
    sums_[bone] += weight;
  }
  /// All that were added, and begins anew.
  void take(std::vector<Influence>& weights) {
    weights.clear();
    for (const uint32_t bone : bones_) {
      weights.push_back({bone, sums_[bone]});
      sums_[bone] = 0;
      seen_[bone] = 0;
    }
    bones_.clear();
  }

 private:
  std::vector<double> sums_;
  std::vector<uint8_t> seen_;
  std::vector<uint32_t> bones_;
};

double shareKept(double weight, double largest_gone) {
  constexpr double kMore = 0.5;
  if (!(weight < (1 + kMore) * largest_gone)) return 1;
  return std::max(0.0, (weight - largest_gone) / (kMore * largest_gone));
}

Influences limited(const Influences& influences, size_t most) {
  Influences few{};
  size_t count = std::min(std::max<size_t>(most, 1), influences.size());
  while (count > 0 && influences[count - 1].weight == 0) --count;
  std::copy_n(influences.begin(), count, few.begin());
  const double gone = count < influences.size() ? influences[count].weight : 0;
  scaleToOne(few, fade(few, count, gone));
  return few;
}

WeightOptions quickWeightOptions() {
  WeightOptions options;
  options.volume.target_vertices = 700;
  options.biharmonic.most_steps = 0;
  return options;
}

Result<WeightField> WeightField::make(const Mesh& body, const std::vector<Segment>& bones,
                                      const WeightOptions& options, const WeightProgress& progress,
                                      Clock clock) {
  WeightField field;
  Stopwatch watch(clock, field.timings_);
  const auto goOn = [&](double done) { return !progress || progress(done); };
  const Error stopped{Status::meshFailed, "The weights were given up."};

  auto volume = makeVolume(body, options.volume);
  if (!volume) return volume.error();
  field.volume_ = std::move(*volume);
  field.bone_count_ = bones.size();
  if (options.symmetry) {
    field.symmetry_ = options.symmetry;
    field.images_ = mirrorImages(bones, *options.symmetry);
  }
  watch.lap("volume");
  field.handles_ = makeHandles(field.volume_, bones);
  watch.lap("handles");
  constexpr double kBefore = 0.1;  // of all the time, till the first bone
  if (!goOn(kBefore / 2)) return stopped;

  BoundedBiharmonic solver(field.volume_, field.handles_, options.biharmonic);
  watch.lap("factorisation");
  std::vector<std::vector<double>> by_bone;
  for (uint32_t bone = 0; bone < bones.size(); ++bone) {
    const double done = static_cast<double>(bone) / static_cast<double>(bones.size());
    if (!goOn(kBefore + (1 - kBefore) * done)) return stopped;
    by_bone.push_back(solver.solve(bone));
  }
  field.normalise(by_bone);
  if (!bones.empty()) field.fillLoosePieces(bones);
  watch.lap("bones");
  return field;
}

void WeightField::normalise(const std::vector<std::vector<double>>& by_bone) {
  // With bounds nothing says that some bone reaches every place; where none does the nearest will.
  constexpr double kReached = 1e-3;
  std::vector<uint32_t> nearest;
  starts_.assign(1, 0);
  for (uint32_t v = 0; v < volume_.vertices.size(); ++v) {
    double sum = 0;
    for (const auto& weights : by_bone) sum += weights[v] >= kLeast ? weights[v] : 0;
    uint32_t from = v;
    if (sum < kReached && !handles_.vertices.empty()) {
      if (nearest.empty()) nearest = nearestHandles();
      if (nearest[v] != v) {
        from = nearest[v];
        sum = 1;
      }
    }
    for (uint32_t bone = 0; sum >= kReached && bone < by_bone.size(); ++bone) {
      if (by_bone[bone][from] >= kLeast) influences_.push_back({bone, by_bone[bone][from] / sum});
    }
    starts_.push_back(static_cast<uint32_t>(influences_.size()));
  }
}

/// Per vertex: the nearest handle of its piece; itself where that has none.
std::vector<uint32_t> WeightField::nearestHandles() const {
  std::vector<uint32_t> nearest(volume_.vertices.size());
  for (uint32_t v = 0; v < nearest.size(); ++v) {
    nearest[v] = v;
    double best = HUGE_VAL;
    for (const uint32_t handle : handles_.vertices) {
      const double d = square(volume_.vertices[handle] - volume_.vertices[v]);
      if (volume_.pieces[handle] != volume_.pieces[v] || !(d < best)) continue;
      best = d;
      nearest[v] = handle;
    }
  }
  return nearest;
}

/// A piece without a bone gets the same weights everywhere, those of the place nearest to it.
void WeightField::fillLoosePieces(const std::vector<Segment>& bones) {
  struct Nearest {
    double distance = HUGE_VAL;
    uint32_t from = 0, to = 0;
  };
  const uint32_t n = static_cast<uint32_t>(volume_.vertices.size());
  std::vector<uint8_t> held(volume_.piece_count, 0);
  for (const uint32_t v : handles_.vertices) held[volume_.pieces[v]] = 1;
  if (std::find(held.begin(), held.end(), 0) == held.end()) return;
  std::vector<Nearest> nearest(volume_.piece_count);
  for (uint32_t v = 0; v < n; ++v) {
    Nearest& best = nearest[volume_.pieces[v]];
    if (held[volume_.pieces[v]]) continue;
    if (best.distance == HUGE_VAL) best.from = v;
    for (uint32_t to = 0; to < n && !handles_.vertices.empty(); ++to) {
      const double d = square(volume_.vertices[to] - volume_.vertices[v]);
      if (held[volume_.pieces[to]] && d < best.distance) best = {d, v, to};
    }
  }
  std::vector<uint32_t> starts(1, 0);
  std::vector<Influence> influences;
  for (uint32_t v = 0; v < n; ++v) {
    const Nearest& best = nearest[volume_.pieces[v]];
    if (held[volume_.pieces[v]]) {
      influences.insert(influences.end(), begin(v), end(v));
    } else if (best.distance < HUGE_VAL) {
      influences.insert(influences.end(), begin(best.to), end(best.to));
    } else {
      influences.push_back({nearestBone(bones, volume_.vertices[best.from]), 1});
    }
    starts.push_back(static_cast<uint32_t>(influences.size()));
  }
  starts_ = std::move(starts);
  influences_ = std::move(influences);
}

uint32_t WeightField::nearestVertex(Vec3 point) const {
  uint32_t nearest = 0;
  for (uint32_t v = 1; v < volume_.vertices.size(); ++v) {
    if (square(volume_.vertices[v] - point) < square(volume_.vertices[nearest] - point)) {
      nearest = v;
    }
  }
  return nearest;
}

/// The mean with what the mirror image of a point has, as far as bones have mirror images.
void WeightField::addMirrored(Vec3 point, Vec3 inward, std::vector<Influence>& weights,
                              WeightSums& sums) const {
  constexpr int kReach = 1;  // voxels: farther from the body it is not its own mirror image
  const auto place =
      volume_.locate(mirrored(point, *symmetry_), mirrored(inward, *symmetry_), kReach);
  if (!place) return;
  const auto imageOf = [&](uint32_t bone) { return images_[bone]; };
  double paired = 0, lonely = 0;
  for (size_t corner = 0; corner < 8; ++corner) {
    const uint32_t vertex = volume_.cells[place->cell][corner];
    for (const Influence* one = begin(vertex); one != end(vertex); ++one) {
      (imageOf(one->bone) < bone_count_ ? paired : lonely) += place->shares[corner] * one->weight;
    }
  }
  for (const Influence& one : weights) {
    if (imageOf(one.bone) >= bone_count_) lonely += one.weight;
  }
  const double share = 0.5 * std::max(0.0, 1 - lonely);
  if (!(share > 0 && paired > 0)) return;
  for (const Influence& one : weights) sums.add(one.bone, (1 - share) * one.weight);
  for (size_t corner = 0; corner < 8; ++corner) {
    const uint32_t vertex = volume_.cells[place->cell][corner];
    for (const Influence* one = begin(vertex); one != end(vertex); ++one) {
      const uint32_t image = imageOf(one->bone);
      if (image >= bone_count_) continue;
      sums.add(image, share * (place->shares[corner] * one->weight / paired));
    }
  }
  sums.take(weights);
}

std::vector<Influences> WeightField::at(const Mesh& mesh) const {
  std::vector<Influences> all(mesh.positions.size(), Influences{});
  if (bone_count_ == 0) return all;
  constexpr double kBelow = 0.2;  // of the spacing: where a point of the surface is surely inside
  const std::vector<Vec3> normals = normalsOf(mesh);
  WeightSums sums(bone_count_);
  std::vector<Influence> found;
  for (size_t i = 0; i < mesh.positions.size(); ++i) {
    const Vec3 p = mesh.positions[i];
    if (!isFinite(p)) {
      all[i] = only(0);
      continue;
    }
    const Vec3 inward = p - normals[i] * (kBelow * volume_.spacing);
    std::array<uint32_t, 8> corners{};
    std::array<double, 8> shares{};
    if (const auto place = volume_.locate(p, inward)) {
      corners = volume_.cells[place->cell];
      shares = place->shares;
    } else {
      corners[0] = nearestVertex(p);
      shares[0] = 1;
    }
    for (size_t corner = 0; corner < 8; ++corner) {
      if (shares[corner] == 0) continue;
      for (const Influence* one = begin(corners[corner]); one != end(corners[corner]); ++one) {
        sums.add(one->bone, shares[corner] * one->weight);
      }
    }
    sums.take(found);
    if (symmetry_) addMirrored(p, inward, found, sums);
    all[i] = found.empty() ? only(0) : largest(found);
  }
  return all;
}

}  // namespace marrow
