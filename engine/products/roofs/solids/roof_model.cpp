// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/roof_model.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <span>
#include <utility>

#include "engine/error.h"
#include "engine/products/roofs/faces/cell_labels.h"
#include "engine/products/roofs/faces/concurrence.h"
#include "engine/products/roofs/faces/corner_joining.h"
#include "engine/products/roofs/faces/face_limits.h"
#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/regular_planes.h"
#include "engine/products/roofs/faces/roof_faces.h"
#include "engine/products/roofs/faces/roof_lines.h"
#include "engine/products/roofs/faces/roof_planes.h"
#include "engine/products/roofs/faces/supported_roof.h"
#include "engine/products/roofs/sites/outline_repair.h"
#include "engine/products/roofs/solids/bent_faces.h"
#include "engine/products/roofs/solids/face_joining.h"
#include "engine/products/roofs/solids/roof_solid.h"
#include "engine/products/roofs/solids/step_parts.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: half a metre squared, below what a model of LoD2.2 shows.
constexpr double kLeastFaceArea = 0.25;  // m2
// Derived: ten centimetres squared, a mistake of drawing.
constexpr double kLeastOutline = 0.01;  // m2
constexpr std::size_t kFewestPoints = 3;
// Choice: the sparsest clouds in use have a point for 4 m2; a quarter of that is a corner seen by chance.
constexpr double kAreaOfPoint = 16;  // m2
// Choice: less is the rim of a tile.
constexpr double kSeenCell = 2, kLeastSeen = 0.1;  // metres; share of the outline in cells with a point
// Choice: a corner that is off by twice what is drawn is seen.
constexpr double kMostJoined = 2;  // times `detail`: the longest edge whose ends are joined
constexpr int kAttempts = 4;       // attempts to raise a roof, each time with larger faces only ...
// Choice: the step by which faces are given up until a solid is valid; smaller steps cost time.
constexpr double kFewerFaces = 4;  // ... larger by this factor in area

Building building_of(const RoofSite& site, RoofSolid solid, const char* lod, double metres_per_unit) {
  Building b;
  b.id = site.id;
  b.lod = lod;
  for (const Vec3& v : solid.vertices) b.vertices.push_back(site.anchor + (1 / metres_per_unit) * v);
  b.surfaces = std::move(solid.surfaces);
  return b;
}

// Returns why the points say nothing about the roof as a whole; empty where they do.
std::string too_sparse(const RoofSite& site) {
  const double area = area_of(site.outline);
  if (static_cast<double>(site.points.size()) * kAreaOfPoint < area)
    return "fewer points than one for " + std::to_string(static_cast<int>(kAreaOfPoint)) + " m2 of the outline";
  std::set<std::pair<std::int64_t, std::int64_t>> cells;
  for (const Vec3& p : site.points)
    cells.insert({static_cast<std::int64_t>(std::floor(p.x / kSeenCell)),
                  static_cast<std::int64_t>(std::floor(p.y / kSeenCell))});
  if (static_cast<double>(cells.size()) * kSeenCell * kSeenCell < kLeastSeen * area)
    return "less than a tenth of the outline has points";
  return {};
}

// The points of which the heights of level roofs are: those on no wall, or all where there are no others.
std::vector<Vec3> points_of_levels(const RoofSite& site, const RoofPlanes& planes) {
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < site.points.size(); ++i)
    if (!planes.on_wall[i]) points.push_back(site.points[i]);
  return points.empty() ? site.points : points;
}

RoofPlane level_roof(const RoofSite& site, const RoofPlanes& planes, double block_height) {
  std::vector<double> z;
  for (const Vec3& p : points_of_levels(site, planes)) z.push_back(p.z);
  RoofPlane plane;
  plane.c = lower_quantile(z, block_height);
  return plane;
}

// The divided outline, with a plane for every cell.
struct LabelledCells {
  std::vector<FlatEdge> lines;
  Partition cells;
  std::vector<std::uint32_t> of_point, label;
};

LabelledCells labelled_cells(const RoofSite& site, const RoofPlanes& planes, std::vector<FlatEdge> lines,
                             const CellLabelParams& params) {
  LabelledCells c;
  c.lines = std::move(lines);
  c.cells = part(site.outline, c.lines);
  std::vector<FlatPoint> flat;
  for (const Vec3& p : site.points) flat.push_back({p.x * 1000, p.y * 1000});
  c.of_point = regions_of(c.cells, flat);
  c.label = label_cells(site, planes, c.cells, c.of_point, params);
  return c;
}

