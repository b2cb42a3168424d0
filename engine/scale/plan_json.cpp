// SPDX-License-Identifier: Apache-2.0
// plan.json and back.
#include "engine/scale/plan_json.h"

#include <algorithm>
#include <fstream>
#include <functional>
#include <limits>
#include <nlohmann/json.hpp>
#include <sstream>

#include "engine/error.h"
#include "engine/report/path_text.h"
#include "engine/report/sha256.h"
#include "engine/scale/plan.h"
#include "engine/scale/plan_products.h"
#include "engine/settings/config.h"
#include "engine/version.h"

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

constexpr const char* kFormat = "ilot plan 5";

// A number of plan.json that the plan cannot have.
struct WrongNumber {};

template <class Number>
Number number_of(const Json& j) {
  const auto value = j.get<std::uint64_t>();
  if (!j.is_number_unsigned() || value > std::numeric_limits<Number>::max()) throw WrongNumber();
  return static_cast<Number>(value);
}

IndexBox box_of(const Json& list) {
  if (list.is_null()) return IndexBox::none();
  const auto v = list.get<std::array<std::int64_t, 6>>();
  return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}};
}

Json crs_json(const Crs& c) {
  return {{"name", c.name},
          {"epsg", c.epsg},
          {"metres_per_unit", c.metres_per_unit},
          {"metres_per_unit_z", c.metres_per_unit_z},
          {"unit_assumed", c.unit_assumed},
          {"wkt", c.wkt}};
}

Crs crs_of(const Json& j) {
  Crs c;
  c.name = j.at("name").get<std::string>();
  c.epsg = j.at("epsg").get<int>();
  c.metres_per_unit = j.at("metres_per_unit").get<double>();
  c.metres_per_unit_z = j.at("metres_per_unit_z").get<double>();
  c.unit_assumed = j.at("unit_assumed").get<bool>();
  c.wkt = j.at("wkt").get<std::string>();
  return c;
}

InputStations row_stations_of(const Json& j) {
  InputStations s;
  s.of_all = number_of<StationNumber>(j.at("all"));
  for (const Json& pair : j.at("of_source"))
    s.of_source[number_of<std::uint16_t>(pair.at(0))] = number_of<StationNumber>(pair.at(1));
  return s;
}

Json vector_json(const Vec3& v) {
  return {v.x, v.y, v.z};
}

Vec3 vector_of(const Json& j) {
  const auto v = j.get<std::array<double, 3>>();
  return {v[0], v[1], v[2]};
}

Json stations_json(const Plan& p) {
  Json list = Json::array();
  for (const Station& s : p.stations)
    list.push_back({{"position", vector_json(s.position)},
                    {"axis", vector_json(s.axis)},
                    {"steps", {s.azimuth_step, s.elevation_step}}});
  return {{"file", path_text(p.stations_file.string())}, {"list", list}};
}

void read_stations(const Json& j, Plan& p) {
  p.stations_file = path_of_text(j.at("file").get<std::string>());
  for (const Json& s : j.at("list")) {
    Station station;
    station.position = vector_of(s.at("position"));
    station.axis = vector_of(s.at("axis"));
    const auto steps = s.at("steps").get<std::array<double, 2>>();
    station.azimuth_step = steps[0], station.elevation_step = steps[1];
    p.stations.push_back(station);
  }
}

Json input_json(const PlanInput& i) {
  return {{"path", path_text(i.record.path)},
          {"format", i.record.format},
          {"crs", i.record.crs},
          {"dialect", i.record.dialect},
          {"points", i.record.points},
          {"bytes", i.record.bytes},
          {"sha256", i.sha256},
          {"ends", i.ends},
          {"box_steps", box_json(i.box)},
          {"date", i.date},
          {"stations", row_stations_json(i.stations)},
          {"colours", i.colours}};
}

PlanInput input_of(const Json& j) {
  PlanInput i;
  i.record.path = path_of_text(j.at("path").get<std::string>()).string();
  i.record.format = j.at("format").get<std::string>();
  i.record.crs = j.at("crs").get<std::string>();
  i.record.dialect = j.at("dialect").get<std::string>();
  i.record.points = j.at("points").get<std::uint64_t>();
  i.record.bytes = j.at("bytes").get<std::uint64_t>();
  i.sha256 = j.at("sha256").get<std::string>();
  i.ends = j.at("ends").get<std::string>();
  i.box = box_of(j.at("box_steps"));
  i.date = j.at("date").get<std::string>();
  i.stations = row_stations_of(j.at("stations"));
  i.colours = j.at("colours").get<bool>();
  return i;
}

