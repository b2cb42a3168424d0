// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/facade_json.h"

#include <array>
#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <nlohmann/json.hpp>

#include "engine/deliverables/tables/json_node.h"
#include "engine/error.h"
#include "engine/json_fault.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr int kVersion = 1;
constexpr std::array<const char*, 3> kRegion{"facade", "element", "irregularity"};

Json json_of(Vec3 p) {
  return {p.x, p.y, p.z};
}

Json json_of(const std::optional<double>& value) {
  return value ? Json(*value) : Json(nullptr);
}

// What a person drew has no stated error.
Json error_json(double error_m, bool by_hand) {
  return by_hand && error_m == 0 ? Json(nullptr) : Json(error_m);
}

Json json_of(const FacadeEdge& e) {
  return {{"status", name_of(e.status)},
          {"points", e.points},
          {"rms_m", e.rms_m},
          {"error_m", error_json(e.error_m, e.status == DrawnStatus::by_hand)},
          {"moved_m", e.moved_m},
          {"occluded_share", json_of(e.occluded_share)},
          {"covered_share", e.covered_share}};
}

Json json_of(const FacadeFace& f) {
  return {{"name", f.name}, {"points", f.points}, {"rms_m", f.rms_m}, {"occluded_share", json_of(f.occluded_share)}};
}

Json json_of(const FacadeArc& a) {
  return {{"centre", json_of(a.centre)}, {"radius_m", a.radius_m}, {"from_deg", a.from_deg}, {"to_deg", a.to_deg}};
}

Json json_of(const FacadeElement& e);

template <class Item>
Json list_of(const std::vector<Item>& items) {
  Json list = Json::array();
  for (const Item& item : items) list.push_back(json_of(item));
  return list;
}

Json json_of(const FacadeBody& b) {
  Json json{{"closed", b.closed}, {"vertices", list_of(b.vertices)}, {"faces", Json::array()}};
  for (const auto& face : b.faces) json["faces"].push_back(face);
  return json;
}

Json json_of(const FacadeElement& e) {
  Json json{{"id", e.id},
            {"kind", e.kind},
            {"region", kRegion[static_cast<std::size_t>(e.region)]},
            {"opening", e.opening},
            {"family", e.family},
            {"row", e.row},
            {"column", e.column},
            {"status", name_of(e.status)},
            {"reason", e.reason}};
  json["ring"] = list_of(e.ring);
  json["edges"] = list_of(e.edges);
  json["arcs"] = list_of(e.arcs);
  json["width_m"] = e.width_m;
  json["height_m"] = e.height_m;
  json["depth_m"] = e.depth_m;
  const bool by_hand = e.status == DrawnStatus::by_hand;
  json["width_error_m"] = error_json(e.width_error_m, by_hand);
  json["height_error_m"] = error_json(e.height_error_m, by_hand);
  json["depth_error_m"] = error_json(e.depth_error_m, by_hand);
  json["points"] = e.points;
  json["faces"] = list_of(e.faces);
  json["body"] = json_of(e.body);
  return json;
}

// Files that were written before shares existed have none.
std::optional<double> share_of(const JsonNode& node, const char* key) {
  if (!node.has(key) || node.json.at(key).is_null()) return std::nullopt;
  const double share = node.at(key).number();
  if (share < 0 || share > 1) node.at(key).fail("needs a number from 0 to 1, or null");
  return share;
}

// The error of what a person drew is null.
double error_of(const JsonNode& node, const char* key) {
  return node.at(key).json.is_null() ? 0 : node.at(key).number();
}

DrawnStatus status_of(const JsonNode& node) {
  return static_cast<DrawnStatus>(node.choice(kDrawnStatusNames, "status: seen, completed, occluded or by hand"));
}

FacadeEdge edge_of(const JsonNode& r) {
  return {status_of(r.at("status")),
          r.at("points").count(),
          r.at("rms_m").number(),
          error_of(r, "error_m"),
          r.at("moved_m").number(),
          share_of(r, "occluded_share"),
          share_of(r, "covered_share").value_or(0)};
}

FacadeFace face_of(const JsonNode& r) {
  return {r.at("name").text(), r.at("points").count(), r.at("rms_m").number(), share_of(r, "occluded_share")};
}

