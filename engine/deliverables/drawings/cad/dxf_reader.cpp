// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/cad/dxf_reader.h"

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <map>
#include <utility>

#include "engine/error.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr std::uintmax_t kMostBytes = std::uintmax_t{256} << 20;

struct Group {
  int code = 0;
  std::string_view value;
  std::uint64_t line = 0;  // of the code in the file
};

std::string_view trimmed(std::string_view text) {
  while (!text.empty() && static_cast<unsigned char>(text.front()) <= 32) text.remove_prefix(1);
  while (!text.empty() && static_cast<unsigned char>(text.back()) <= 32) text.remove_suffix(1);
  return text;
}

// Reads codes and values alternately, one on each line; comments (999) are skipped.
class Groups {
 public:
  Groups(std::string_view text, const std::string& name) : text_(text), name_(name) {
    while (!text_.empty() && static_cast<unsigned char>(text_.back()) <= 32) text_.remove_suffix(1);
  }

  [[noreturn]] void fail(std::uint64_t line, const std::string& what) const {
    throw Error(name_ + ":" + std::to_string(line) + ": " + what);
  }
  const Group& now() const { return now_; }
  bool at_end() const { return ended_; }

  void next() {
    do {
      if (at_ >= text_.size()) {
        ended_ = true;
        now_ = {0, "", line_};
        return;
      }
      now_.line = line_ + 1;
      const std::string_view code = trimmed(next_line());
      const auto [end, fault] = std::from_chars(code.data(), code.data() + code.size(), now_.code);
      if (fault != std::errc() || end != code.data() + code.size() || now_.code < -5 || now_.code > 1071)
        fail(now_.line, "needs a group code");
      if (at_ >= text_.size()) fail(now_.line, "the file ends within a pair of code and value");
      now_.value = next_line();
      if (now_.value.ends_with('\r')) now_.value.remove_suffix(1);
    } while (now_.code == 999);
  }

 private:
  std::string_view next_line() {
    const std::size_t end = std::min(text_.find('\n', at_), text_.size());
    const std::string_view line = text_.substr(at_, end - at_);
    at_ = std::min(end + 1, text_.size());
    ++line_;
    return line;
  }

  std::string_view text_;
  const std::string& name_;
  std::size_t at_ = 0;
  std::uint64_t line_ = 0;
  Group now_;
  bool ended_ = false;
};