Json footprints_json(const FootprintsRecord& f) {
  Json overlaps = Json::array();
  for (const OverlapRecord& o : f.overlaps) overlaps.push_back({{"id", o.id}, {"with", o.with}});
  return {{"path", path_text(f.path)},   {"id_attribute", f.id_attribute},       {"footprints", f.footprints},
          {"mended", f.mended},          {"without_outline", f.without_outline}, {"overlaps", overlaps},
          {"transformed", f.transformed}};
}

FootprintsRecord footprints_of(const Json& j) {
  FootprintsRecord f;
  f.path = path_of_text(j.at("path").get<std::string>()).string();
  f.id_attribute = j.at("id_attribute").get<std::string>();
  f.footprints = j.at("footprints").get<std::uint64_t>();
  f.mended = j.at("mended").get<std::uint64_t>();
  f.without_outline = j.at("without_outline").get<std::uint64_t>();
  for (const Json& o : j.at("overlaps"))
    f.overlaps.push_back({o.at("id").get<std::string>(), o.at("with").get<std::vector<std::string>>()});
  f.transformed = j.at("transformed").get<bool>();
  return f;
}

Json roofs_json(const PlanRoofs& r) {
  Json further = Json::array();
  for (const auto& [name, kind] : r.frame.further) further.push_back({name, static_cast<int>(kind)});
  Json j{{"sites", r.sites},
         {"by_shape", r.by_shape},
         {"origin", {r.frame.origin.x, r.frame.origin.y, r.frame.origin.z}},
         {"extent", r.frame.extent ? Json(*r.frame.extent) : Json()},
         {"further_attributes", further},
         {"extent_mm", {r.extent.min_x, r.extent.min_y, r.extent.max_x, r.extent.max_y}}};
  if (r.footprints) j["footprints"] = footprints_json(*r.footprints);
  if (r.clusters)
    j["clusters"] = {{"clusters", r.clusters->clusters},
                     {"too_small", r.clusters->too_small},
                     {"points_of_too_small", r.clusters->points_of_too_small}};
  return j;
}

PlanRoofs roofs_of(const Json& j) {
  PlanRoofs r;
  r.sites = j.at("sites").get<std::uint64_t>();
  r.by_shape = j.at("by_shape").get<bool>();
  const auto origin = j.at("origin").get<std::array<double, 3>>();
  r.frame.origin = {origin[0], origin[1], origin[2]};
  if (!j.at("extent").is_null()) r.frame.extent = j.at("extent").get<std::array<double, 6>>();
  for (const Json& c : j.at("further_attributes"))
    r.frame.further.emplace_back(c.at(0).get<std::string>(), static_cast<FieldKind>(c.at(1).get<int>()));
  const auto mm = j.at("extent_mm").get<std::array<std::int64_t, 4>>();
  r.extent = {mm[0], mm[1], mm[2], mm[3]};
  if (j.contains("footprints")) r.footprints = footprints_of(j["footprints"]);
  if (j.contains("clusters"))
    r.clusters = ClustersRecord{j["clusters"].at("clusters").get<std::uint64_t>(),
                                j["clusters"].at("too_small").get<std::uint64_t>(),
                                j["clusters"].at("points_of_too_small").get<std::uint64_t>(),
                                {}};
  return r;
}

Json area_json(const PlanArea& a, std::size_t number) {
  return {{"area", number},
          {"row", a.row},
          {"column", a.column},
          {"own_steps", box_json(a.own)},
          {"buildings", a.sites},
          {"inputs", a.inputs},
          {"read_steps", box_json(a.read)},
          {"points", a.points},
          {"input_bytes", a.input_bytes},
          {"memory_bytes", a.memory_bytes},
          {"part_bytes", a.part_bytes},
          {"processor_seconds", a.processor_seconds},
          {"sites_sum", a.sites_sum},
          {"key", a.key}};
}

