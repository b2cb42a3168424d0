// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/read_area.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>

#include "engine/error.h"

namespace ilot {
namespace {

using Json = nlohmann::json;

constexpr std::uintmax_t kMaxAreaBytes = 64u << 20;
constexpr int kMaxDepth = 16;  // nested collections

Error area_error(const std::string& where, const std::string& sentence) {
  return Error(where + ": " + sentence, ExitCode::usage);
}

// Reads a number at the front of the text and removes it from the text; nullopt when there is none or it is not finite.
std::optional<double> take_number(std::string_view& text) {
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  double value = 0;
  const auto [end, code] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (code != std::errc() || !std::isfinite(value)) return std::nullopt;
  text.remove_prefix(static_cast<std::size_t>(end - text.data()));
  return value;
}

void add_ring(Area& area, AreaRing ring, const std::string& name) {
  if (ring.size() > 1 && ring.front() == ring.back()) ring.pop_back();
  if (ring.size() < 3) throw area_error(name, "a ring has fewer than three different corners");
  area.rings.push_back(std::move(ring));
}

Area with_box(Area area, const std::string& name) {
  if (area.rings.empty()) throw area_error(name, "contains no polygon");
  const auto& first = area.rings.front().front();
  area.min_x = area.max_x = first[0];
  area.min_y = area.max_y = first[1];
  for (const AreaRing& ring : area.rings) {
    for (const auto& [x, y] : ring) {
      area.min_x = std::min(area.min_x, x);
      area.max_x = std::max(area.max_x, x);
      area.min_y = std::min(area.min_y, y);
      area.max_y = std::max(area.max_y, y);
    }
  }
  return area;
}

void add_polygon(Area& area, const Json& rings, const std::string& name) {
  for (const Json& corners : rings) {
    AreaRing ring;
    for (const Json& corner : corners) {
      ring.push_back({corner.at(0).get<double>(), corner.at(1).get<double>()});
      if (!std::isfinite(ring.back()[0]) || !std::isfinite(ring.back()[1])) {
        throw area_error(name, "a coordinate is not finite");
      }
    }
    add_ring(area, std::move(ring), name);
  }
}

void add_geojson(Area& area, const Json& object, const std::string& name, int depth) {
  if (depth > kMaxDepth) throw area_error(name, "collections nest too deeply");
  const std::string type = object.at("type").get<std::string>();
  if (type == "FeatureCollection") {
    for (const Json& feature : object.at("features")) add_geojson(area, feature, name, depth + 1);
  } else if (type == "Feature") {
    add_geojson(area, object.at("geometry"), name, depth + 1);
  } else if (type == "GeometryCollection") {
    for (const Json& geometry : object.at("geometries")) add_geojson(area, geometry, name, depth + 1);
  } else if (type == "Polygon") {
    add_polygon(area, object.at("coordinates"), name);
  } else if (type == "MultiPolygon") {
    for (const Json& polygon : object.at("coordinates")) add_polygon(area, polygon, name);
  } else {
    throw area_error(name, "'" + type + "' is not an area: Polygon or MultiPolygon is");
  }
}

// WKT: rings are the innermost parentheses, independent of the text around them.
class WktParser {
 public:
  WktParser(std::string_view text, const std::string& name) : text_(text), name_(name) {}

  Area parse() {
    std::string word = take_word();
    if (word.starts_with("SRID")) {
      text_.remove_prefix(std::min(text_.size(), text_.find(';') == text_.npos ? text_.size() : text_.find(';') + 1));
      word = take_word();
    }
    if (word != "POLYGON" && word != "MULTIPOLYGON") {
      throw area_error(name_, "is neither GeoJSON nor a WKT POLYGON or MULTIPOLYGON");
    }
    if (const std::string dimension = take_word(); !dimension.empty() && dimension != "Z") {
      throw area_error(name_, "WKT: '" + dimension + "' is not expected after " + word);
    }
    const int depth = word == "POLYGON" ? 1 : 2;
    parse_level(depth);
    skip_space();
    if (!text_.empty()) throw area_error(name_, "WKT: text after the last parenthesis");
    return std::move(area_);
  }

