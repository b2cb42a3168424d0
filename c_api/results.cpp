// SPDX-License-Identifier: Apache-2.0
// The results of a run as JSON, over run.h, planes.h, roofs.h, facades.h and streets.h.
#include <nlohmann/json.hpp>

#include "c_api/guard.h"
#include "ilot/facades.h"
#include "ilot/planes.h"
#include "ilot/roofs.h"
#include "ilot/run.h"
#include "ilot/streets.h"

namespace ilot::c {

namespace {

using Json = nlohmann::json;

template <typename T, typename Convert>
Json list_of(const std::vector<T>& values, const Convert& convert) {
  Json list = Json::array();
  for (const T& value : values) list.push_back(convert(value));
  return list;
}

Json ring_json(const std::vector<Vec3>& ring) {
  return list_of(ring, json_of);
}

std::string text_of_path(const std::filesystem::path& path) {
  return path.generic_string();
}

Json run_json(const RunReport& r) {
  return {{"exit", static_cast<int>(r.exit)},
          {"folder", r.folder.string()},
          {"products", r.products},
          {"points_read", r.points_read},
          {"points_labelled", r.points_labelled},
          {"points_unlabelled", r.points_unlabelled},
          {"points_rejected", r.points_rejected},
          {"skipped", list_of(r.skipped,
                              [](const SkippedRecord& s) {
                                return Json{{"what", s.what}, {"where", s.where}, {"reason", s.reason}};
                              })},
          {"warnings", r.warnings},
          {"chosen", r.chosen},
          {"files", list_of(r.files, text_of_path)},
          {"clouds", list_of(r.clouds, text_of_path)},
          {"seconds", r.seconds},
          {"peak_memory_bytes", r.peak_memory_bytes},
          {"result_hash", r.result_hash}};
}

Json plane_json(const Segment& s, const Outline& outline) {
  return {{"id", s.id},
          {"normal", json_of(s.plane.n)},
          {"d", s.plane.d},
          {"points", s.points},
          {"centroid", json_of(s.centroid)},
          {"rms_m", s.rms_m},
          {"epsilon_m", s.epsilon_m},
          {"area_m2", s.area_m2},
          {"confidence", s.confidence},
          {"outline", list_of(outline.parts, [](const Outline::Part& part) { return list_of(part, ring_json); })}};
}

constexpr const char* kSurfaceKinds[] = {"roof", "wall", "ground"};

Json level_json(const Building& b) {
  return {{"lod", b.lod},
          {"vertices", ring_json(b.vertices)},
          {"surfaces", list_of(b.surfaces, [](const auto& s) {
             return Json{{"kind", kSurfaceKinds[static_cast<std::size_t>(s.kind)]}, {"rings", s.rings}};
           })}};
}

Json building_json(const BuildingModel& m) {
  Json attributes = Json::object();
  for (const auto& [name, value] : m.attributes)
    std::visit([&, key = name](const auto& v) { attributes[key] = v; }, value);
  return {{"id", m.id}, {"attributes", attributes}, {"levels", list_of(m.levels, level_json)}};
}

constexpr const char* kStatus[] = {"seen", "completed", "occluded", "by hand"};

const char* status_text(DrawnStatus status) {
  return kStatus[static_cast<std::size_t>(status)];
}

// What a person drew has no stated error.
Json error_json(double error_m, DrawnStatus status) {
  return status == DrawnStatus::by_hand && error_m == 0 ? Json(nullptr) : Json(error_m);
}

Json element_json(const FacadeElement& e) {
  return {
      {"id", e.id},
      {"kind", e.kind},
      {"opening", e.opening},
      {"family", e.family},
      {"row", e.row},
      {"column", e.column},
      {"status", status_text(e.status)},
      {"reason", e.reason},
      {"ring", ring_json(e.ring)},
      {"edges",
       list_of(e.edges,
               [](const FacadeEdge& edge) {
                 return Json{{"status", status_text(edge.status)}, {"error_m", error_json(edge.error_m, edge.status)}};
               })},
      {"width_m", e.width_m},
      {"height_m", e.height_m},
      {"depth_m", e.depth_m},
      {"width_error_m", error_json(e.width_error_m, e.status)},
      {"height_error_m", error_json(e.height_error_m, e.status)},
      {"points", e.points}};
}

Json facade_json(const Facade& f) {
  return {{"id", f.id},
          {"crs", f.crs},
          {"origin", json_of(f.origin)},
          {"right", json_of(f.right)},
          {"up", json_of(f.up)},
          {"out", json_of(f.out)},
          {"width_m", f.width_m},
          {"height_m", f.height_m},
          {"elements", list_of(f.elements, element_json)}};
}

Json object_json(const StreetObject& o) {
  return {{"id", o.id},
          {"label", o.class_name},
          {"probability", o.by_hand ? Json(nullptr) : Json(o.probability)},
          {"base", json_of(o.base)},
          {"middle", json_of(o.middle)},
          {"height_m", o.height_m},
          {"length_m", o.length_m},
          {"width_m", o.width_m},
          {"heading_deg", o.heading_deg},
          {"area_m2", o.area_m2},
          {"points", o.points},
          {"stretch", o.stretch},
          {"block", o.block},
          {"by_hand", o.by_hand}};
}

Json part_json(const FacadePart& p) {
  return {{"stretch", p.stretch}, {"number", p.number},     {"from", json_of(p.from)},
          {"to", json_of(p.to)},  {"length_m", p.length_m}, {"height_m", p.height_m}};
}

Json tree_json(const StreetTree& t) {
  return {{"id", t.id},
          {"position", json_of(t.position)},
          {"trunk_seen", t.trunk_seen},
          {"height_m", t.height_m},
          {"crown_radius_m", t.crown_radius_m},
          {"crown_base_m", t.crown_base_m},
          {"trunk_radius_m", t.trunk_radius_m},
          {"unseen_share", t.unseen_share},
          {"points", t.points}};
}

Json kerb_json(const StreetKerb& k) {
  return {{"id", k.id},
          {"seen", k.seen},
          {"line", list_of(k.line, [](const Vec3& p) { return json_of(p); })},
          {"heights_m", k.heights_m},
          {"height_m", k.height_m},
          {"length_m", k.length_m}};
}

Json width_json(const PavementWidth& w) {
  return {{"kerb", w.kerb},
          {"number", w.number},
          {"from", json_of(w.from)},
          {"to", json_of(w.to)},
          {"kerb_seen", w.kerb_seen},
          {"end", pavement_end_name(w.end)},
          {"width_m", w.width_m},
          {"error_m", w.error_m},
          {"passable_m", w.passable_m},
          {"passable_from_m", w.passable_from_m},
          {"unseen_share", w.unseen_share},
          {"road_m", w.road_m}};
}

Json pavement_json(const Pavement& p) {
  return {
      {"id", p.id},           {"kerb", p.kerb},       {"ring", ring_json(p.ring)},  {"length_m", p.length_m},
      {"area_m2", p.area_m2}, {"width_m", p.width_m}, {"passable_m", p.passable_m}, {"unseen_share", p.unseen_share}};
}

Json carriageway_json(const Carriageway& c) {
  return {{"id", c.id},
          {"ring", ring_json(c.ring)},
          {"holes", list_of(c.holes, ring_json)},
          {"area_m2", c.area_m2},
          {"width_m", c.width_m},
          {"narrowest_m", c.narrowest_m},
          {"seen_share", c.seen_share}};
}

Json planes_json(const PlaneSet& set) {
  Json list = Json::array();
  for (std::size_t i = 0; i < set.segments.size(); ++i) list.push_back(plane_json(set.segments[i], set.outlines[i]));
  return list;
}

Json streets_json(const StreetPlan& plan) {
  return {{"objects", list_of(plan.objects, object_json)},
          {"blocks", list_of(plan.blocks, part_json)},
          {"gaps", list_of(plan.gaps, part_json)},
          {"trees", list_of(plan.trees, tree_json)},
          {"kerbs", list_of(plan.kerbs, kerb_json)},
          {"widths", list_of(plan.widths, width_json)},
          {"pavements", list_of(plan.pavements, pavement_json)},
          {"carriageways", list_of(plan.carriageways, carriageway_json)}};
}

template <typename Read>
ilot_status read_as_json(const char* folder, char** json, const Read& read) {
  return guarded([&] {
    clear(json);
    need(json, "json");
    need(folder, "folder");
    *json = text_of(read(std::filesystem::path(folder)));
    return ILOT_OK;
  });
}

}  // namespace

}  // namespace ilot::c

using namespace ilot;
using namespace ilot::c;

extern "C" {

ilot_status ilot_read_run(const char* folder, char** json) {
  return read_as_json(folder, json, [](const auto& path) { return run_json(read_run(path)); });
}

ilot_status ilot_read_planes(const char* folder, char** json) {
  return read_as_json(folder, json, [](const auto& path) { return planes_json(read_planes(path)); });
}

ilot_status ilot_read_roofs(const char* folder, char** json) {
  return read_as_json(folder, json, [](const auto& path) { return list_of(read_roofs(path), building_json); });
}

ilot_status ilot_read_facades(const char* folder, char** json) {
  return read_as_json(folder, json, [](const auto& path) { return list_of(read_facades(path), facade_json); });
}

ilot_status ilot_read_streets(const char* folder, char** json) {
  return read_as_json(folder, json, [](const auto& path) { return streets_json(read_streets(path)); });
}

}  // extern "C"