PlanArea area_of(const Json& j) {
  PlanArea a;
  a.row = j.at("row").get<std::int64_t>();
  a.column = j.at("column").get<std::int64_t>();
  a.own = box_of(j.at("own_steps"));
  a.sites = j.at("buildings").get<std::uint64_t>();
  for (const Json& i : j.at("inputs")) a.inputs.push_back(number_of<std::uint32_t>(i));
  a.read = box_of(j.at("read_steps"));
  a.points = j.at("points").get<std::uint64_t>();
  a.input_bytes = j.at("input_bytes").get<std::uint64_t>();
  a.memory_bytes = j.at("memory_bytes").get<std::uint64_t>();
  a.part_bytes = j.at("part_bytes").get<std::uint64_t>();
  a.processor_seconds = j.at("processor_seconds").get<double>();
  a.sites_sum = j.at("sites_sum").get<std::string>();
  a.key = j.at("key").get<std::string>();
  return a;
}

Json notes_json(const Plan& p) {
  Json chosen = Json::array(), skipped = Json::array();
  for (const ChosenRecord& c : p.chosen)
    chosen.push_back(
        {{"key", c.key}, {"value", std::visit([](const auto& v) { return Json(v); }, c.value)}, {"why", c.why}});
  for (const SkippedRecord& s : p.skipped)
    skipped.push_back({{"what", s.what}, {"where", path_text(s.where)}, {"reason", s.reason}});
  return {{"chosen", chosen}, {"skipped", skipped}, {"warnings", p.warnings}};
}

void read_notes(const Json& j, Plan& p) {
  for (const Json& c : j.at("chosen")) {
    ChosenRecord chosen{c.at("key").get<std::string>(), {}, c.at("why").get<std::string>()};
    if (c.at("value").is_number())
      chosen.value = c.at("value").get<double>();
    else
      chosen.value = c.at("value").get<std::string>();
    p.chosen.push_back(std::move(chosen));
  }
  for (const Json& s : j.at("skipped"))
    p.skipped.push_back({s.at("what").get<std::string>(), path_of_text(s.at("where").get<std::string>()).string(),
                         s.at("reason").get<std::string>()});
  p.warnings = j.at("warnings").get<std::vector<std::string>>();
}

// Numbers that are used as places in lists.
void check_numbers(const Plan& p) {
  for (const PlanInput& input : p.inputs) {
    StationNumber most = input.stations.of_all;
    for (const auto& [source, station] : input.stations.of_source) most = std::max(most, station);
    if (most > p.stations.size()) throw WrongNumber();
  }
  for (const PlanArea& area : p.areas) {
    const bool ascending = std::ranges::adjacent_find(area.inputs, std::ranges::greater_equal()) == area.inputs.end();
    if (!ascending || (!area.inputs.empty() && area.inputs.back() >= p.inputs.size())) throw WrongNumber();
  }
}

Plan plan_of(const Json& j) {
  Plan p;
  p.version = j.at("version").get<std::string>();
  p.git_hash = j.at("git_hash").get<std::string>();
  p.products = j.at("products").get<std::vector<std::string>>();
  p.labels = j.at("labels").get<bool>();
  for (const auto& [key, value] : j.at("parameters").items())
    apply_assignment(p.settings, key + "=" + (value.is_string() ? value.get<std::string>() : value.dump()));
  p.crs_option = j.at("crs_option").get<std::string>();
  if (const auto words = j.at("text_dialect").get<std::string>(); !words.empty()) p.dialect = dialect_of_words(words);
  p.crs = crs_of(j.at("crs"));
  for (const Json& i : j.at("inputs")) p.inputs.push_back(input_of(i));
  const Json& frozen = j.at("frozen");
  p.lattice = {frozen.at("unit").get<double>(), frozen.at("multiple").get<std::int64_t>()};
  p.rounding = frozen.at("rounding").get<double>();
  const auto corner = j.at("corner").get<std::array<std::int64_t, 3>>();
  p.corner = {corner[0], corner[1], corner[2]};
  p.stray_bits = frozen.at("stray_bits").get<int>();
  for (const Json& c : frozen.at("stray_cells"))
    p.strays.push_back({c.at(0).get<std::int64_t>(), c.at(1).get<std::int64_t>(), c.at(2).get<std::int64_t>()});
  p.points = j.at("points").get<std::uint64_t>();
  p.rejected = j.at("rejected").get<std::map<std::string, std::uint64_t>>();
  read_notes(j.at("notes"), p);
  p.parts = j.at("parts").get<std::string>();
  read_stations(j.at("stations"), p);
  if (j.contains("roofs")) p.roofs = roofs_of(j["roofs"]);
  p.halo = j.at("halo").at("metres").get<double>();
  p.halo_why = j.at("halo").at("why").get<std::string>();
  p.area_size = j.at("area_size_m").get<double>();
  for (const Json& a : j.at("areas")) p.areas.push_back(area_of(a));
  check_numbers(p);
  return p;
}

}  // namespace

