// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/truth.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/error.h"

namespace ilot {
namespace {

using Json = nlohmann::json;

// A value and its position in the file, for messages.
struct TruthNode {
  const Json& json;
  std::string place;

  [[noreturn]] void fail(const std::string& what) const { throw Error(fmt::format("{}: {}", place, what)); }

  bool has(const char* key) const { return json.is_object() && json.contains(key); }

  TruthNode at(const char* key) const {
    if (!has(key)) fail(fmt::format("'{}' is missing", key));
    return {json[key], fmt::format("{}.{}", place, key)};
  }

  template <class Visit>
  void each(Visit visit) const {
    if (!json.is_array()) fail("needs a list");
    for (std::size_t i = 0; i < json.size(); ++i) visit(TruthNode{json[i], fmt::format("{}[{}]", place, i)});
  }

  double number() const {
    if (!json.is_number() || !std::isfinite(json.get<double>())) fail("needs a finite number");
    return json.get<double>();
  }

  std::uint64_t count() const {
    if (!json.is_number_integer() || json < 0) fail("needs a whole number from 0 on");
    return json.get<std::uint64_t>();
  }

  std::uint32_t id() const {
    const std::uint64_t value = count();
    if (value > std::numeric_limits<std::uint32_t>::max()) fail("needs a whole number below 2^32");
    return static_cast<std::uint32_t>(value);
  }

  std::string text() const {
    if (!json.is_string()) fail("needs a text");
    return json.get<std::string>();
  }

  Vec3 position() const {
    if (!json.is_array() || json.size() != 3) fail("needs three numbers");
    return {TruthNode{json[0], place}.number(), TruthNode{json[1], place}.number(), TruthNode{json[2], place}.number()};
  }

  Ring3 ring() const {
    Ring3 ring;
    each([&](const TruthNode& corner) { ring.push_back(corner.position()); });
    if (ring.size() < 3) fail("needs three corners or more");
    return ring;
  }
};

TruePlane plane_of(const TruthNode& node) {
  TruePlane plane{node.at("id").id(), node.has("class") ? node.at("class").text() : "", {}, {}};
  const TruthNode equation = node.at("plane");
  std::vector<double> v;
  equation.each([&](const TruthNode& n) { v.push_back(n.number()); });
  const double length = v.size() == 4 ? norm({v[0], v[1], v[2]}) : 0;
  if (!(length > 0)) equation.fail("needs a, b, c, d of a plane");
  plane.plane = {(1 / length) * Vec3{v[0], v[1], v[2]}, v[3] / length};
  if (!node.has("polygons")) return plane;
  node.at("polygons").each([&](const TruthNode& n) {
    TruePolygon polygon{n.has("building") ? n.at("building").id() : 0, n.at("ring").ring(), {}};
    if (n.has("holes")) n.at("holes").each([&](const TruthNode& hole) { polygon.holes.push_back(hole.ring()); });
    plane.polygons.push_back(std::move(polygon));
  });
  return plane;
}

TrueElement element_of(const TruthNode& node) {
  TrueElement e;
  const auto number = [&](const char* key) { return node.has(key) ? node.at(key).number() : 0.0; };
  const auto id = [&](const char* key) { return node.has(key) ? node.at(key).id() : 0u; };
  e.id = node.at("id").id();
  if (node.has("kind")) e.kind = node.at("kind").text();
  e.facade = id("facade");
  e.row = id("row");
  e.column = id("column");
  if (node.has("ring")) e.ring = node.at("ring").ring();
  e.width_m = number("width_m");
  e.height_m = number("height_m");
  e.depth_m = number("depth_m");
  return e;
}

std::map<std::uint32_t, std::string> classes_of(const TruthNode& node) {
  std::map<std::uint32_t, std::string> classes;
  if (!node.json.is_object()) node.fail("needs an object");
  for (const auto& [key, value] : node.json.items()) {
    std::uint32_t number = 0;
    const auto [end, code] = std::from_chars(key.data(), key.data() + key.size(), number);
    if (code != std::errc() || end != key.data() + key.size() || number > 255)
      node.fail(fmt::format("'{}' is no class from 0 to 255", key));
    classes[number] = TruthNode{value, node.place + "." + key}.text();
  }
  return classes;
}

template <class Item, class Make>
void read_list(const TruthNode& root, const char* key, std::vector<Item>& out, bool& present, Make make) {
  present = root.has(key) && root.json[key].is_array();
  if (root.has(key) && (present || key != std::string_view("buildings")))  // in old files `buildings` is a count
    root.at(key).each([&](const TruthNode& node) { out.push_back(make(node)); });
}

}  // namespace

Truth parse_truth(std::string_view text, const std::string& name) {
  Json json;
  try {
    json = Json::parse(text.begin(), text.end());
  } catch (const Json::exception& fault) {
    throw Error(name + ": broken JSON: " + fault.what());
  }
  const TruthNode root{json, name};
  if (!json.is_object()) root.fail("needs a JSON object");
  Truth truth;
  bool has_planes = false, has_elements = false;
  if (root.has("classes")) truth.classes = classes_of(root.at("classes"));
  read_list(root, "planes", truth.planes, has_planes, plane_of);
  read_list(root, "elements", truth.elements, has_elements, element_of);
  read_list(root, "openings", truth.openings, truth.has_openings, [](const TruthNode& n) {
    return TrueOpening{n.at("id").id(), n.has("facade") ? n.at("facade").id() : 0, n.at("ring").ring()};
  });
  read_list(root, "control_points", truth.control_points, truth.has_control_points, [](const TruthNode& n) {
    return TrueControlPoint{n.at("group").text(), n.has("element") ? n.at("element").id() : 0,
                            n.at("position").position()};
  });
  read_list(root, "objects", truth.objects, truth.has_objects, [](const TruthNode& n) {
    return TrueObject{n.at("id").id(), n.at("class").text(), n.has("points") ? n.at("points").count() : 0};
  });
  read_list(root, "buildings", truth.buildings, truth.has_buildings,
            [](const TruthNode& n) { return n.at("id").id(); });
  return truth;
}

Truth truth_of_models(std::span<const PolygonModel> models) {
  Truth truth;
  truth.has_buildings = true;
  for (const PolygonModel& model : models) {
    truth.buildings.push_back(static_cast<std::uint32_t>(truth.buildings.size() + 1));
    const std::vector<bool> roofs = roof_faces(model);
    for (std::size_t f = 0; f < roofs.size(); ++f) {
      const Vec3 n = face_normal(model, model.faces[f]);
      if (!roofs[f] || !(norm(n) > 0)) continue;
      std::vector<Ring3> rings;
      for (const std::vector<std::uint32_t>& ring : model.faces[f].rings) {
        rings.emplace_back();
        for (const std::uint32_t i : ring) rings.back().push_back(model.vertices[i]);
      }
      const Vec3 unit = (1 / norm(n)) * n;
      TruePolygon polygon{truth.buildings.back(), rings[0], {rings.begin() + 1, rings.end()}};
      const auto id = static_cast<std::uint32_t>(truth.planes.size() + 1);
      truth.planes.push_back({id, "roof", {unit, -dot(unit, polygon.ring[0])}, {std::move(polygon)}});
    }
  }
  return truth;
}

Truth read_truth(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw Error(path.string() + ": no such file", ExitCode::usage);
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) throw Error(path.string() + ": cannot be read");
  return parse_truth(text, path.string());
}

}  // namespace ilot
