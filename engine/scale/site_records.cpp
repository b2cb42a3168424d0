// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/site_records.h"

#include <utility>

namespace ilot {
namespace {

using nlohmann::json;
using Attributes = std::vector<std::pair<std::string, AttributeValue>>;

json attributes_json(const Attributes& attributes) {
  json list = json::array();
  for (const auto& [name, value] : attributes)
    list.push_back({name, std::visit([](const auto& v) { return json(v); }, value)});
  return list;
}

AttributeValue attribute_of(const json& value) {
  if (value.is_boolean()) return value.get<bool>();
  if (value.is_number_integer()) return value.get<std::int64_t>();
  if (value.is_number()) return value.get<double>();
  return value.get<std::string>();
}

Attributes attributes_of(const json& list) {
  Attributes attributes;
  for (const json& entry : list) attributes.emplace_back(entry.at(0).get<std::string>(), attribute_of(entry.at(1)));
  return attributes;
}

json level_json(const Building& level) {
  json vertices = json::array(), surfaces = json::array();
  for (const Vec3& v : level.vertices) vertices.insert(vertices.end(), {v.x, v.y, v.z});
  for (const BuildingSurface& s : level.surfaces) surfaces.push_back({static_cast<int>(s.kind), s.plane_id, s.rings});
  return {{"id", level.id},
          {"lod", level.lod},
          {"vertices", vertices},
          {"surfaces", surfaces},
          {"attributes", attributes_json(level.attributes)}};
}

Building level_of(const json& record) {
  Building level;
  level.id = record.at("id").get<std::string>();
  level.lod = record.at("lod").get<std::string>();
  const auto v = record.at("vertices").get<std::vector<double>>();
  for (std::size_t i = 0; i + 2 < v.size(); i += 3) level.vertices.push_back({v[i], v[i + 1], v[i + 2]});
  for (const json& s : record.at("surfaces"))
    level.surfaces.push_back({static_cast<SurfaceKind>(s.at(0).get<int>()), s.at(1).get<std::uint32_t>(),
                              s.at(2).get<std::vector<std::vector<std::uint32_t>>>()});
  level.attributes = attributes_of(record.at("attributes"));
  return level;
}

}  // namespace

json record_of(const NumberedSite& n) {
  json rings = json::array();
  for (const auto& ring : n.site.outline.polygon) {
    json corners = json::array();
    for (const Point2 p : ring) corners.insert(corners.end(), {p.x, p.y});
    rings.push_back(std::move(corners));
  }
  const GridBox& box = n.site.outline.box;
  return {{"number", n.number},
          {"own", n.own},
          {"outside", n.outside},
          {"sampled", n.sampled},
          {"id", n.site.id},
          {"anchor", {n.site.outline.x, n.site.outline.y}},
          {"rings", rings},
          {"box", {box.min_x, box.min_y, box.max_x, box.max_y}},
          {"reason", n.site.reason},
          {"repair", n.site.repair},
          {"attributes", attributes_json(n.site.attributes)}};
}

NumberedSite numbered_site(const json& record) {
  NumberedSite n;
  n.number = record.at("number").get<std::uint64_t>();
  n.own = record.at("own").get<bool>();
  n.outside = record.at("outside").get<bool>();
  n.sampled = record.at("sampled").get<bool>();
  n.site.id = record.at("id").get<std::string>();
  PlacedOutline& outline = n.site.outline;
  outline.x = record.at("anchor").at(0).get<std::int64_t>();
  outline.y = record.at("anchor").at(1).get<std::int64_t>();
  for (const json& corners : record.at("rings")) {
    auto& ring = outline.polygon.emplace_back();
    for (std::size_t i = 0; i + 1 < corners.size(); i += 2)
      ring.push_back({corners[i].get<decltype(Point2::x)>(), corners[i + 1].get<decltype(Point2::y)>()});
  }
  const auto box = record.at("box").get<std::array<std::int64_t, 4>>();
  outline.box = {box[0], box[1], box[2], box[3]};
  n.site.reason = record.at("reason").get<std::string>();
  n.site.repair = record.at("repair").get<std::string>();
  n.site.attributes = attributes_of(record.at("attributes"));
  return n;
}

json without_number(const NumberedSite& site) {
  json record = record_of(site);
  record.erase("number");
  return record;
}

json record_of(const BuiltSite& built) {
  json levels = json::array();
  for (const Building& level : built.result.levels) levels.push_back(level_json(level));
  return {{"labelled", built.labelled},    {"status", static_cast<int>(built.result.status)},
          {"reason", built.result.reason}, {"thinned", built.result.thinned},
          {"planes", built.result.planes}, {"levels", levels}};
}

bool is_building(const json& record) {
  return record.contains("levels");
}

BuiltSite built_site(const json& record) {
  BuiltSite built;
  built.labelled = record.at("labelled").get<std::uint64_t>();
  built.result.status = static_cast<RoofStatus>(record.at("status").get<int>());
  built.result.reason = record.at("reason").get<std::string>();
  built.result.thinned = record.at("thinned").get<bool>();
  built.result.planes = record.at("planes").get<std::uint32_t>();
  for (const json& level : record.at("levels")) built.result.levels.push_back(level_of(level));
  return built;
}

}  // namespace ilot
