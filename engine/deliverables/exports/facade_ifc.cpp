// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/facade_ifc.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/deliverables/drawings/facade_plan.h"
#include "engine/deliverables/exports/step_file.h"
#include "engine/deliverables/solids/facade_solids.h"
#include "engine/model/facade.h"

namespace ilot {
namespace {

constexpr double kThinnest = 0.3;  // metres. Choice: a wall of one brick and plaster; thicker walls are drawn too thin
constexpr double kPane = 0.05;  // metres. Choice: what fills an opening has a depth to be seen; its real one is unknown

// The facade with the numbers of its wall in the file. Its axes: x along right, y into the building, z up.
struct Wall {
  const Facade& facade;
  const ExportFrame& frame;
  StepFile& file;
  IfcModel model;
  StepId wall = 0, placement = 0;
  double thickness = kThinnest;
  std::string name = {};

  Vec3 at(Vec3 p) const {
    const Vec3 d = frame.metres_per_unit * (p - facade.origin);
    return {dot(d, facade.right), 0 - dot(d, facade.out), dot(d, facade.up)};
  }
  std::string words(const FacadeElement& e) const { return fmt::format("{}/{}", name, e.id); }
};

double mean_depth(const Wall& wall, const std::vector<Vec3>& ring) {
  double sum = 0;
  for (const Vec3& p : ring) sum += wall.at(p).y;
  return ring.empty() ? 0 : sum / static_cast<double>(ring.size());
}

// A solid from the element's outline, its arcs as chords: from `depth` on into the building, `length` deep.
StepId add_extrusion(const Wall& wall, const FacadeElement& e, double depth, double length) {
  const double m = wall.frame.metres_per_unit;
  std::vector<StepId> corners;
  for (const FlatPoint& p : chords_of(flat_element(wall.facade, e, m)))
    corners.push_back(wall.file.add(
        fmt::format("IFCCARTESIANPOINT(({},{}))", step_real(p.x), step_real(p.y - m * wall.facade.origin.z))));
  corners.push_back(corners[0]);
  const StepId line = wall.file.add("IFCPOLYLINE(" + step_list(corners) + ")"),
               profile = wall.file.add(fmt::format("IFCARBITRARYCLOSEDPROFILEDEF(.AREA.,$,#{})", line)),
               origin = wall.file.add("IFCCARTESIANPOINT(" + step_place({0, depth, 0}) + ")"),
               out = wall.file.add("IFCDIRECTION((0.,-1.,0.))"), right = wall.file.add("IFCDIRECTION((1.,0.,0.))"),
               place = wall.file.add(fmt::format("IFCAXIS2PLACEMENT3D(#{},#{},#{})", origin, out, right)),
               inwards = wall.file.add("IFCDIRECTION((0.,0.,-1.))");
  return wall.file.add(fmt::format("IFCEXTRUDEDAREASOLID(#{},#{},#{},{})", profile, place, inwards, step_real(length)));
}

StepId shape_of(const Wall& wall, const FacadeElement& e, double depth, double length) {
  return ifc_shape(wall.file, wall.model, "SweptSolid", add_extrusion(wall, e, depth, length));
}

std::string length_value(double metres) {
  return "IFCLENGTHMEASURE(" + step_real(metres) + ")";
}

// What a person drew has no stated error.
void add_error(const FacadeElement& e, const char* name, double error_m, IfcProperties& properties) {
  if (e.status == DrawnStatus::by_hand && error_m == 0) return;
  properties.emplace_back(name, length_value(error_m));
}

void add_dimensions(const Wall& wall, const FacadeElement& e, StepId element) {
  IfcProperties dimensions{
      {"Width", length_value(e.width_m)}, {"Height", length_value(e.height_m)}, {"Depth", length_value(e.depth_m)}};
  add_error(e, "WidthError", e.width_error_m, dimensions);
  add_error(e, "HeightError", e.height_error_m, dimensions);
  add_error(e, "DepthError", e.depth_error_m, dimensions);
  ifc_properties(wall.file, wall.words(e), element, "ilot_Dimensions", dimensions);
}

void add_proof(const Wall& wall, const FacadeElement& e, StepId element) {
  IfcProperties proof{{"Element", fmt::format("IFCINTEGER({})", e.id)},
                      {"Kind", "IFCLABEL(" + step_text(e.kind) + ")"},
                      {"Status", fmt::format("IFCLABEL('{}')", name_of(e.status))},
                      {"Points", fmt::format("IFCINTEGER({})", e.points)}};
  if (!e.reason.empty()) proof.emplace_back("Reason", "IFCTEXT(" + step_text(e.reason) + ")");
  if (!e.edges.empty()) {
    std::uint64_t fewest = e.edges[0].points;
    double error = 0, rms = 0;
    for (const FacadeEdge& edge : e.edges) {
      fewest = std::min(fewest, edge.points);
      error = std::max(error, edge.error_m);
      rms = std::max(rms, edge.rms_m);
    }
    proof.emplace_back("FewestPointsOfAnEdge", fmt::format("IFCINTEGER({})", fewest));
    add_error(e, "LargestEdgeError", error, proof);
    proof.emplace_back("LargestEdgeRms", length_value(rms));
  }
  ifc_properties(wall.file, wall.words(e), element, "ilot_Proof", proof);
}

// What fills the opening: an IfcWindow or IfcDoor at the depth where the opening ends; none of an unknown kind.
StepId add_filling(const Wall& wall, const FacadeElement& e, double front) {
  if (e.kind != "window" && e.kind != "door") return 0;
  const bool door = e.kind == "door";
  const StepId place = ifc_placement(wall.file, wall.placement, {}),
               shape = shape_of(wall, e, front + std::abs(e.depth_m), kPane);
  return wall.file.add(fmt::format("{}({},$,{},$,$,#{},#{},$,{},{},$,$,$)", door ? "IFCDOOR" : "IFCWINDOW",
                                   ifc_guid({e.kind, wall.words(e)}), step_text(fmt::format("{} {}", e.kind, e.id)),
                                   place, shape, step_real(e.height_m), step_real(e.width_m)));
}

StepId add_opening(const Wall& wall, const FacadeElement& e) {
  const double front = mean_depth(wall, e.ring);
  const StepId filling = add_filling(wall, e, front);
  if (filling != 0) add_dimensions(wall, e, filling), add_proof(wall, e, filling);
  if (!is_hole(wall.facade, e, wall.frame.metres_per_unit)) return filling;
  const StepId place = ifc_placement(wall.file, wall.placement, {});
  const StepId opening = wall.file.add(
      fmt::format("IFCOPENINGELEMENT({},$,{},$,$,#{},#{},$,.OPENING.)", ifc_guid({"opening", wall.words(e)}),
                  step_text(fmt::format("{} {}", e.kind, e.id)), place, shape_of(wall, e, 0, wall.thickness)));
  wall.file.add(
      fmt::format("IFCRELVOIDSELEMENT({},$,$,$,#{},#{})", ifc_guid({"voids", wall.words(e)}), wall.wall, opening));
  add_dimensions(wall, e, opening);
  add_proof(wall, e, opening);
  if (filling != 0)
    wall.file.add(
        fmt::format("IFCRELFILLSELEMENT({},$,$,$,#{},#{})", ifc_guid({"fills", wall.words(e)}), opening, filling));
  return filling;
}

// The closed body of a sill, a balcony and the like.
StepId add_body(const Wall& wall, const FacadeElement& e, const FacadeSolid& solid) {
  std::string places;
  for (const Vec3& v : solid.vertices) places += (places.empty() ? "" : ",") + step_place(wall.at(v));
  const StepId points = wall.file.add(fmt::format("IFCCARTESIANPOINTLIST3D(({}),$)", places));
  std::vector<StepId> faces;
  for (const auto& face : solid.faces) {
    std::string corners;
    for (const std::uint32_t i : face) corners += fmt::format("{}{}", corners.empty() ? "" : ",", i + 1);
    faces.push_back(wall.file.add("IFCINDEXEDPOLYGONALFACE((" + corners + "))"));
  }
  const StepId set = wall.file.add(fmt::format("IFCPOLYGONALFACESET(#{},.T.,{},$)", points, step_list(faces))),
               shape = ifc_shape(wall.file, wall.model, "Tessellation", set),
               place = ifc_placement(wall.file, wall.placement, {});
  const StepId element = wall.file.add(
      fmt::format("IFCBUILDINGELEMENTPROXY({},$,{},$,{},#{},#{},$,.USERDEFINED.)", ifc_guid({"element", wall.words(e)}),
                  step_text(fmt::format("{} {}", e.kind, e.id)), step_text(e.kind), place, shape));
  add_dimensions(wall, e, element);
  add_proof(wall, e, element);
  return element;
}

StepId add_wall(Wall& wall, const FacadeElement& outline) {
  for (const FacadeElement& e : wall.facade.elements)
    if (e.opening) wall.thickness = std::max(wall.thickness, std::abs(e.depth_m));
  wall.placement = ifc_placement(wall.file, wall.model.site_placement, wall.frame.at(wall.facade.origin),
                                 wall.facade.up, wall.facade.right);
  wall.wall =
      wall.file.add(fmt::format("IFCWALL({},$,{},$,$,#{},#{},$,.NOTDEFINED.)", ifc_guid({"wall", wall.name}),
                                step_text(wall.name), wall.placement, shape_of(wall, outline, 0, wall.thickness)));
  add_dimensions(wall, outline, wall.wall);
  add_proof(wall, outline, wall.wall);
  ifc_properties(wall.file, wall.name, wall.wall, "ilot_Wall",
                 {{"Thickness", length_value(wall.thickness)}, {"ThicknessIs", "IFCLABEL('nominal, not measured')"}});
  return wall.wall;
}

}  // namespace

void write_facade_ifc(const std::filesystem::path& path, const Facade& facade, const ExportFrame& frame) {
  StepFile file(path);
  Wall wall{facade, frame, file, ifc_start(file, frame, "Facade from a point cloud")};
  wall.name = fmt::format("facade {}", facade.id);
  const StepId place = ifc_placement(file, wall.model.site_placement, {});
  const StepId building = file.add(fmt::format("IFCBUILDING({},$,'Building',$,$,#{},$,$,.ELEMENT.,$,$,$)",
                                               ifc_guid({"building of", wall.name}), place));
  ifc_aggregate(file, wall.name, wall.model.site, {building});
  std::vector<StepId> elements;
  const auto outline = std::find_if(facade.elements.begin(), facade.elements.end(),
                                    [](const FacadeElement& e) { return e.kind == "outline" && e.ring.size() > 2; });
  if (outline != facade.elements.end()) {
    elements.push_back(add_wall(wall, *outline));
    const std::vector<FacadeSolid> solids = facade_solids(facade, frame.metres_per_unit);
    for (const FacadeElement& e : facade.elements) {
      if (e.ring.size() < 3 || &e == &*outline || e.status == DrawnStatus::occluded) continue;
      const auto solid =
          std::find_if(solids.begin(), solids.end(), [&](const FacadeSolid& s) { return s.element == e.id; });
      const StepId made = e.opening ? add_opening(wall, e) : solid != solids.end() ? add_body(wall, e, *solid) : 0;
      if (made != 0) elements.push_back(made);
    }
  }
  ifc_contain(file, wall.name, building, elements);
  file.finish();
}

}  // namespace ilot
