#include "io/export_text.h"

#include <algorithm>
#include <cmath>

namespace marrow {

Json timingsToTree(const Timings& timings) {
  Json tree = Json::object();
  for (const auto& [stage, ms] : timings.stages_ms) tree[stage] = toJson(ms);
  tree["total"] = toJson(timings.total_ms);
  return tree;
}

std::string toLines(const Json& object) {
  std::string text;
  for (const auto& field : object.items()) {
    text += text.empty() ? "{\n  " : ",\n  ";
    text += toText(field.key()) + ": " + toText(field.value());
  }
  return text + "\n}\n";
}

namespace obj {

std::string number(double value) { return toJson(value).dump(); }

std::string name(const std::string& words) {
  std::string text;
  for (char c : words) text += static_cast<unsigned char>(c) <= ' ' || c == '\x7f' ? '_' : c;
  return text.empty() ? "part" : text;
}

void appendVector(std::string& text, const char* keyword, Vec3 v) {
  text += keyword;
  for (double value : {v.x, v.y, v.z}) text += ' ' + number(value);
  text += '\n';
}

void appendFaces(std::string& text, const Mesh& mesh, size_t first) {
  text += "s 1\n";
  for (const auto& triangle : mesh.triangles) {
    text += 'f';
    for (uint32_t corner : triangle) {
      const std::string index = std::to_string(first + corner);
      text += ' ' + index + "//" + index;
    }
    text += '\n';
  }
}

}  // namespace obj

namespace svg {

const char* colorOf(JointKind kind) {
  switch (kind) {
    case JointKind::terminal:
      return "#d55e00";
    case JointKind::sleeve:
      return "#f0e442";
    case JointKind::junction:
      return "#0072b2";
  }
  return "#000";
}

std::string fixed(double value) {
  const long long hundredths = std::llround(value * 100);
  const long long size = hundredths < 0 ? -hundredths : hundredths;
  std::string text = std::to_string(size / 100);
  if (size % 100 != 0) {
    text += size % 100 < 10 ? ".0" : ".";
    text += std::to_string(size % 100);
  }
  return hundredths < 0 ? '-' + text : text;
}

std::string escaped(const std::string& words) {
  std::string text;
  for (char c : words) {
    switch (c) {
      case '<':
        text += "&lt;";
        break;
      case '>':
        text += "&gt;";
        break;
      case '&':
        text += "&amp;";
        break;
      case '"':
        text += "&quot;";
        break;
      default:
        text += static_cast<unsigned char>(c) < ' ' ? ' ' : c;
    }
  }
  return text;
}

std::string shortened(const std::string& words, size_t most_letters) {
  size_t letters = 0, end = 0;
  while (end < words.size()) {
    const bool starts_letter = (static_cast<unsigned char>(words[end]) & 0xc0) != 0x80;
    if (starts_letter && ++letters > most_letters) return words.substr(0, end) + "…";
    ++end;
  }
  return words;
}

std::string count(size_t number, const std::string& things) {
  return std::to_string(number) + ' ' + things;
}

std::string pair(Vec2 p) { return fixed(p.x) + ',' + fixed(p.y); }

std::string openGroup(const char* id, const std::string& style) {
  return std::string("<g id=\"") + id + "\" " + style + ">\n";
}

std::string circle(Vec2 center, double radius, const std::string& style) {
  return "<circle cx=\"" + fixed(center.x) + "\" cy=\"" + fixed(center.y) + "\" r=\"" +
         fixed(radius) + "\"" + (style.empty() ? "" : " " + style) + "/>\n";
}

std::string polygonOf(const std::vector<Vec2>& corners) {
  std::string text = "<polygon points=\"";
  for (Vec2 corner : corners) text += pair(corner) + ' ';
  text.back() = '"';
  return text + "/>\n";
}

std::string bone(Vec2 from, Vec2 to, double widest) {
  const double span = distance(from, to);
  if (span <= 0) return {};
  const Vec2 side = perpendicular((to - from) / span) * std::min(widest, span / 6);
  const Vec2 shoulder = lerp(from, to, 0.18);
  return polygonOf({from, shoulder + side, to, shoulder - side});
}

std::string open(double width, double height, const std::string& title) {
  const std::string w = fixed(width), h = fixed(height);
  return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" + w + "\" height=\"" + h +
         "\" viewBox=\"0 0 " + w + ' ' + h + "\">\n<title>" + escaped(title) +
         "</title>\n<rect width=\"100%\" height=\"100%\" fill=\"#ffffff\"/>\n";
}

void Legend::title(const std::string& words) {
  text_ += "<text x=\"" + fixed(x_) + "\" y=\"" + fixed(y_) +
           "\" font-size=\"17\" font-weight=\"600\">" + escaped(words) + "</text>\n";
  y_ += 14;
}

void Legend::line(const std::string& style, const std::string& words) {
  y_ += kLine;
  text_ += "<line x1=\"" + fixed(x_) + "\" y1=\"" + fixed(y_ - 5) + "\" x2=\"" + fixed(x_ + 22) +
           "\" y2=\"" + fixed(y_ - 5) + "\" " + style + "/>\n";
  label(words);
}

void Legend::dot(double radius, const std::string& style, const std::string& words) {
  y_ += kLine;
  text_ += circle({x_ + 11, y_ - 5}, radius, style);
  label(words);
}

void Legend::plain(const std::string& words) {
  y_ += kLine;
  label(words);
}

void Legend::label(const std::string& words) {
  text_ +=
      "<text x=\"" + fixed(x_ + 32) + "\" y=\"" + fixed(y_) + "\">" + escaped(words) + "</text>\n";
}

std::string Legend::svg() const {
  return "<g id=\"legend\" fill=\"#22201d\" font-family=\"system-ui, 'DejaVu Sans', sans-serif\" "
         "font-size=\"14\">\n" +
         text_ + "</g>\n";
}

}  // namespace svg
}  // namespace marrow
