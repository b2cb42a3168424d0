// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/truth.h"

#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/deliverables/tables/json_node.h"
#include "engine/error.h"
#include "engine/json_fault.h"

namespace ilot {
namespace {

using Json = nlohmann::json;

Ring3 ring_of(const JsonNode& node) {
  Ring3 ring;
  node.each([&](const JsonNode& corner) { ring.push_back(corner.position()); });
  if (ring.size() < 3) node.fail("needs three corners or more");
  return ring;
}

TruePlane plane_of(const JsonNode& node) {
  TruePlane plane{node.at("id").id(), node.has("class") ? node.at("class").text() : "", {}, {}};
  const JsonNode equation = node.at("plane");
  std::vector<double> v;
  equation.each([&](const JsonNode& n) { v.push_back(n.number()); });
  const double length = v.size() == 4 ? norm({v[0], v[1], v[2]}) : 0;
  if (!(length > 0)) equation.fail("needs a, b, c, d of a plane");
  plane.plane = {(1 / length) * Vec3{v[0], v[1], v[2]}, v[3] / length};
  if (!node.has("polygons")) return plane;
  node.at("polygons").each([&](const JsonNode& n) {
    TruePolygon polygon{n.has("building") ? n.at("building").id() : 0, ring_of(n.at("ring")), {}};
    if (n.has("holes")) n.at("holes").each([&](const JsonNode& hole) { polygon.holes.push_back(ring_of(hole)); });
    plane.polygons.push_back(std::move(polygon));
  });
  return plane;
}

TrueElement element_of(const JsonNode& node) {
  TrueElement e;
  const auto number = [&](const char* key) { return node.has(key) ? node.at(key).number() : 0.0; };
  const auto id = [&](const char* key) { return node.has(key) ? node.at(key).id() : 0u; };
  e.id = node.at("id").id();
  if (node.has("kind")) e.kind = node.at("kind").text();
  e.facade = id("facade");
  e.row = id("row");
  e.column = id("column");
  if (node.has("ring")) e.ring = ring_of(node.at("ring"));
  e.width_m = number("width_m");
  e.height_m = number("height_m");
  e.depth_m = number("depth_m");
  return e;
}

TrueTree tree_of(const JsonNode& node) {
  return {node.at("id").id(), node.at("base").position(), node.at("height_m").number(),
          node.has("crown_base_m") ? node.at("crown_base_m").number() : 0,
          node.has("crown_radius_m") ? node.at("crown_radius_m").number() : 0};
}

TrueKerb kerb_of(const JsonNode& node) {
  TrueKerb kerb{{}, node.at("height_m").number()};
  node.at("line").each([&](const JsonNode& vertex) { kerb.line.push_back(vertex.position()); });
  if (kerb.line.size() < 2) node.fail("needs a line of two vertices or more");
  return kerb;
}

TruePavement pavement_of(const JsonNode& node) {
  TruePavement pavement{{}, node.at("width_m").number(), node.has("to_facade_m") ? node.at("to_facade_m").number() : 0};
  node.at("line").each([&](const JsonNode& vertex) { pavement.line.push_back(vertex.position()); });
  if (pavement.line.size() < 2) node.fail("needs a line of two vertices or more");
  return pavement;
}

// Adds the outlines of a list of objects, trees or plants. Those that are higher than 2.2 m have none.
void add_outlines(const JsonNode& root, const char* key, std::vector<TrueOutline>& out) {
  if (!root.has(key) || !root.json[key].is_array()) return;
  root.at(key).each([&](const JsonNode& node) {
    if (!node.has("outline")) return;
    const auto is = [&](const char* name, const char* value) {
      return node.has(name) && node.at(name).text() == value;
    };
    out.push_back({ring_of(node.at("outline")), is("class", "fence") || is("variant", "hedge"),
                   node.has("moves") || node.has("sometimes")});
  });
}

std::map<std::uint32_t, std::string> classes_of(const JsonNode& node) {
  std::map<std::uint32_t, std::string> classes;
  if (!node.json.is_object()) node.fail("needs an object");
  for (const auto& [key, value] : node.json.items()) {
    std::uint32_t number = 0;
    const auto [end, code] = std::from_chars(key.data(), key.data() + key.size(), number);
    if (code != std::errc() || end != key.data() + key.size() || number > 255)
      node.fail(fmt::format("'{}' is no class from 0 to 255", key));
    classes[number] = JsonNode{value, node.place + "." + key}.text();
  }
  return classes;
}

template <class Item, class Make>
void read_list(const JsonNode& root, const char* key, std::vector<Item>& out, bool& present, Make make) {
  present = root.has(key) && root.json[key].is_array();
  if (root.has(key) && (present || key != std::string_view("buildings")))  // in old files `buildings` is a count
    root.at(key).each([&](const JsonNode& node) { out.push_back(make(node)); });
}

}  // namespace

Truth parse_truth(std::string_view text, const std::string& name) {
  Json json;
  try {
    json = Json::parse(text.begin(), text.end());
  } catch (const Json::exception& fault) {
    throw Error(name + ": broken JSON: " + json_fault(fault.what()));
  }
  const JsonNode root{json, name};
  if (!json.is_object()) root.fail("needs a JSON object");
  Truth truth;
  bool has_planes = false, has_elements = false;
  if (root.has("classes")) truth.classes = classes_of(root.at("classes"));
  read_list(root, "planes", truth.planes, has_planes, plane_of);
  read_list(root, "elements", truth.elements, has_elements, element_of);
  read_list(root, "openings", truth.openings, truth.has_openings, [](const JsonNode& n) {
    return TrueOpening{n.at("id").id(), n.has("facade") ? n.at("facade").id() : 0, ring_of(n.at("ring"))};
  });
  read_list(root, "control_points", truth.control_points, truth.has_control_points, [](const JsonNode& n) {
    return TrueControlPoint{n.at("group").text(), n.has("element") ? n.at("element").id() : 0,
                            n.at("position").position()};
  });
  read_list(root, "objects", truth.objects, truth.has_objects, [](const JsonNode& n) {
    return TrueObject{n.at("id").id(), n.at("class").text(), n.has("points") ? n.at("points").count() : 0,
                      n.has("group")};
  });
  read_list(root, "trees", truth.trees, truth.has_trees, tree_of);
  read_list(root, "kerbs", truth.kerbs, truth.has_kerbs, kerb_of);
  read_list(root, "pavements", truth.pavements, truth.has_pavements, pavement_of);
  read_list(root, "carriageways", truth.carriageways, truth.has_carriageways,
            [](const JsonNode& n) { return TrueCarriageway{ring_of(n.at("ring"))}; });
  for (const char* key : {"objects", "trees", "plants"}) add_outlines(root, key, truth.outlines);
  read_list(root, "buildings", truth.buildings, truth.has_buildings, [](const JsonNode& n) { return n.at("id").id(); });
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