FacadeArc arc_of(const JsonNode& r) {
  return {r.at("centre").position(), r.at("radius_m").number(), r.at("from_deg").number(), r.at("to_deg").number()};
}

FacadeBody body_of(const JsonNode& r) {
  FacadeBody b;
  b.closed = r.at("closed").flag();
  b.vertices = r.at("vertices").list([](const JsonNode& corner) { return corner.position(); });
  b.faces = r.at("faces").list([&](const JsonNode& face) {
    auto corners = face.list([](const JsonNode& corner) { return corner.id(); });
    if (corners.size() < 3) face.fail("needs three corners or more");
    for (const std::uint32_t i : corners)
      if (i >= b.vertices.size()) face.fail("names a vertex that is not there");
    return corners;
  });
  return b;
}

FacadeElement element_of(const JsonNode& r) {
  FacadeElement e;
  e.id = r.at("id").id();
  e.kind = r.at("kind").text();
  if (r.json.contains("region"))  // absent in files that were written before regions existed
    e.region = static_cast<FacadeRegion>(r.at("region").choice(kRegion, "region: facade, element or irregularity"));
  e.opening = r.at("opening").flag();
  e.family = r.at("family").id();
  e.row = r.at("row").id();
  e.column = r.at("column").id();
  e.status = status_of(r.at("status"));
  e.reason = r.at("reason").text();
  e.ring = r.at("ring").list([](const JsonNode& corner) { return corner.position(); });
  if (e.ring.size() < 3) r.at("ring").fail("needs three corners or more");
  e.edges = r.at("edges").list(edge_of);
  if (!e.edges.empty() && e.edges.size() != e.ring.size()) r.at("edges").fail("needs one entry a corner, or none");
  e.arcs = r.at("arcs").list(arc_of);
  e.width_m = r.at("width_m").number();
  e.height_m = r.at("height_m").number();
  e.depth_m = r.at("depth_m").number();
  e.width_error_m = error_of(r, "width_error_m");
  e.height_error_m = error_of(r, "height_error_m");
  e.depth_error_m = error_of(r, "depth_error_m");
  e.points = r.at("points").count();
  if (r.json.contains("faces")) e.faces = r.at("faces").list(face_of);
  if (r.json.contains("body")) e.body = body_of(r.at("body"));
  return e;
}

}  // namespace

std::string facade_json(const Facade& f) {
  Json json{{"type", "ilot facade"}, {"version", kVersion}, {"facade", f.id}, {"crs", f.crs}};
  json["frame"] = {
      {"origin", json_of(f.origin)}, {"right", json_of(f.right)}, {"up", json_of(f.up)}, {"out", json_of(f.out)}};
  json["width_m"] = f.width_m;
  json["height_m"] = f.height_m;
  json["elements"] = list_of(f.elements);
  return json.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

void write_facade_json(const std::filesystem::path& path, const Facade& facade) {
  write_whole_file(path, facade_json(facade));
}

Facade parse_facade_json(std::string_view text, const std::string& name) {
  nlohmann::json json;
  try {
    json = nlohmann::json::parse(text.begin(), text.end());
  } catch (const nlohmann::json::exception& fault) {
    throw Error(name + ": broken JSON: " + json_fault(fault.what()));
  }
  const JsonNode r{json, name};
  if (r.at("type").text() != "ilot facade" || r.at("version").count() != kVersion)
    r.fail("no facade of version " + std::to_string(kVersion));
  Facade f;
  f.id = r.at("facade").id();
  f.crs = r.at("crs").text();
  f.origin = r.at("frame").at("origin").position();
  f.right = r.at("frame").at("right").position();
  f.up = r.at("frame").at("up").position();
  f.out = r.at("frame").at("out").position();
  f.width_m = r.at("width_m").number();
  f.height_m = r.at("height_m").number();
  f.elements = r.at("elements").list(element_of);
  return f;
}

Facade read_facade_json(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  if (!file.is_open() || file.bad()) throw Error(path.string() + ": cannot be read");
  return parse_facade_json(text, path.string());
}

}  // namespace ilot
