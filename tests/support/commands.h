// Any command, from any source of numbers: random ones in the tests, a fuzzer's bytes.
#pragma once

#include <memory>
#include <string>
#include <vector>

#include "document/command.h"
#include "support/creatures.h"

namespace marrow {

/// Numbers as a user would give them.
class TameNumbers {
 public:
  explicit TameNumbers(Random& random) : random_(random) {}
  int below(int count) { return random_.below(count); }
  /// A length, a coordinate or a factor.
  double number() { return random_.between(-200, 200); }
  Affine map() {
    Affine map;
    switch (below(5)) {
      case 0:
        map = randomSimilarity(random_);
        break;
      case 1:
        map = randomRotation(random_);
        break;
      case 2:  // stretches and mirrors
        map = randomRotation(random_);
        map.x = map.x * random_.between(0.5, 2);
        map.z = map.z * random_.between(-2, -0.5);
        break;
      case 3:
        map.y = Vec3{random_.between(-1, 1), 1, random_.between(-1, 1)};
        break;
      case 4:
        map.move = {number(), number(), number()};
        break;
    }
    return map;
  }

 private:
  Random& random_;
};

/// One of all kinds of commands, mostly about parts that are there. Numbers: has below(), number()
/// and map().
template <typename Numbers>
class AnyCommand {
 public:
  AnyCommand(Numbers& numbers, const Document& document) : numbers_(numbers), document_(document) {}

  Command operator()() {
    switch (numbers_.below(27)) {
      case 0:
        return AddPart{stroke(), frame(), chance(3) ? std::optional<Plane>(plane()) : std::nullopt};
      case 1:
        return DeleteParts{ids()};
      case 2:
        return DuplicateParts{ids(), vector()};
      case 3:
        return TransformParts{chance(4) ? allPlacedIds(document_) : ids(), numbers_.map()};
      case 4:
        return SetThickness{ids(), numbers_.number()};
      case 5:
        return SetColor{ids(), partColor(static_cast<size_t>(numbers_.below(7)))};
      case 6:
        return SetVisible{ids(), chance(2)};
      case 7:
        return SetLocked{ids(), chance(3)};
      case 8:
        return SetSkeleton{ids(), chance(2)};
      case 9:
        return RenamePart{id(), name()};
      case 10:
        return SetStroke{id(), stroke()};
      case 11:
        return SetMirror{ids(), chance(3) ? std::nullopt : std::optional<Plane>(plane())};
      case 12:
        return SeparateTwins{ids()};
      case 13:
        return SetSymmetry{chance(4) ? std::nullopt : std::optional<Plane>(plane())};
      case 14:
        return SetRefinement{chance(4) ? Ids{} : ids(), branch(), threshold(), value()};
      case 15:
        return ResetRefinement{chance(4) ? Ids{} : ids(), branch(), chance(2)};
      case 16:
        return SetAttachment{id(), attachment()};
      case 17:
        return SetRoot{id(), ids()};
      case 18:
        return SetReference{reference()};
      case 19:
        return SetPose{poseName(), pose()};
      case 20:
        return RenamePose{poseName(), poseName()};
      case 21:
        return DeletePose{poseName()};
      case 22:
        return AddWeightStroke{weightStroke()};
      case 23:
        return ClearWeightStrokes{chance(3) ? std::string() : jointId()};
      case 24:
        return SetBlend{numbers_.number()};
      case 25:
        return ImportPart{mesh(), name(), frame()};
      default:
        return chance(20) ? Command(ReplaceDocument{{}, "New drawing"})
                          : Command(TransformParts{ids(), numbers_.map(), "Turn"});
    }
  }

 private:
  bool chance(int one_in) { return numbers_.below(one_in) == 0; }
  Vec2 point() { return {numbers_.number(), numbers_.number()}; }
  Vec3 vector() { return {numbers_.number(), numbers_.number(), numbers_.number()}; }
  Plane plane() { return chance(2) ? Plane{{1, 0, 0}, 0} : Plane{vector(), numbers_.number()}; }
  Frame frame() { return chance(2) ? Frame{} : Frame{vector(), vector(), vector()}; }

