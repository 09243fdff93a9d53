#include "surface/mesh.h"

#include <algorithm>
#include <cmath>

namespace marrow {
namespace {

constexpr size_t kMostSentences = 8;  // of a kind; the rest is counted
constexpr double kNoArea = 1e-12;     // twice a triangle's area ÷ its longest edge squared

struct Edge {
  uint32_t a, b;
  size_t triangles;
};

struct Survey {
  std::vector<uint32_t> unfinite;  // vertices
  std::vector<uint32_t> unnamed;   // triangles with a corner that is no vertex
  std::vector<uint32_t> repeated;  // triangles with a corner twice
  std::vector<uint32_t> flat;      // triangles without area
  std::vector<Edge> open;          // one triangle
  std::vector<Edge> crowded;       // more than two
  std::vector<Edge> turned;        // two that run through it in the same direction
  std::vector<uint32_t> pinched;   // vertices with more than one fan
  double volume = 0, area = 0;
};

/// A triangle's other two corners, seen from one.
struct Wing {
  uint32_t next, previous;
};

/// Looks at the edges from `vertex` to higher ones and at how the triangles around it hang
/// together.
void surveyVertex(uint32_t vertex, std::vector<Wing>& wings, Survey& survey) {
  struct End {
    uint32_t far;
    bool outgoing;
    uint32_t wing;
  };
  std::vector<End> ends;
  ends.reserve(2 * wings.size());
  for (uint32_t w = 0; w < wings.size(); ++w) {
    ends.push_back({wings[w].next, true, w});
    ends.push_back({wings[w].previous, false, w});
  }
  std::sort(ends.begin(), ends.end(), [](const End& a, const End& b) {
    if (a.far != b.far) return a.far < b.far;
    return a.outgoing != b.outgoing ? a.outgoing : a.wing < b.wing;
  });

  // Wings that share an edge belong to one fan: union by the lowest wing.
  std::vector<uint32_t> fan(wings.size());
  for (uint32_t w = 0; w < fan.size(); ++w) fan[w] = w;
  const auto root = [&fan](uint32_t w) {
    while (fan[w] != w) w = fan[w] = fan[fan[w]];
    return w;
  };
  for (size_t i = 0; i < ends.size();) {
    size_t j = i, outgoing = 0;
    for (; j < ends.size() && ends[j].far == ends[i].far; ++j) {
      if (ends[j].outgoing) ++outgoing;
      const uint32_t a = root(ends[i].wing), b = root(ends[j].wing);
      fan[std::max(a, b)] = std::min(a, b);
    }
    const Edge edge = {vertex, ends[i].far, j - i};
    if (vertex < edge.b) {
      if (edge.triangles == 1) {
        survey.open.push_back(edge);
      } else if (edge.triangles > 2) {
        survey.crowded.push_back(edge);
      } else if (outgoing != 1) {
        survey.turned.push_back(edge);
      }
    }
    i = j;
  }
  size_t fans = 0;
  for (uint32_t w = 0; w < fan.size(); ++w) fans += fan[w] == w ? 1 : 0;
  if (fans > 1) survey.pinched.push_back(vertex);
}

Survey surveyMesh(const Mesh& mesh) {
  Survey survey;
  const uint32_t vertex_count = static_cast<uint32_t>(mesh.positions.size());
  for (uint32_t v = 0; v < vertex_count; ++v) {
    const Vec3 p = mesh.positions[v];
    if (!std::isfinite(p.x) || !std::isfinite(p.y) || !std::isfinite(p.z)) {
      survey.unfinite.push_back(v);
    }
  }

  std::vector<uint32_t> starts(vertex_count + 1, 0);
  std::vector<char> sound(mesh.triangles.size(), 0);
  const Vec3 origin = mesh.positions.empty() ? Vec3{} : mesh.positions[0];
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    const auto [i, j, k] = mesh.triangles[t];
    if (i >= vertex_count || j >= vertex_count || k >= vertex_count) {
      survey.unnamed.push_back(t);
      continue;
    }
    if (i == j || j == k || k == i) {
      survey.repeated.push_back(t);
      continue;
    }
    sound[t] = 1;
    for (const uint32_t corner : {i, j, k}) ++starts[corner + 1];
    const Vec3 a = mesh.positions[i] - origin, b = mesh.positions[j] - origin,
               c = mesh.positions[k] - origin;
    const double doubled = length(cross(b - a, c - a));
    const double longest = std::max({dot(b - a, b - a), dot(c - b, c - b), dot(a - c, a - c)});
    if (!(doubled > kNoArea * longest)) survey.flat.push_back(t);
    survey.area += doubled / 2;
    survey.volume += dot(a, cross(b, c)) / 6;
  }

