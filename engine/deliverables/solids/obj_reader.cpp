// SPDX-License-Identifier: Apache-2.0
// Wavefront OBJ: the lines v, f, l, o, g, usemtl and mtllib.
#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>
#include <unordered_map>

#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"

namespace ilot {
namespace {

class ObjParser {
 public:
  ObjParser(const std::string& name, std::string stem, std::size_t least_corners)
      : name_(name), group_(std::move(stem)), least_corners_(least_corners) {}

  void line(std::string_view text) {
    ++number_;
    const std::string_view word = take_word(text);
    statements_ += is_statement(word);
    blank_ = blank_ && word.empty();
    if (word == "v") {
      vertices_.push_back(vertex(text));
    } else if (word == "f") {
      add_face(text);
    } else if (word == "l") {
      add_line(text);
    } else if (word == "o" || word == "g") {
      group_ = std::string(rest(text));
      current_.reset();
    } else if (word == "usemtl") {
      material_ = std::string(rest(text));
    } else if (word == "mtllib") {
      file_.material_files.emplace_back(rest(text));
    }
  }

  ModelFile finish() {
    if (!blank_ && statements_ == 0)
      throw Error(name_ + ": no line of it is a statement of OBJ (v, f, o, g, ...): it is another kind of file");
    return std::move(file_);
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}:{}: {}", name_, number_, what)); }

  // True for statements of polygons and lines, and for comments. Surfaces of higher order need vertices, whose
  // statements are among these.
  static bool is_statement(std::string_view word) {
    constexpr std::string_view kWords[] = {"v", "vt", "vn", "f", "l", "p", "o", "g", "s", "mtllib", "usemtl"};
    return word.starts_with('#') || std::find(std::begin(kWords), std::end(kWords), word) != std::end(kWords);
  }

  static bool blank(char c) { return c == ' ' || c == '\t' || c == '\r'; }

  static std::string_view rest(std::string_view text) {
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    while (!text.empty() && blank(text.back())) text.remove_suffix(1);
    return text;
  }

  static std::string_view take_word(std::string_view& text) {
    while (!text.empty() && blank(text.front())) text.remove_prefix(1);
    std::size_t end = 0;
    while (end < text.size() && !blank(text[end])) ++end;
    const std::string_view word = text.substr(0, end);
    text.remove_prefix(end);
    return word;
  }

  Vec3 vertex(std::string_view text) const {
    double values[3] = {0, 0, 0};
    for (double& value : values) {
      const std::string_view word = take_word(text);
      const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), value);
      if (code != std::errc() || end != word.data() + word.size() || !std::isfinite(value))
        fail("a vertex needs three finite numbers");
    }
    return {values[0], values[1], values[2]};
  }

  // Reads 12, 12/3, 12//4, 12/3/4 or a number counted from the end, -1.
  std::uint32_t corner(std::string_view word, const char* of) const {
    std::int64_t index = 0;
    const auto [end, code] = std::from_chars(word.data(), word.data() + word.size(), index);
    if (code != std::errc() || (end != word.data() + word.size() && *end != '/'))
      fail(fmt::format("'{}' is no corner of a {}", word, of));
    const auto count = static_cast<std::int64_t>(vertices_.size());
    const std::int64_t place = index < 0 ? count + index : index - 1;
    if (place < 0 || place >= count) fail(fmt::format("a {} names vertex {} of {}", of, index, count));
    return static_cast<std::uint32_t>(place);
  }

  void add_face(std::string_view text) {
    std::vector<std::uint32_t> corners;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text)) {
      if (corners.size() == kMaxCorners) fail(fmt::format("a face has more than {} corners", kMaxCorners));
      corners.push_back(corner(word, "face"));
    }
    if (corners.size() < least_corners_) fail("a face has fewer than three corners");
    enter_group();
    PolygonModel& model = file_.models[*current_];
    std::unordered_map<std::uint32_t, std::uint32_t>& known = local_[*current_];
    for (std::uint32_t& i : corners) {
      const auto [entry, added] = known.try_emplace(i, static_cast<std::uint32_t>(model.vertices.size()));
      if (added) model.vertices.push_back(vertices_[i]);
      i = entry->second;
    }
    model.faces.push_back({{std::move(corners)}, FaceKind::unknown, 0, surface_of(model)});
  }

  void add_line(std::string_view text) {
    std::optional<Vec3> before;
    std::size_t corners = 0;
    for (std::string_view word = take_word(text); !word.empty(); word = take_word(text), ++corners) {
      const Vec3 p = vertices_[corner(word, "line")];
      if (before) file_.lines.emplace_back(*before, p);
      before = p;
    }
    if (corners < 2) fail("a line has fewer than two corners");
  }

  // Returns the index of the current material among the surfaces of the model.
  std::int32_t surface_of(PolygonModel& model) {
    const auto [entry, added] = surfaces_[*current_].try_emplace(material_, model.surfaces.size());
    if (added) model.surfaces.push_back({"", model.name, -1, "", material_});
    return static_cast<std::int32_t>(entry->second);
  }

  // A group becomes a model when its first face is read.
  void enter_group() {
    if (current_) return;
    const auto [entry, added] = models_.try_emplace(group_, file_.models.size());
    if (added) {
      file_.models.push_back({group_, {}, {}});
      local_.emplace_back();
      surfaces_.emplace_back();
    }
    current_ = entry->second;
  }

  const std::string& name_;
  std::string group_, material_;
  std::size_t least_corners_;
  std::uint64_t number_ = 0, statements_ = 0;
  bool blank_ = true;
  std::vector<Vec3> vertices_;
  std::optional<std::size_t> current_;
  std::unordered_map<std::string, std::size_t> models_;
  std::vector<std::unordered_map<std::uint32_t, std::uint32_t>> local_;  // per model: vertex of the file -> its own
  std::vector<std::unordered_map<std::string, std::size_t>> surfaces_;   // per model: material -> index of its surface
  ModelFile file_;
};

}  // namespace

ModelFile parse_obj(std::string_view text, const std::string& name, const std::string& stem,
                    std::size_t least_corners) {
  if (const std::size_t zero = text.find('\0'); zero != text.npos)
    throw Error(fmt::format("{}: byte {} is zero, which no text has: it is no OBJ file", name, zero));
  ObjParser parser(name, stem, least_corners);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    parser.line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return parser.finish();
}

}  // namespace ilot