// On a hillside the ground of a site may be above parts of its roof; then the lowest roof tells how deep faces may lie.
FaceLimits limits_of(const RoofSite& site, const RoofPlanes& planes, const RoofModelParams& params) {
  double ground = site.ground;
  for (const RoofPlane& plane : planes.planes) ground = std::min(ground, plane.lowest);
  return {planes.step, params.overshoot, ground};
}

// Labels the cells. Where a face would fall too low, as where a cloud ends within the outline, the outline is also cut
// where the points of its plane end, and no cell beyond is given to it.
LabelledCells cells_within_limits(const RoofSite& site, RoofPlanes& planes, const RoofModelParams& params) {
  CellLabelParams costs{params.border_cost, params.wall_cost, limits_of(site, planes, params)};
  LabelledCells c = labelled_cells(site, planes, roof_lines(site, planes), costs);
  if (c.label.empty()) return c;
  const std::vector<std::uint32_t> falling = falling_planes(planes, c.cells, c.label, costs.limits);
  if (falling.empty()) return c;
  std::vector<FlatEdge> lines = std::move(c.lines);
  for (const std::uint32_t p : falling) lines.push_back(end_of_points(planes.planes[p], site.outline));
  costs.forbid_falls = true;
  c = labelled_cells(site, planes, std::move(lines), costs);
  if (!c.label.empty()) level_fallen(c.cells, costs.limits, planes, c.label);
  return c;
}

// How vertices are shared: faces whose heights agree within same_height share a vertex, and so do the ends of edges
// shorter than `shortest` (metres).
struct Sharing {
  double same_height, shortest;
};
constexpr Sharing kSharing[]{{kSameHeight, 0.003},
                             {0.4 * kSameHeight, 0.003},
                             {0.15 * kSameHeight, 0.003},
                             {0.15 * kSameHeight, 0.02},
                             {0.15 * kSameHeight, 0.06}};

// Raises the faces so that the check accepts the solid. It tries one way of sharing vertices after the other: a face
// that shares vertices bends, by little in metres but by much in degrees where it is narrow. What is accepted may still
// bend by some millimetres; such faces are divided. Returns nullopt when the
// check accepts none; `reason` is then the fault of the first one.
std::optional<Building> raised(const RoofSite& site, const Partition& faces, std::span<const RoofPlane> planes,
                               const char* lod, double metres_per_unit, const SolidCheck& check, std::string& reason) {
  for (const Sharing& sharing : kSharing) {
    Partition closed = faces;
    close_short_edges(closed, site.outline, sharing.shortest);
    RoofSolid solid = extrude_roof(std::move(closed), planes, site.ground, sharing.same_height);
    Building b = building_of(site, solid, lod, metres_per_unit);
    std::string fault = check(b);
    if (fault.empty()) {
      reason.clear();
      for (const Division how : {Division::pieces, Division::triangles}) {
        RoofSolid divided = solid;
        if (!divide_bent_faces(divided, how)) break;
        Building planar = building_of(site, std::move(divided), lod, metres_per_unit);
        if (check(planar).empty()) return planar;
      }
      return b;
    }
    if (reason.empty()) reason = std::move(fault);
  }
  return std::nullopt;
}

// Raises the block. Returns false, with the reason, when there is none.
bool add_block(const RoofSite& site, const RoofPlanes& planes, const RoofModelParams& params, double metres_per_unit,
               const SolidCheck& check, RoofModel& model) {
  const Partition whole = part(site.outline, {});
  if (whole.regions != 1) {
    model.reason = "the outline is not one polygon on a grid of 1 mm";
    return false;
  }
  auto block = raised(site, whole, std::vector<RoofPlane>{level_roof(site, planes, params.block_height)}, "1.2",
                      metres_per_unit, check, model.reason);
  if (!block) return false;
  model.lod12 = std::move(*block);
  model.status = RoofStatus::lod12;
  return true;
}

// The faces of a roof with the fewest corners that `detail` (metres) allows.
RoofFaces with_few_corners(const RoofSite& site, RoofFaces roof, double step, double detail) {
  join_corners(roof.faces, site.outline, roof.planes, std::clamp(step, detail, kMostJoined * detail));
  straighten_borders(roof.faces, site.outline, detail);
  adjust_to_concur(roof.faces, site.points, roof.of_point, detail, roof.planes);
  return roof;
}