  for (uint32_t v = 0; v < vertex_count; ++v) starts[v + 1] += starts[v];
  std::vector<Wing> wings(starts[vertex_count]);
  std::vector<uint32_t> filled(starts.begin(), starts.end() - 1);
  for (uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!sound[t]) continue;
    const auto& corners = mesh.triangles[t];
    for (int c = 0; c < 3; ++c) {
      wings[filled[corners[c]]++] = {corners[(c + 1) % 3], corners[(c + 2) % 3]};
    }
  }
  std::vector<Wing> around;
  for (uint32_t v = 0; v < vertex_count; ++v) {
    around.assign(wings.begin() + starts[v], wings.begin() + starts[v + 1]);
    surveyVertex(v, around, survey);
  }
  return survey;
}

/// Adds one sentence for each fault, and one for how many more there are.
template <typename Fault, typename Sentence>
void describe(const std::vector<Fault>& faults, const Sentence& sentence,
              std::vector<std::string>& sentences) {
  for (size_t i = 0; i < faults.size() && i < kMostSentences; ++i) {
    sentences.push_back(sentence(faults[i]));
  }
  if (faults.size() > kMostSentences) {
    sentences.push_back("… and " + std::to_string(faults.size() - kMostSentences) +
                        " more like it");
  }
}

std::string name(const Edge& edge) {
  return "edge " + std::to_string(edge.a) + "–" + std::to_string(edge.b);
}

}  // namespace

MeshReport inspect(const Mesh& mesh) {
  const Survey survey = surveyMesh(mesh);
  MeshReport report;
  report.closed = !mesh.triangles.empty() && survey.open.empty() && survey.unnamed.empty();
  report.manifold = survey.crowded.empty() && survey.turned.empty() && survey.pinched.empty() &&
                    survey.unnamed.empty() && survey.repeated.empty();
  report.volume = survey.volume;
  report.area = survey.area;
  report.degenerate = static_cast<int>(survey.repeated.size() + survey.flat.size());
  return report;
}

std::vector<std::string> validate(const Mesh& mesh) {
  if (mesh.triangles.empty()) return {"the mesh has no triangles"};
  const Survey survey = surveyMesh(mesh);
  const auto triangle = [](uint32_t t) { return "triangle " + std::to_string(t); };
  const auto vertex = [](uint32_t v) { return "vertex " + std::to_string(v); };

  std::vector<std::string> faults;
  describe(
      survey.unfinite,
      [&](uint32_t v) { return vertex(v) + " has a coordinate that is no number"; }, faults);
  describe(
      survey.unnamed,
      [&](uint32_t t) { return triangle(t) + " has a corner that is not among the vertices"; },
      faults);
  describe(
      survey.repeated, [&](uint32_t t) { return triangle(t) + " has the same corner twice"; },
      faults);
  describe(
      survey.flat, [&](uint32_t t) { return triangle(t) + " has no area"; }, faults);
  describe(
      survey.open,
      [](const Edge& e) { return name(e) + " has one triangle only: there is a hole"; }, faults);
  describe(
      survey.crowded,
      [](const Edge& e) { return name(e) + " has " + std::to_string(e.triangles) + " triangles"; },
      faults);
  describe(
      survey.turned,
      [](const Edge& e) {
        return name(e) + " is run through twice in the same direction: a triangle is flipped";
      },
      faults);
  describe(
      survey.pinched,
      [&](uint32_t v) { return vertex(v) + " joins more than one fan of triangles"; }, faults);
  if (survey.volume < 0) faults.push_back("the volume is negative: the triangles face inward");
  if (survey.volume == 0) faults.push_back("the mesh encloses no volume");
  return faults;
}

std::vector<Vec3> vertexNormals(const Mesh& mesh) {
  const size_t count = mesh.positions.size();
  // One array a coordinate: sums of pairs, which compilers make of Vec3, wait for each other.
  std::vector<double> x(count, 0), y(count, 0), z(count, 0);
  const auto add = [&](uint32_t v, Vec3 face, double weight) {
    x[v] += face.x * weight;
    y[v] += face.y * weight;
    z[v] += face.z * weight;
  };
  for (const auto& [i, j, k] : mesh.triangles) {
    const Vec3 a = mesh.positions[i], b = mesh.positions[j], c = mesh.positions[k];
    const Vec3 ab = b - a, bc = c - b, ca = a - c;
    const double ab2 = dot(ab, ab), bc2 = dot(bc, bc), ca2 = dot(ca, ca);
    const double product = ab2 * bc2 * ca2;
    if (!(product > 0)) continue;
    const Vec3 face = cross(ab, bc) * (1 / product);
    add(i, face, bc2);
    add(j, face, ca2);
    add(k, face, ab2);
  }
  std::vector<Vec3> normals(count, Vec3{0, 0, 1});
  for (size_t v = 0; v < count; ++v) {
    const Vec3 sum = {x[v], y[v], z[v]};
    const double size = length(sum);
    if (size > 0) normals[v] = sum * (1 / size);
  }
  return normals;
}

}  // namespace marrow
