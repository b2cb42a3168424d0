// SPDX-License-Identifier: Apache-2.0
// OFF (Geomview) and POLY (TetGen): counts, then vertices, then faces.
#include <fmt/format.h>

#include <charconv>
#include <cmath>

#include "engine/deliverables/solids/solid_file.h"
#include "engine/error.h"

namespace ilot {
namespace {

// Gives words in order; # starts a comment that ends with its line.
class Words {
 public:
  Words(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}:{}: {}", name_, line_, what)); }

  bool done() {
    skip();
    return at_ == text_.size();
  }

  // Tells whether the next word is on this line.
  bool more_on_line() {
    while (at_ < text_.size() && (text_[at_] == ' ' || text_[at_] == '\t' || text_[at_] == '\r')) ++at_;
    return at_ < text_.size() && text_[at_] != '\n' && text_[at_] != '#';
  }

  std::string_view word() {
    if (done()) fail("the file ends too early");
    const std::size_t first = at_;
    while (at_ < text_.size() && !std::isspace(static_cast<unsigned char>(text_[at_]))) ++at_;
    return text_.substr(first, at_ - first);
  }

  double real() {
    const std::string_view text = word();
    double value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size() || !std::isfinite(value))
      fail(fmt::format("'{}' is no number", text));
    return value;
  }

  // Reads a whole number from 0 to below `limit`.
  std::uint32_t whole(std::uint64_t limit, const char* what) {
    const std::string_view text = word();
    std::uint64_t value = 0;
    const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
    if (code != std::errc() || end != text.data() + text.size() || value >= limit)
      fail(fmt::format("'{}' is no {}", text, what));
    return static_cast<std::uint32_t>(value);
  }

  // Reads how many items follow. It cannot exceed the length of the remaining text.
  std::uint32_t count(const char* what) { return whole(text_.size() - at_ + 1, what); }

  Vec3 point() {
    const double x = real(), y = real();
    return {x, y, real()};
  }

  std::vector<std::uint32_t> ring(std::uint64_t vertices) {
    std::vector<std::uint32_t> corners(count("number of corners"));
    for (std::uint32_t& i : corners) i = whole(vertices, "number of a vertex");
    return corners;
  }

 private:
  void skip() {
    for (; at_ < text_.size(); ++at_) {
      if (text_[at_] == '#')
        while (at_ + 1 < text_.size() && text_[at_ + 1] != '\n') ++at_;
      else if (!std::isspace(static_cast<unsigned char>(text_[at_])))
        return;
      if (text_[at_] == '\n') ++line_;
    }
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 1;
};

// Reads a facet: the number of rings and, on the same line, the number of points in holes, which follow the rings.
SolidFace poly_face(Words& words, std::uint32_t first, std::uint32_t vertices) {
  SolidFace face;
  const std::uint32_t rings = words.count("number of rings");
  const std::uint32_t holes = words.more_on_line() ? words.count("number of holes") : 0;
  while (words.more_on_line()) words.word();
  for (std::uint32_t r = 0; r < rings; ++r) {
    face.rings.push_back(words.ring(vertices));
    for (std::uint32_t& i : face.rings.back()) i += first;
  }
  for (std::uint32_t h = 0; h < holes; ++h) {
    words.word();
    words.point();
  }
  return face;
}

SolidShell poly_shell(Words& words, std::uint32_t points, std::vector<Vec3>& vertices) {
  const auto first = static_cast<std::uint32_t>(vertices.size());
  while (words.more_on_line()) words.word();
  for (std::uint32_t i = 0; i < points; ++i) {
    words.word();
    vertices.push_back(words.point());
    while (words.more_on_line()) words.word();
  }
  SolidShell shell(words.count("number of facets"));
  while (words.more_on_line()) words.word();
  for (SolidFace& face : shell) face = poly_face(words, first, points);
  return shell;
}

// Skips holes and regions: tetrahedra need them, validity does not.
void skip_poly_list(Words& words) {
  if (words.done()) return;
  const std::uint32_t entries = words.count("number of holes");
  while (words.more_on_line()) words.word();
  for (std::uint32_t i = 0; i < entries; ++i) {
    words.word();
    while (words.more_on_line()) words.word();
  }
}

}  // namespace

CityObject parse_off(std::string_view text, const std::string& name) {
  Words words(text, name);
  if (words.word() != "OFF") words.fail("an OFF file begins with OFF");
  CityObject object{name, "", {}, {}};
  object.vertices.resize(words.count("number of vertices"));
  SolidShell shell(words.count("number of faces"));
  words.word();  // edges
  for (Vec3& v : object.vertices) v = words.point();
  for (SolidFace& face : shell) {
    face.rings = {words.ring(object.vertices.size())};
    while (words.more_on_line()) words.word();  // colours
  }
  object.primitives.push_back({PrimitiveKind::solid, "", object.id, {{std::move(shell)}}});
  return object;
}

CityObject parse_poly(std::string_view text, const std::string& name) {
  Words words(text, name);
  CityObject object{name, "", {}, {}};
  SolidShells shells;
  while (!words.done()) {
    const std::uint32_t points = words.count("number of points");
    if (!shells.empty() && !words.more_on_line()) break;  // content after these counts is not a shell
    shells.push_back(poly_shell(words, points, object.vertices));
    skip_poly_list(words);
    skip_poly_list(words);
  }
  object.primitives.push_back({PrimitiveKind::solid, "", object.id, {std::move(shells)}});
  return object;
}

}  // namespace ilot