// Returns true when a face is beyond the limits for the labels of cells by more than `detail`.
bool beyond_limits(const RoofFaces& roof, const FaceLimits& limits, double detail) {
  const auto beyond = [&](std::uint32_t region, Point2 at) {
    if (region == kOutside) return false;
    const RoofPlane& plane = roof.planes[region - 1];
    const FlatPoint place{at.x / 1000.0, at.y / 1000.0};
    return std::max(too_high(plane, place, limits), too_low(plane, place, limits)) > detail;
  };
  return std::any_of(roof.faces.edges.begin(), roof.faces.edges.end(), [&](const PartitionEdge& e) {
    const Point2 a = roof.faces.vertices[e.from], b = roof.faces.vertices[e.to];
    return beyond(e.left, a) || beyond(e.left, b) || beyond(e.right, a) || beyond(e.right, b);
  });
}

// Raises the faces of the roof. If the check refuses the solid, more and more of the small faces are given to their
// neighbours. Points that a person gave to a face (PlanesWithMerges::given) do not lie on it.
void add_house(const RoofSite& site, RoofPlanes& planes, std::span<const std::uint32_t> given,
               const RoofModelParams& params, double metres_per_unit, const SolidCheck& check, RoofModel& model,
               RoofSteps* steps) {
  const LabelledCells c = cells_within_limits(site, planes, params);
  const FaceLimits limits = limits_of(site, planes, params);
  if (steps != nullptr) {
    steps->lines = c.lines;
    steps->cells = c.cells;
    steps->cell_of_point = c.of_point;
    steps->label = c.label;
  }
  if (c.label.empty() && c.cells.regions > 0) {
    model.reason = "too many faces: " + std::to_string(planes.planes.size()) + " planes in " +
                   std::to_string(c.cells.regions) + " cells of the outline; its points may not be a roof's";
    return;
  }
  double least = params.least_face_area > 0 ? params.least_face_area : kLeastFaceArea;
  std::string first_fault;
  for (int attempt = 0; attempt < kAttempts; ++attempt, least *= kFewerFaces) {
    RoofFaces roof = roof_faces(site, planes, c.cells, c.of_point, c.label, {least, limits});
    for (std::size_t i = 0; i < given.size(); ++i)
      if (given[i] != 0) roof.of_point[i] = 0;
    std::optional<Building> house;
    if (params.detail > 0) {
      RoofFaces drawn = with_few_corners(site, roof, planes.step, params.detail);
      if (!beyond_limits(drawn, limits, params.detail))
        house = raised(site, drawn.faces, drawn.planes, "2.2", metres_per_unit, check, model.reason);
      if (house) roof = std::move(drawn);
    }
    if (!house) house = raised(site, roof.faces, roof.planes, "2.2", metres_per_unit, check, model.reason);
    if (steps != nullptr) steps->faces = roof.faces, steps->face_planes = roof.planes;
    if (house) {
      model.lod22 = std::move(*house);
      model.face_of_point = std::move(roof.of_point);
      model.map = {std::move(roof.faces), std::move(roof.planes), {}, planes.epsilon};
      model.status = RoofStatus::lod22;
      return;
    }
    if (steps != nullptr) steps->refused.push_back(model.reason);
    if (attempt == 0) first_fault = model.reason;
  }
  model.reason = first_fault;
}

// Raises the parts between which the roof steps. There is no such solid when the check refuses it.
void add_steps(const RoofSite& site, const RoofPlanes& planes, const RoofModelParams& params, double metres_per_unit,
               const SolidCheck& check, RoofModel& model) {
  const StepParts steps = step_parts(model.map.faces, model.map.planes, site.outline, points_of_levels(site, planes),
                                     {params.lod13_step, params.block_height});
  if (steps.planes.size() == 1) {
    model.lod13 = model.lod12;
    model.lod13.lod = "1.3";
    return;
  }
  std::string refused;
  auto solid = raised(site, steps.parts, steps.planes, "1.3", metres_per_unit, check, refused);
  if (solid) model.lod13 = std::move(*solid);
}

