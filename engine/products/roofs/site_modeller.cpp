// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/site_modeller.h"

#include <algorithm>
#include <map>

#include "engine/model/building_geometry.h"
#include "engine/products/roofs/solids/point_labels.h"
#include "engine/products/roofs/solids/wall_areas.h"
#include "engine/report/counted.h"
#include "engine/validity/validity.h"

namespace ilot {
namespace {

// Numbers the roof faces from 1, whatever numbers the model gave them, and returns the last number.
std::uint32_t number_planes(RoofModel& model) {
  std::map<std::uint32_t, std::uint32_t> numbers{{0, 0}};
  for (const BuildingSurface& s : model.lod22.surfaces)
    if (s.kind == SurfaceKind::roof) numbers.emplace(s.plane_id, 0);
  std::uint32_t last = 0;
  for (auto& [given, number] : numbers)
    if (given != 0) number = ++last;
  const auto of = [&](std::uint32_t given) {
    const auto entry = numbers.find(given);
    return entry == numbers.end() ? 0 : entry->second;
  };
  for (BuildingSurface& s : model.lod22.surfaces) s.plane_id = of(s.plane_id);
  for (Building* level : {&model.lod12, &model.lod13})
    for (BuildingSurface& s : level->surfaces) s.plane_id = 0;
  for (std::uint32_t& face : model.face_of_point) face = of(face);
  model.map.number.resize(model.map.planes.size());
  for (std::uint32_t i = 0; i < model.map.number.size(); ++i) model.map.number[i] = of(i + 1);
  return last;
}

// The tolerances of val3dity are metres; they are converted to CRS units.
ValidityParams tolerances(double metres_per_unit) {
  ValidityParams params;
  params.snap /= metres_per_unit;
  params.plane_distance /= metres_per_unit;
  return params;
}

// Returns the first fault as a reason; empty if there is no fault.
std::string fault_of(const Faults& faults) {
  if (faults.empty()) return {};
  return "the solid is not valid: " + std::to_string(faults[0].code) + " " + validity_code_name(faults[0].code) + ", " +
         faults[0].where;
}

void append(const BuildingAttributes& from, BuildingAttributes& to) {
  to.insert(to.end(), from.begin(), from.end());
}

std::string why_empty(const GatheredSite& gathered) {
  if (gathered.points_around == 0) return "no point of the cloud lies in its outline or around it";
  return "none of the points in its outline is a building's";
}

// What a person has corrected; empty where nothing was.
std::string edits_text(const GatheredSite& gathered, const RoofModel& model) {
  const auto merged =
      static_cast<std::uint64_t>(std::ranges::count(model.merges, EditOutcome::made, &EditResult::outcome));
  std::string text;
  if (gathered.by_hand > 0) text = "classes of " + counted(gathered.by_hand, "point");
  if (merged > 0) text += (text.empty() ? "" : ", ") + counted(merged, "merge") + " of faces";
  return text;
}

}  // namespace

SiteResult SiteModeller::model(std::size_t number, SiteSteps* steps) const {
  const PlannedSite& planned = work_.sites[number];
  SiteResult result;
  if (planned.outline.polygon.empty()) {
    result.reason = planned.reason;
    result.levels.emplace_back().id = planned.id;
    result.levels[0].attributes = {{"status", std::string(name_of(result.status))}, {"reason", planned.reason}};
    append(planned.attributes, result.levels[0].attributes);
    return result;
  }
  SiteReader reader(work_, number);
  const GatheredSite gathered = reader.gather();
  if (steps != nullptr) steps->gathered = gathered;
  RoofModel model = model_of(gathered, steps == nullptr ? nullptr : &steps->roof);
  result.planes = number_planes(model);
  if (steps != nullptr) steps->face_of_point = model.face_of_point;
  PointMeasures measures(gathered.site, model, work_.metres_per_unit);
  if (gathered.thinned)
    label_all(reader, gathered.site, model, measures, result);
  else
    label_sample(reader, gathered, model, measures, result);
  BuildingAttributes attributes = building_attributes(gathered.site, model, work_.metres_per_unit, measures);
  add_notes(number, gathered, model, attributes);
  result.merges = std::move(model.merges);
  result.status = model.status;
  result.reason = model.reason;
  result.thinned = gathered.thinned;
  result.levels = levels_of(gathered.site, model);
  add_sizes(number, gathered.site, result.levels, attributes);
  result.levels[0].attributes = std::move(attributes);
  return result;
}

RoofModel SiteModeller::model_of(const GatheredSite& gathered, RoofSteps* steps) const {
  if (gathered.site.points.empty()) {
    RoofModel model;
    model.face_of_point.assign(gathered.site.beside.size(), 0);
    model.reason = why_empty(gathered);
    model.merges.assign(gathered.site.merges.size(), {EditOutcome::without_partner, kNoFacesToMerge});
    return model;
  }
  const SolidCheck check = [&](const Building& b) {
    return fault_of(validate_building(b, file_.origin, file_.step, tolerances(work_.metres_per_unit)));
  };
  return model_roof(gathered.site, params_, work_.metres_per_unit, check, steps);
}

void SiteModeller::label_sample(const SiteReader& reader, const GatheredSite& gathered, const RoofModel& model,
                                PointMeasures& measures, SiteResult& result) const {
  const PointLabeller labeller(gathered.site, model, work_.metres_per_unit);
  const auto label = [&](std::span<const StorePlace> places, std::span<const Vec3> points, const auto& face_of,
                         const auto& away) {
    std::vector<SitePointLabel> labels;
    for (std::size_t i = 0; i < places.size(); ++i) {
      const std::uint32_t face = face_of(i);
      labels.push_back({places[i].point, face, labeller.label(points[i], face), away(points[i])});
      const bool last = i + 1 == places.size() || places[i + 1].block != places[i].block;
      if (!last && labels.size() < kStretchPoints) continue;
      result.labels.push_back(labels_.store_labels(places[i].block, labels));
      labels.clear();
    }
  };
  const std::size_t inside = gathered.site.points.size();
  const auto& faces = model.face_of_point;
  for (std::size_t i = 0; i < inside; ++i) measures.add(gathered.site.points[i], faces[i]);
  label(
      gathered.places, gathered.site.points, [&](std::size_t i) { return faces[i]; },
      [](Vec3) { return std::uint8_t{0}; });
  label(
      gathered.beside, gathered.site.beside, [&](std::size_t i) { return faces[inside + i]; },
      [&](Vec3 p) { return reader.away(p); });
}

void SiteModeller::label_all(const SiteReader& reader, const RoofSite& site, const RoofModel& model,
                             PointMeasures& measures, SiteResult& result) const {
  const PointLabeller labeller(site, model, work_.metres_per_unit);
  std::vector<SitePointLabel> labels;
  reader.for_each_stretch([&](std::uint32_t block, std::span<const std::uint32_t> points, std::span<const Vec3> at) {
    const std::vector<std::uint32_t> faces = faces_at(model.map, at);
    labels.clear();
    for (std::size_t i = 0; i < points.size(); ++i) {
      const std::uint8_t away = reader.away(at[i]);
      if (away == 0) measures.add(at[i], faces[i]);
      labels.push_back({points[i], faces[i], labeller.label(at[i], faces[i]), away});
    }
    result.labels.push_back(labels_.store_labels(block, labels));
  });
}

void SiteModeller::add_notes(std::size_t number, const GatheredSite& gathered, const RoofModel& model,
                             BuildingAttributes& attributes) const {
  if (!gathered.by_class && !gathered.site.points.empty())
    attributes.emplace_back("points_of", std::string("unclassified"));
  if (const std::string edits = edits_text(gathered, model); !edits.empty()) attributes.emplace_back("by_hand", edits);
  if (!work_.sites[number].repair.empty()) attributes.emplace_back("outline", work_.sites[number].repair);
  append(work_.sites[number].attributes, attributes);
}

void SiteModeller::add_sizes(std::size_t number, const RoofSite& site, std::span<const Building> levels,
                             BuildingAttributes& attributes) const {
  BuildingAttributes sizes = volumes(levels, work_.metres_per_unit);
  if (const Building* finest = finest_solid(levels)) {
    const WallAreas areas = wall_areas(*finest, site, neighbours_of(number), work_.metres_per_unit);
    sizes.emplace_back("party_wall_m2", areas.party);
    sizes.emplace_back("exterior_wall_m2", areas.exterior);
  }
  const auto area =
      std::find_if(attributes.begin(), attributes.end(), [](const auto& a) { return a.first == "area_m2"; });
  attributes.insert(area == attributes.end() ? area : area + 1, sizes.begin(), sizes.end());
}

std::vector<SitePolygon> SiteModeller::neighbours_of(std::size_t number) const {
  const PlacedOutline& own = work_.sites[number].outline;
  std::vector<SitePolygon> outlines;
  for (const std::uint32_t i : work_.map.near(own.box.grown(static_cast<std::int64_t>(kSameWall * 1000))))
    if (i != number) outlines.push_back(seen_from(work_.sites[i].outline, own.x, own.y));
  return outlines;
}

std::vector<Building> SiteModeller::levels_of(const RoofSite& site, RoofModel& model) const {
  std::vector<Building> levels{flat_outline(site, work_.metres_per_unit)};
  const auto add = [&](Building& solid, const char* lod) {
    if (solid.surfaces.empty()) return;
    levels.push_back(std::move(solid));
    levels.back().lod = lod;
  };
  add(model.lod12, "1.2");
  add(model.lod13, "1.3");
  add(model.lod22, "2.2");
  for (Building& level : levels) level.id = site.id;
  return levels;
}

}  // namespace ilot