std::optional<double> number_of(std::string_view text) {
  text = trimmed(text);
  if (text.starts_with('+')) text.remove_prefix(1);
  double value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (fault != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

std::int64_t whole_of(std::string_view text) {
  text = trimmed(text);
  std::int64_t value = 0;
  const auto [end, fault] = std::from_chars(text.data(), text.data() + text.size(), value);
  return fault == std::errc() && end == text.data() + text.size() ? value : 0;
}

class Reader {
 public:
  Reader(std::string_view text, const std::string& name) : groups_(text, name) {}

  DxfDrawing read() {
    for (groups_.next(); !groups_.at_end();) {
      const Group group = groups_.now();
      if (group.code != 0) groups_.fail(group.line, "needs the beginning of a section (code 0)");
      const std::string_view word = trimmed(group.value);
      groups_.next();
      if (word == "EOF") {
        drawing_.has_end = true;
        break;
      }
      if (word != "SECTION") groups_.fail(group.line, "'" + clean_text(std::string(word)) + "' outside of a section");
      section(group.line);
    }
    expand_inserts();
    return std::move(drawing_);
  }

 private:
  struct Block {
    double x = 0, y = 0;
    std::vector<DxfEntity> entities;
  };

  // Reads a block of the section BLOCKS, from behind its BLOCK to its ENDBLK.
  void block() {
    std::string name;
    Block read;
    for (groups_.next(); !groups_.at_end() && groups_.now().code != 0; groups_.next()) {
      const Group& g = groups_.now();
      if (g.code == 2) name = trimmed(g.value);
      if (g.code == 10) read.x = number_of(g.value).value_or(0);
      if (g.code == 20) read.y = number_of(g.value).value_or(0);
    }
    const auto is_now = [&](const char* word) {
      return groups_.now().code == 0 && trimmed(groups_.now().value) == word;
    };
    while (!groups_.at_end() && !is_now("ENDBLK") && !is_now("ENDSEC") && !is_now("BLOCK")) entity(read.entities);
    blocks_.insert_or_assign(upper(name), std::move(read));
  }

  static std::string upper(std::string name) {
    for (char& c : name)
      if (c >= 'a' && c <= 'z') c = static_cast<char>(c - 'a' + 'A');
    return name;
  }

  // Puts the entities of blocks behind the references to them.
  void expand_inserts() {
    std::vector<DxfEntity> all;
    for (DxfEntity& e : drawing_.entities) {
      const DxfEntity placed = e;
      all.push_back(std::move(e));
      if (placed.type == "INSERT") expand(placed, 0, all);
    }
    drawing_.entities = std::move(all);
  }

  void expand(const DxfEntity& insert, int depth, std::vector<DxfEntity>& all) {
    constexpr int kDeepest = 8;
    constexpr std::size_t kMost = 1u << 20;
    const auto found = blocks_.find(upper(insert.text));
    if (found == blocks_.end() || insert.corners.empty() || depth >= kDeepest) return;
    for (DxfEntity e : found->second.entities) {
      if (e.type == "ATTDEF" || e.type == "SEQEND") continue;
      if (all.size() >= kMost) groups_.fail(insert.line, "more than a million entities in blocks");
      place(insert, found->second, e);
      all.push_back(e);
      if (e.type == "INSERT") expand(e, depth + 1, all);
    }
  }

  // Moves an entity of a block to where the block is.
  static void place(const DxfEntity& insert, const Block& block, DxfEntity& e) {
    const double sx = insert.scale_x, sy = insert.scale_y, c = cos_degrees(insert.from_deg),
                 s = cos_degrees(insert.from_deg - 90);
    for (DrawingCorner& corner : e.corners) {
      const double x = sx * (corner.x - block.x), y = sy * (corner.y - block.y);
      corner = {insert.corners[0].x + c * x - s * y, insert.corners[0].y + s * x + c * y,
                sx * sy < 0 ? -corner.bulge : corner.bulge};
    }
    e.radius *= std::sqrt(std::abs(sx * sy));
    if (e.type == "INSERT") e.scale_x *= sx, e.scale_y *= sy;
    if (sx < 0) e.from_deg = 180 - e.from_deg, e.to_deg = 180 - e.to_deg;
    if (sy < 0) e.from_deg = -e.from_deg, e.to_deg = -e.to_deg;
    if (sx * sy < 0) std::swap(e.from_deg, e.to_deg);
    e.from_deg += insert.from_deg, e.to_deg += insert.from_deg;
    if (e.layer == "0") e.layer = insert.layer;
    e.handle.clear();
    e.in_block = true;
    if (!insert.finite) e.finite = false;
  }

  void section(std::uint64_t begun) {
    if (groups_.now().code != 2) groups_.fail(groups_.now().line, "a section without a name");
    const std::string name(trimmed(groups_.now().value));
    drawing_.sections.insert(name);
    groups_.next();
    if (name == "HEADER") header();
    while (!at_end_of_section(begun)) {
      if (name == "ENTITIES" && groups_.now().code == 0)
        entity(drawing_.entities);
      else if (name == "BLOCKS" && groups_.now().code == 0 && trimmed(groups_.now().value) == "BLOCK")
        block();
      else if (name == "TABLES" && groups_.now().code == 0 && trimmed(groups_.now().value) == "LAYER")
        layer();
      else
        groups_.next();
    }
    groups_.next();
  }

  bool at_end_of_section(std::uint64_t begun) const {
    if (groups_.at_end()) groups_.fail(begun, "this section is not closed");
    return groups_.now().code == 0 && trimmed(groups_.now().value) == "ENDSEC";
  }

  void header() {
    std::string variable;
    while (!groups_.at_end() && groups_.now().code != 0) {
      const Group& g = groups_.now();
      if (g.code == 9)
        variable = trimmed(g.value);
      else if (variable == "$ACADVER" && g.code == 1)
        drawing_.version = trimmed(g.value);
      else if (variable == "$INSUNITS" && g.code == 70)
        drawing_.units = whole_of(g.value);
      groups_.next();
    }
  }

  void layer() {
    for (groups_.next(); !groups_.at_end() && groups_.now().code != 0; groups_.next())
      if (groups_.now().code == 2) drawing_.layers.insert(std::string(groups_.now().value));
  }

  double number(DxfEntity& e) {
    const std::optional<double> value = number_of(groups_.now().value);
    if (!value) e.finite = false;
    return value.value_or(0);
  }

  // Reads a group that is a coordinate, a bulge, a radius or an angle. Other groups are left out.
  void measure(DxfEntity& e) {
    const bool is_line = e.type == "LINE", many = e.type == "LWPOLYLINE";
    switch (groups_.now().code) {
      case 10:
        if (many || e.corners.empty()) e.corners.push_back({});
        e.corners.back().x = number(e);
        break;
      case 20:
        if (!e.corners.empty()) e.corners.back().y = number(e);
        break;
      case 11:
        if (is_line) {
          e.corners.resize(1);
          e.corners.push_back({});
          e.corners.back().x = number(e);
        }
        break;
      case 21:
        if (is_line && !e.corners.empty()) e.corners.back().y = number(e);
        break;
      case 13:
      case 14:  // the measured places of a dimension
        if (e.type == "DIMENSION") e.corners.push_back({}), e.corners.back().x = number(e);
        break;
      case 23:
      case 24:
        if (e.type == "DIMENSION" && !e.corners.empty()) e.corners.back().y = number(e);
        break;
      case 41:
        if (e.type == "INSERT") e.scale_x = number(e);
        break;
      case 42:
        if (e.type == "INSERT") e.scale_y = number(e);
        if ((many || e.type == "VERTEX") && !e.corners.empty()) e.corners.back().bulge = number(e);
        break;
      case 40:
        if (e.type == "ARC" || e.type == "CIRCLE") e.radius = number(e);
        break;
      case 50:
        if (e.type == "ARC" || e.type == "INSERT") e.from_deg = number(e);
        break;
      case 51:
        if (e.type == "ARC") e.to_deg = number(e);
        break;
      default:
        break;
    }
  }

  // Reads the groups that belong to one entity, up to the next code 0.
  DxfEntity plain_entity(std::int64_t& flags, bool& paper) {
    DxfEntity e;
    e.type = trimmed(groups_.now().value);
    e.line = groups_.now().line;
    bool in_reactors = false;
    for (groups_.next(); !groups_.at_end() && groups_.now().code != 0; groups_.next()) {
      const Group& g = groups_.now();
      if (g.code == 102) in_reactors = trimmed(g.value).starts_with('{');
      if (in_reactors || g.code == 102) continue;
      switch (g.code) {
        case 5:
          e.handle = trimmed(g.value);
          break;
        case 8:
          e.layer = g.value;
          break;
        case 67:
          paper = whole_of(g.value) == 1;
          break;
        case 70:
          flags = whole_of(g.value);
          break;
        case 1:
          e.text = e.type == "ATTRIB" ? e.text + std::string(g.value) : std::string(g.value);
          break;
        case 2:
          if (e.type == "INSERT") e.text = trimmed(g.value);
          if (e.type == "ATTRIB") e.text = std::string(trimmed(g.value)) + "=" + e.text;
          break;
        default:
          measure(e);
      }
    }
    return e;
  }

  void entity(std::vector<DxfEntity>& entities) {
    std::int64_t flags = 0;
    bool paper = false;
    DxfEntity e = plain_entity(flags, paper);
    if (e.type == "POLYLINE") {
      constexpr std::int64_t kMeshes = 16 | 64;
      e.corners.clear();
      vertices(e, (flags & kMeshes) == 0);
    }
    if (e.type == "POLYLINE" || e.type == "LWPOLYLINE") e.closed = (flags & 1) != 0;
    if (!paper) entities.push_back(std::move(e));
  }

  void vertices(DxfEntity& polyline, bool wanted) {
    while (!groups_.at_end() && groups_.now().code == 0 && trimmed(groups_.now().value) == "VERTEX") {
      std::int64_t flags = 0;
      bool paper = false;
      const DxfEntity vertex = plain_entity(flags, paper);
      constexpr std::int64_t kSplineFrame = 16;
      if (!vertex.finite) polyline.finite = false;
      if (wanted && (flags & kSplineFrame) == 0 && !vertex.corners.empty())
        polyline.corners.push_back(vertex.corners[0]);
    }
    if (!groups_.at_end() && groups_.now().code == 0 && trimmed(groups_.now().value) == "SEQEND") {
      std::int64_t flags = 0;
      bool paper = false;
      plain_entity(flags, paper);
    }
  }

  Groups groups_;
  DxfDrawing drawing_;
  std::map<std::string, Block> blocks_;  // by their names in capitals
};

}  // namespace

DxfDrawing parse_dxf(std::string_view text, const std::string& name) {
  if (text.starts_with("AutoCAD Binary DXF")) throw Error(name + ": a binary DXF; save it as ASCII");
  return Reader(text, name).read();
}

DxfDrawing read_dxf(const std::filesystem::path& path) {
  std::error_code missing;
  const std::uintmax_t bytes = std::filesystem::file_size(path, missing);
  if (missing) throw Error(path.string() + ": cannot be read: " + missing.message());
  if (bytes > kMostBytes) throw Error(path.string() + ": larger than 256 MiB");
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) throw Error(path.string() + ": cannot be read");
  return parse_dxf(text, path.string());
}

bool is_dxf_file(const std::filesystem::path& path) {
  const std::string extension = path.extension().string();
  return extension == ".dxf" || extension == ".DXF" || extension == ".Dxf";
}

}  // namespace ilot