// The model of a roof whose planes are known. face_of_point is that of the supported roof.
RoofModel model_of_planes(const RoofSite& site, PlanesWithMerges joined, const RoofModelParams& params,
                          double metres_per_unit, const SolidCheck& check, RoofSteps* steps) {
  RoofModel model;
  if (params.detail > 0) make_regular(site.outline, site.points, joined.planes);
  RoofPlanes planes = with_given_points(joined, site.points);
  if (steps != nullptr) {
    *steps = {};
    steps->points = site.points;
    steps->planes = planes;
  }
  if (!add_block(site, planes, params, metres_per_unit, check, model)) return model;
  if (planes.planes.empty()) {
    model.reason = "no plane has enough points";
    return model;
  }
  add_house(site, planes, joined.given, params, metres_per_unit, check, model, steps);
  if (model.status == RoofStatus::lod22 && params.lod13_step > 0)
    add_steps(site, planes, params, metres_per_unit, check, model);
  return model;
}

// Joins two faces and models the roof again. Where that leaves two faces, all stays as it was.
EditResult merge_faces(const FaceMerge& merge, const RoofSite& site, const RoofModelParams& params,
                       double metres_per_unit, const SolidCheck& check, PlanesWithMerges& joined, RoofModel& model,
                       RoofSteps* steps) {
  PlanesWithMerges before = joined;
  const EditResult result = join_planes_of_faces(model, merge, site.points, joined);
  if (result.outcome != EditOutcome::made) return result;
  RoofSteps steps_after;
  RoofModel after =
      model_of_planes(site, joined, params, metres_per_unit, check, steps == nullptr ? nullptr : &steps_after);
  if (after.status != RoofStatus::lod22) {
    joined = std::move(before);
    return {EditOutcome::without_partner, "with these faces as one the roof has no solid: " + after.reason};
  }
  const std::uint32_t face = face_above(after.map, merge.first);
  if (face == kOutside || face_above(after.map, merge.second) != face) {
    joined = std::move(before);
    return {EditOutcome::without_partner, "the faces of this edit do not touch, or a third one lies between them"};
  }
  model = std::move(after);
  if (steps != nullptr) *steps = std::move(steps_after);
  return result;
}

}  // namespace

std::vector<std::uint32_t> faces_at(const RoofFaceMap& map, std::span<const Vec3> points) {
  std::vector<FlatPoint> flat;
  flat.reserve(points.size());
  for (const Vec3& p : points) flat.push_back({p.x * 1000, p.y * 1000});
  std::vector<std::uint32_t> faces = regions_of(map.faces, flat);
  for (std::size_t i = 0; i < faces.size(); ++i) {
    if (faces[i] == kOutside) continue;
    const RoofPlane& plane = map.planes[faces[i] - 1];
    const double off = std::abs(points[i].z - plane.at(points[i].x, points[i].y));
    if (off > map.epsilon * std::sqrt(1 + plane.gx * plane.gx + plane.gy * plane.gy)) faces[i] = 0;
    if (faces[i] != 0 && !map.number.empty()) faces[i] = map.number[faces[i] - 1];
  }
  return faces;
}

RoofModel model_roof(const RoofSite& site, const RoofModelParams& params, double metres_per_unit,
                     const SolidCheck& check, RoofSteps* steps) {
  RoofModel model;
  model.face_of_point.assign(site.points.size() + site.beside.size(), 0);
  model.merges.assign(site.merges.size(), {EditOutcome::without_partner, kNoFacesToMerge});
  if (site.outline.empty() || area_of(site.outline) < kLeastOutline) {
    model.reason = "the outline has no area";
    return model;
  }
  if (site.points.size() < kFewestPoints) {
    model.reason = "fewer than 3 points";
    return model;
  }
  if (model.reason = too_sparse(site); !model.reason.empty()) return model;
  SupportedRoof roof = supported_roof(site, params);
  PlanesWithMerges joined{std::move(roof.planes), {}};
  std::vector<EditResult> merges = std::move(model.merges);
  model = model_of_planes(roof.site, joined, params, metres_per_unit, check, steps);
  for (std::size_t i = 0; i < merges.size(); ++i)
    merges[i] = merge_faces(site.merges[i], roof.site, params, metres_per_unit, check, joined, model, steps);
  model.merges = std::move(merges);
  model.face_of_point = of_given_points(site, roof, model.face_of_point);
  return model;
}

}  // namespace ilot