Json box_json(const IndexBox& b) {
  return b.is_empty() ? Json() : Json{b.min.x, b.min.y, b.min.z, b.max.x, b.max.y, b.max.z};
}

Json row_stations_json(const InputStations& s) {
  Json sources = Json::array();
  for (const auto& [source, station] : s.of_source) sources.push_back({source, station});
  return {{"all", s.of_all}, {"of_source", sources}};
}

Json task_json(const Plan& p) {
  Json strays = Json::array();
  for (const CoarseCell& c : p.strays) strays.push_back({c.x, c.y, c.z});
  char hash[20];
  std::snprintf(hash, sizeof hash, "%016llx", static_cast<unsigned long long>(settings_hash(p.settings)));
  return {{"version", p.version},
          {"git_hash", p.git_hash},
          {"products", p.products},
          {"labels", p.labels},
          {"parameters", Json::parse(settings_json(p.settings))},
          {"parameters_hash", hash},
          {"crs_option", p.crs_option},
          {"text_dialect", p.dialect ? words_of(*p.dialect) : ""},
          {"crs", crs_json(p.crs)},
          {"frozen",
           {{"unit", p.lattice.unit},
            {"multiple", p.lattice.multiple},
            {"rounding", p.rounding},
            {"stray_bits", p.stray_bits},
            {"stray_cells", strays}}}};
}

std::string plan_text(const Plan& p) {
  Json inputs = Json::array(), areas = Json::array();
  for (const PlanInput& i : p.inputs) inputs.push_back(input_json(i));
  for (std::size_t n = 0; n < p.areas.size(); ++n) areas.push_back(area_json(p.areas[n], n + 1));
  Json j{{"format", kFormat}};
  j.update(task_json(p));
  j["points"] = p.points;
  j["rejected"] = p.rejected;
  j["inputs"] = inputs;
  j["corner"] = {p.corner.x, p.corner.y, p.corner.z};
  j["notes"] = notes_json(p);
  j["halo"] = {{"metres", p.halo}, {"why", p.halo_why}};
  j["area_size_m"] = p.area_size;
  j["areas"] = areas;
  j["parts"] = p.parts;
  j["stations"] = stations_json(p);
  if (makes_roofs(p)) j["roofs"] = roofs_json(p.roofs);
  return j.dump(1) + "\n";
}

std::string plan_hash(const std::string& text) {
  Sha256 sum;
  sum.update(std::as_bytes(std::span(text)));
  return sum.hex();
}

Plan read_plan(const std::filesystem::path& folder) {
  const std::filesystem::path path = folder / kPlanFile;
  std::ifstream file(path, std::ios::binary);
  if (!file) throw Error(path.string() + ": there is no plan; make one with ilot plan INPUT -o PLAN", ExitCode::usage);
  std::stringstream text;
  text << file.rdbuf();
  const Json j = Json::parse(text.str(), nullptr, false);
  if (!j.is_object() || j.value("format", "") != kFormat) throw Error(path.string() + ": is no plan of this program");
  const Error damaged(path.string() + ": is damaged; make the plan again");
  Plan plan;
  try {
    plan = plan_of(j);
  } catch (const nlohmann::json::exception&) {
    throw damaged;
  } catch (const WrongNumber&) {
    throw damaged;
  }
  if (plan.version != version() || plan.git_hash != git_hash())
    throw Error(path.string() + ": was made by ilot " + plan.version + " (" + plan.git_hash + "), this is " +
                version() + " (" + git_hash() +
                "), whose results could differ; plan, tasks and merge need the same program");
  plan.hash = plan_hash(text.str());
  return plan;
}

}  // namespace ilot
