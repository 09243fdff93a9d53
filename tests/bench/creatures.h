// Characters to measure, and how figures are written.
#pragma once

#include <algorithm>
#include <cstdio>
#include <memory>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>
#include <vector>

#include "bench/measure.h"
#include "io/document_json.h"
#include "support/creatures.h"
#include "support/strokes.h"

namespace marrow::bench {

using Json = nlohmann::ordered_json;

inline void print(const Json& row) { std::printf("%s\n", row.dump().c_str()); }

/// Smallest, median and largest.
inline Json toJson(std::vector<double> times_ms) {
  const Times times = summary(times_ms);
  return {times.min_ms, times.median_ms, *std::max_element(times_ms.begin(), times_ms.end())};
}

struct Creature {
  std::string name, text;
  Document document;
};

inline Creature creatureOf(std::string name, Document document) {
  return {std::move(name), writeDocument(document), std::move(document)};
}

/// Eight strokes as a hand draws them.
inline Creature fourLegged() {
  using strokes::Stroke;
  Random random(8);
  Document document;
  const auto add = [&](const char* name, Stroke stroke, Vec3 origin) {
    auto part = std::make_shared<PartSource>();
    part->id = partId(takePartNumber(document));
    part->name = name;
    part->stroke = strokes::jittered(random, std::move(stroke), 0.3);
    part->frame.origin = origin;
    document.parts.push_back(std::move(part));
  };
  const auto ellipse = [](double rx, double ry) {
    Stroke stroke = strokes::disc(1, static_cast<int>(rx));
    for (Vec2& p : stroke) p = {p.x * rx, p.y * ry};
    return stroke;
  };
  const auto limb = [](Vec2 way, double bend, double half_width) {
    Stroke axis;
    for (int i = 0; i <= 35; ++i) {
      const double t = i / 35.0;
      axis.push_back(way * t + perpendicular(way) * (bend * t * (1 - t)));
    }
    return strokes::tube(axis, half_width);
  };
  add("Body", ellipse(170, 75), {});
  add("Head", ellipse(70, 50), {200, 70, 0});
  for (const double x : {-110.0, 110.0}) {
    for (const double z : {-40.0, 40.0}) {
      add("Leg", limb({0, -160}, x / 800, 18 + z / 20), {x, -10, z});
    }
  }
  add("Tail", limb({-150, 40}, 0.3, 10), {-150, 10, 0});
  add("Ear", limb({10, 60}, 0.1, 12), {210, 90, 0});
  return creatureOf("four-legged (8 strokes)", std::move(document));
}

inline Creature sixtyParts() {
  Random random(60);
  CreatureOptions options;
  options.points = 100;
  options.apart = 0.02;
  return creatureOf("60 strokes", randomCreature(random, 60, options));
}

/// Documents by their paths.
inline std::vector<Creature> samples(const std::vector<std::string>& paths) {
  std::vector<Creature> all;
  for (const std::string& path : paths) {
    const std::string text = strokes::readText(path);
    auto document = readDocument(text);
    if (!document) continue;
    const std::string file = path.substr(path.find_last_of('/') + 1);
    all.push_back({file.substr(0, file.find('.')), text, std::move(*document)});
  }
  return all;
}

}  // namespace marrow::bench