 private:
  void skip_space() {
    while (!text_.empty() && std::isspace(static_cast<unsigned char>(text_.front()))) text_.remove_prefix(1);
  }
  std::string take_word() {
    skip_space();
    std::string word;
    while (!text_.empty() && std::isalpha(static_cast<unsigned char>(text_.front()))) {
      word += static_cast<char>(std::toupper(static_cast<unsigned char>(text_.front())));
      text_.remove_prefix(1);
    }
    return word;
  }
  bool take(char wanted) {
    skip_space();
    if (text_.empty() || text_.front() != wanted) return false;
    text_.remove_prefix(1);
    return true;
  }
  void parse_level(int depth) {
    if (!take('(')) throw area_error(name_, "WKT: '(' expected");
    do {
      if (depth > 0) {
        parse_level(depth - 1);
      } else {
        parse_ring();
        break;
      }
    } while (take(','));
    if (!take(')')) throw area_error(name_, "WKT: ')' expected");
  }
  void parse_ring() {
    AreaRing ring;
    do {
      const auto x = take_number(text_);
      const auto y = take_number(text_);
      if (!x || !y) throw area_error(name_, "WKT: two coordinates expected");
      while (take_number(text_)) continue;
      ring.push_back({*x, *y});
    } while (take(','));
    add_ring(area_, std::move(ring), name_);
  }

  std::string_view text_;
  const std::string& name_;
  Area area_;
};

}  // namespace

Area parse_bounds(std::string_view text) {
  const std::string name = "--bounds " + std::string(text.substr(0, 200));
  double v[4];
  std::string_view rest = text;
  for (int i = 0; i < 4; ++i) {
    const auto number = take_number(rest);
    if (!number) throw area_error(name, "four numbers X0,Y0,X1,Y1 expected, in the units of the CRS");
    v[i] = *number;
    if (i < 3 && (rest.empty() || rest.front() != ',')) throw area_error(name, "four numbers X0,Y0,X1,Y1 expected");
    if (i < 3) rest.remove_prefix(1);
  }
  if (!rest.empty()) throw area_error(name, "four numbers X0,Y0,X1,Y1 expected, and nothing after them");
  Area area{std::min(v[0], v[2]), std::min(v[1], v[3]), std::max(v[0], v[2]), std::max(v[1], v[3]), {}};
  if (area.min_x == area.max_x || area.min_y == area.max_y) throw area_error(name, "the box has no size");
  return area;
}

Area parse_area(std::string_view text, const std::string& name) {
  const std::size_t start = text.find_first_not_of(" \t\r\n\xef\xbb\xbf");
  if (start == text.npos || text[start] != '{') {
    return with_box(WktParser(start == text.npos ? text : text.substr(start), name).parse(), name);
  }
  try {
    Area area;
    add_geojson(area, Json::parse(text.substr(start)), name, 0);
    return with_box(std::move(area), name);
  } catch (const Json::exception& problem) {
    throw area_error(name, std::string("is not GeoJSON with polygons: ") + problem.what());
  }
}

Area read_area(const std::filesystem::path& path) {
  std::error_code code;
  const std::uintmax_t size = std::filesystem::file_size(path, code);
  if (code) throw area_error(path.string(), "cannot read the area: " + code.message());
  if (size > kMaxAreaBytes) throw area_error(path.string(), "larger than 64 MiB: simplify the area");
  std::string text(static_cast<std::size_t>(size), '\0');
  std::ifstream file(path, std::ios::binary);
  file.read(text.data(), static_cast<std::streamsize>(size));
  if (!file) throw area_error(path.string(), "cannot read the area");
  return parse_area(text, path.string());
}

}  // namespace ilot