  std::vector<Vec2> stroke() {
    std::vector<Vec2> points;
    for (int count = numbers_.below(12); count > 0; --count) points.push_back(point());
    return points;
  }
  /// A block with a corner that is pulled out, so that no two of its sides are alike.
  std::shared_ptr<const Mesh> mesh() {
    Mesh block;
    const Vec3 size = chance(2) ? Vec3{50, 30, 20} : vector();
    for (int i = 0; i < 8; ++i) {
      block.positions.push_back({i & 1 ? size.x : 0, i & 2 ? size.y : 0, i & 4 ? size.z : 0});
    }
    block.positions[7] = block.positions[7] * 1.5;
    block.triangles = {{0, 2, 3}, {0, 3, 1}, {4, 5, 7}, {4, 7, 6}, {0, 1, 5}, {0, 5, 4},
                       {2, 6, 7}, {2, 7, 3}, {0, 4, 6}, {0, 6, 2}, {1, 3, 7}, {1, 7, 5}};
    return std::make_shared<const Mesh>(std::move(block));
  }
  std::string id() {
    if (document_.parts.empty() || chance(12)) return partId(1);
    const int index = numbers_.below(static_cast<int>(document_.parts.size()));
    const PartSource& part = *document_.parts[static_cast<size_t>(index)];
    return part.mirror && chance(2) ? part.id + kTwinSuffix : part.id;
  }
  Ids ids() {
    Ids ids;
    for (int count = 1 + numbers_.below(4); count > 0; --count) ids.push_back(id());
    return ids;
  }
  std::string name() {
    const char* names[] = {
        "Leg", "Leg 2", "Leg 99999999999999999999", "", "Größe", "a\nb", "\xff", "7", " 7", "x 0"};
    return names[numbers_.below(static_cast<int>(sizeof names / sizeof names[0]))];
  }
  std::string branch() {
    return chance(3) ? "b" + std::to_string(numbers_.below(4)) : std::string();
  }
  std::optional<double> Refinement::*threshold() {
    std::optional<double> Refinement::*thresholds[] = {&Refinement::simplify, &Refinement::merge,
                                                       &Refinement::prune, &Refinement::collapse};
    return thresholds[numbers_.below(4)];
  }
  std::optional<double> value() {
    if (chance(4)) return std::nullopt;
    return numbers_.number();
  }
  std::optional<Attachment> attachment() {
    if (chance(4)) return std::nullopt;
    return Attachment{chance(4) ? std::string() : id(), point()};
  }
  std::string poseName() {
    const char* names[] = {"Wave", "Walk", "", "Sit\n", "\xff"};
    return names[numbers_.below(5)];
  }
  std::string jointId() {
    if (chance(4)) return id() + "/a:" + id();
    return id() + "/n" + std::to_string(numbers_.below(3));
  }
  WeightStroke weightStroke() {
    WeightStroke stroke;
    stroke.kind = static_cast<WeightStroke::Kind>(numbers_.below(3));
    stroke.part = id();
    stroke.joint = chance(8) ? name() : jointId();
    stroke.radius = numbers_.number();
    stroke.strength = chance(2) ? numbers_.number() : 0.5;
    for (int count = numbers_.below(6); count > 0; --count) stroke.points.push_back(vector());
    return stroke;
  }
  Pose pose() {
    Pose pose;
    for (int count = numbers_.below(4); count > 0; --count) {
      JointMotion motion{{numbers_.number(), numbers_.number(), numbers_.number(), 1}, {}};
      if (chance(8)) motion.rotation = {0, 0, 0, 0};
      if (chance(2)) motion.move = vector();
      pose[jointId()] = motion;
    }
    return pose;
  }
  Reference reference() {
    const char* images[] = {"data:image/png;base64,AAAA",
                            "data:image/jpeg;base64,/+8=", "data:image/gif;base64,AAAA",
                            "data:image/webp;base64,A"};
    Reference reference;
    reference.view = static_cast<Reference::View>(numbers_.below(3));
    if (!chance(4)) {
      reference.image = std::make_shared<const std::string>(images[numbers_.below(4)]);
    }
    reference.opacity = numbers_.number();
    reference.position = point();
    reference.scale = numbers_.number();
    return reference;
  }

  Numbers& numbers_;
  const Document& document_;
};

}  // namespace marrow
