// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/roofs_ifc.h"

#include <fmt/format.h>

#include <cmath>

#include "engine/model/building_geometry.h"

namespace ilot {
namespace {

std::string ring_text(const std::vector<std::uint32_t>& ring) {
  std::string text;
  for (const std::uint32_t corner : ring) text += fmt::format("{}{}", text.empty() ? "" : ",", corner + 1);
  return "(" + text + ")";
}

StepId add_face(StepFile& file, const BuildingSurface& surface) {
  if (surface.rings.size() == 1)
    return file.add(fmt::format("IFCINDEXEDPOLYGONALFACE({})", ring_text(surface.rings[0])));
  std::string holes;
  for (std::size_t i = 1; i < surface.rings.size(); ++i)
    holes += (holes.empty() ? "" : ",") + ring_text(surface.rings[i]);
  return file.add(fmt::format("IFCINDEXEDPOLYGONALFACEWITHVOIDS({},({}))", ring_text(surface.rings[0]), holes));
}

StepId add_envelope(StepFile& file, const Building& solid, const ExportFrame& frame, Vec3 anchor) {
  std::string places;
  for (const Vec3& v : solid.vertices) places += (places.empty() ? "" : ",") + step_place(frame.at(v) - anchor);
  const StepId points = file.add(fmt::format("IFCCARTESIANPOINTLIST3D(({}),$)", places));
  std::vector<StepId> faces;
  for (const BuildingSurface& surface : solid.surfaces) faces.push_back(add_face(file, surface));
  return file.add(fmt::format("IFCPOLYGONALFACESET(#{},.T.,{},$)", points, step_list(faces)));
}

IfcProperties properties_of(const BuildingModel& model) {
  IfcProperties properties{{"id", "IFCLABEL(" + step_text(model.id) + ")"}};
  for (const auto& [name, value] : model.attributes) {
    if (const auto* whole = std::get_if<std::int64_t>(&value))
      properties.emplace_back(name, fmt::format("IFCINTEGER({})", *whole));
    else if (const auto* number = std::get_if<double>(&value))
      properties.emplace_back(name, "IFCREAL(" + step_real(*number) + ")");
    else if (const auto* truth = std::get_if<bool>(&value))
      properties.emplace_back(name, *truth ? "IFCBOOLEAN(.T.)" : "IFCBOOLEAN(.F.)");
    else
      properties.emplace_back(name, "IFCTEXT(" + step_text(std::get<std::string>(value)) + ")");
  }
  return properties;
}

}  // namespace

RoofsIfc::RoofsIfc(const std::filesystem::path& path, const ExportFrame& frame)
    : file_(path), frame_(frame), model_(ifc_start(file_, frame, "Buildings from a point cloud")) {}

void RoofsIfc::add(const BuildingModel& model) {
  const Building* solid = finest_solid(model.levels);
  if (!solid || solid->vertices.empty()) return;
  const Vec3 first = frame_.at(solid->vertices[0]),
             anchor{std::floor(first.x), std::floor(first.y), std::floor(first.z)};
  const StepId place = ifc_placement(file_, model_.site_placement, anchor),
               shape = ifc_shape(file_, model_, "Tessellation", add_envelope(file_, *solid, frame_, anchor));
  const std::string name = step_text(model.id);
  const StepId building = file_.add(
      fmt::format("IFCBUILDING({},$,{},$,$,#{},$,$,.ELEMENT.,$,$,$)", ifc_guid({"building", model.id}), name, place));
  const StepId inside = ifc_placement(file_, place, {});
  const StepId envelope =
      file_.add(fmt::format("IFCBUILDINGELEMENTPROXY({},$,{},$,'LoD {} envelope',#{},#{},$,.USERDEFINED.)",
                            ifc_guid({"envelope", model.id}), name, solid->lod, inside, shape));
  ifc_contain(file_, model.id, building, {envelope});
  ifc_properties(file_, model.id, building, "ilot_Building", properties_of(model));
  buildings_.push_back(building);
}

void RoofsIfc::finish() {
  ifc_aggregate(file_, "buildings", model_.site, buildings_);
  file_.finish();
}

}  // namespace ilot
