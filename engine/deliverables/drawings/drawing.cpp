// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/drawing.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/error.h"

namespace ilot {
namespace {

constexpr double kKeyStep = 1e-5;  // metres
constexpr char32_t kReplacement = 0xFFFD;
constexpr double kDigitWidth = 0.78;  // of Arial and Helvetica, in heights of capitals

struct Decoded {
  char32_t code = kReplacement;
  std::size_t length = 1;
};

// Decodes one code point of UTF-8. Overlong forms, surrogates and incomplete sequences give U+FFFD and take one byte.
Decoded decode(const std::string& text, std::size_t at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at);
  if (first < 0x80) return {first, 1};
  const std::size_t length = first >= 0xF0 ? 4 : first >= 0xE0 ? 3 : 2;
  if (first < 0xC2 || first > 0xF4 || at + length > text.size()) return {};
  char32_t code = first & (0xFFu >> (length + 1));
  for (std::size_t i = 1; i < length; ++i) {
    if ((byte(at + i) & 0xC0u) != 0x80) return {};
    code = (code << 6) | (byte(at + i) & 0x3Fu);
  }
  constexpr std::array<char32_t, 5> kLeast{0, 0, 0x80, 0x800, 0x10000};
  if (code < kLeast[length] || code > 0x10FFFF || (code >= 0xD800 && code < 0xE000)) return {};
  return {code, length};
}

std::int64_t steps(double v) {
  return static_cast<std::int64_t>(std::llround(std::clamp(v / kKeyStep, -9e17, 9e17)));
}

std::vector<std::int64_t> steps_of(const std::vector<DrawingCorner>& corners, bool closed) {
  const std::size_t n = corners.size();
  std::size_t first = 0;
  if (closed)
    for (std::size_t i = 1; i < n; ++i)
      if (std::pair(steps(corners[i].x), steps(corners[i].y)) <
          std::pair(steps(corners[first].x), steps(corners[first].y)))
        first = i;
  std::vector<std::int64_t> list;
  for (std::size_t k = 0; k < n; ++k) {
    const DrawingCorner& c = corners[(first + k) % n];
    list.insert(list.end(), {steps(c.x), steps(c.y), closed || k + 1 < n ? steps(c.bulge) : 0});
  }
  return list;
}

std::vector<DrawingCorner> reversed(const std::vector<DrawingCorner>& corners) {
  std::vector<DrawingCorner> back;
  const std::size_t n = corners.size();
  for (std::size_t k = 0; k < n; ++k)
    back.push_back({corners[n - 1 - k].x, corners[n - 1 - k].y, -corners[(2 * n - 2 - k) % n].bulge});
  return back;
}

}  // namespace

const char* name_of(DrawingRole role) {
  constexpr std::array<const char*, kDrawingRoles> kNames{
      "outline", "opening", "sill",      "lintel",    "balcony",  "band",   "bulge",    "irregularity",   "stone",
      "joint",   "detail",  "hidden",    "completed", "occluded", "shadow", "possible", "error",          "ground",
      "number",  "level",   "dimension", "mark",      "frame",    "title",  "section",  "section_points", "image"};
  return kNames.at(static_cast<std::size_t>(role));
}

double text_width(const std::string& text, double height) {
  return kDigitWidth * height * static_cast<double>(code_points(clean_text(text)).size());
}

Drawing flattened(const Drawing& drawing) {
  Drawing flat = drawing;
  flat.blocks.clear();
  flat.dimensions.clear();
  for (const DrawingBlock& block : drawing.blocks) {
    flat.lines.insert(flat.lines.end(), block.lines.begin(), block.lines.end());
    flat.arcs.insert(flat.arcs.end(), block.arcs.begin(), block.arcs.end());
  }
  for (const DrawingDimension& dimension : drawing.dimensions) {
    flat.lines.insert(flat.lines.end(), dimension.lines.begin(), dimension.lines.end());
    flat.texts.push_back(dimension.text);
  }
  return flat;
}

FlatBox extent_of(const Drawing& drawing) {
  if (!drawing.blocks.empty() || !drawing.dimensions.empty()) return extent_of(flattened(drawing));
  FlatBox extent = FlatBox::none();
  const auto add_disc = [&](double x, double y, double radius) {
    extent.add({x - radius, y - radius});
    extent.add({x + radius, y + radius});
  };
  for (const DrawingLine& line : drawing.lines) {
    for (std::size_t i = 0; i < line.corners.size(); ++i) {
      const DrawingCorner& a = line.corners[i];
      extent.add({a.x, a.y});
      if (a.bulge == 0 || (!line.closed && i + 1 == line.corners.size())) continue;
      // The highest point of the arc over its chord. The disc about the middle of the chord contains the arc.
      const DrawingCorner& b = line.corners[(i + 1) % line.corners.size()];
      const double half = std::sqrt((b.x - a.x) * (b.x - a.x) + (b.y - a.y) * (b.y - a.y)) / 2;
      add_disc((a.x + b.x) / 2, (a.y + b.y) / 2, half * std::abs(a.bulge));
    }
  }
  for (const DrawingArc& arc : drawing.arcs) add_disc(arc.x, arc.y, arc.radius);
  for (const DrawingPoint& point : drawing.points) extent.add({point.x, point.y});
  for (const DrawingText& text : drawing.texts) {
    const double width = text_width(text.text, text.height);
    const double before = text.anchor == TextAnchor::left ? 0 : text.anchor == TextAnchor::middle ? width / 2 : width;
    if (text.rotation_deg == 0) {
      extent.add({text.x - before, text.y});
      extent.add({text.x - before + width, text.y + text.height});
    } else {
      add_disc(text.x, text.y, std::max(before, width - before));
    }
  }
  return extent.is_empty() ? FlatBox{} : extent;
}

std::vector<std::int64_t> place_key(const std::vector<DrawingCorner>& corners, bool closed) {
  return std::min(steps_of(corners, closed), steps_of(reversed(corners), closed));
}

std::string clean_text(const std::string& text) {
  std::string clean;
  for (std::size_t at = 0; at < text.size();) {
    const Decoded next = decode(text, at);
    if (next.code < 32 || (next.code >= 0x7F && next.code < 0xA0) || next.code == 0x2028 || next.code == 0x2029)
      clean += ' ';
    else if (next.code == kReplacement || next.code == 0xFFFE || next.code == 0xFFFF)
      clean += "\xEF\xBF\xBD";
    else
      clean.append(text, at, next.length);
    at += next.length;
  }
  return clean;
}

std::vector<char32_t> code_points(const std::string& text) {
  std::vector<char32_t> codes;
  for (std::size_t at = 0; at < text.size();) {
    const Decoded next = decode(text, at);
    codes.push_back(next.code);
    at += next.length;
  }
  return codes;
}

std::string decimal(double value, int decimals) {
  if (!std::isfinite(value)) throw Error("a drawing has a coordinate that is no number");
  std::string text = fmt::format("{:.{}f}", value, decimals);
  if (text[0] == '-' && text.find_first_not_of("-0.") == std::string::npos) text.erase(0, 1);
  return text;
}

}  // namespace ilot
