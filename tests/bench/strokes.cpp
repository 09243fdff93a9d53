#include "support/strokes.h"

#include "bench/inputs.h"
#include "sketch/polygon.h"

namespace marrow::bench {

std::vector<Vec2> typicalStroke() {
  const std::vector<Vec2> corners = {
      {-150, 30},   {-190, 90},  {-205, 150}, {-190, 155}, {-172, 95},  {-130, 60},  {-40, 70},
      {60, 62},     {100, 80},   {118, 128},  {128, 160},  {142, 132},  {165, 128},  {205, 100},
      {212, 82},    {165, 72},   {140, 20},   {132, -30},  {140, -110}, {150, -140}, {112, -140},
      {106, -60},   {88, -30},   {40, -42},   {-40, -45},  {-82, -35},  {-90, -110}, {-80, -140},
      {-120, -140}, {-128, -90}, {-138, -30}};
  // Corners cut twice [Chaikin 1974].
  std::vector<Vec2> curve = corners;
  for (int round = 0; round < 2; ++round) {
    std::vector<Vec2> cut;
    for (size_t i = 0; i < curve.size(); ++i) {
      const Vec2 a = curve[i], b = curve[(i + 1) % curve.size()];
      cut.push_back(lerp(a, b, 0.25));
      cut.push_back(lerp(a, b, 0.75));
    }
    curve = std::move(cut);
  }
  std::vector<Vec2> stroke;
  const double step = perimeter(curve) / 300;
  double along = 0;  // of the next sample, from the start of the edge
  for (size_t i = 0; i < curve.size(); ++i) {
    const Vec2 a = curve[i], b = curve[(i + 1) % curve.size()];
    const double edge = distance(a, b);
    for (; along < edge && stroke.size() < 300; along += step) {
      stroke.push_back(lerp(a, b, along / edge));
    }
    along -= edge;
  }
  Random random(300);
  return strokes::jittered(random, stroke, 0.4);
}

std::vector<Input> benchStrokes() {
  using namespace strokes;
  Random random(11);
  std::vector<Input> all = {
      {"typical (300 samples)", typicalStroke()},
      {"blob", byHand(random, strokes::blob(random, 240), 0.02)},
      {"hand", hand()},
      {"star", sampled(star(7, 60, 150), 3)},
      {"spiral", spiral(3, 60, 18)},
      {"tube", wavyTube(12)},
      {"thin tube", wavyTube(1.5)},
      {"scribble", scribble(random, 300)},
  };
  for (NamedStroke& real : realStrokes()) all.push_back({real.name, std::move(real.points)});
  return all;
}

}  // namespace marrow::bench
