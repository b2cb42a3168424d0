// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/make_planes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/columns/normals_pass.h"
#include "engine/products/planes/cells/auto_params.h"
#include "engine/products/planes/cells/plane_methods.h"
#include "engine/products/planes/cells/planes_pass.h"
#include "engine/products/planes/cells/shapes_pass.h"
#include "engine/products/planes/join/adjacency_pass.h"
#include "engine/products/planes/join/extend_pass.h"
#include "engine/products/planes/join/join_pass.h"
#include "engine/products/planes/join/label_pass.h"
#include "engine/store/column_cache.h"
#include "kernels/core/portable_math.h"
#include "kernels/core/quantile.h"
#include "kernels/core/rng.h"
#include "kernels/planes/plane_fit.h"

namespace ilot {
namespace {

Vec3 world(Index3 anchor, Vec3 offset, double unit) {
  return {(static_cast<double>(anchor.x) + offset.x) * unit, (static_cast<double>(anchor.y) + offset.y) * unit,
          (static_cast<double>(anchor.z) + offset.z) * unit};
}

Segment segment_of(const JoinedPlane& j, const PlaneTally& t, double unit, double metres_per_unit) {
  Segment s;
  s.content_id = mix64(t.content_id);
  const Vec3 anchor = world(j.anchor, {}, unit);
  s.plane = {j.plane.n, j.plane.d * unit - dot(j.plane.n, anchor)};
  s.points = static_cast<std::uint64_t>(t.moments.n);
  s.centroid = world(j.anchor, centroid(t.moments), unit);
  s.min = world(t.box.min, {}, unit);
  s.max = world(t.box.max, {}, unit);
  s.rms_m = rms_to_plane(t.moments, j.plane) * unit * metres_per_unit;
  s.epsilon_m = j.epsilon * unit * metres_per_unit;
  s.level_m = (t.high[0] - t.low[0]) * unit * metres_per_unit;
  s.up_m = (t.high[1] - t.low[1]) * unit * metres_per_unit;
  s.confidence = static_cast<double>(t.sure) / static_cast<double>(s.points);
  const auto most = std::max_element(t.colours.begin(), t.colours.end());
  if (*most > 0) s.colour_class = static_cast<std::uint32_t>(most - t.colours.begin() + 1);
  if (t.with_normal > 0) {
    const double sine2 = static_cast<double>(t.squared_sines) * kSineUnit / static_cast<double>(t.with_normal);
    s.normal_spread_deg = degrees_of_cosine(std::sqrt(1 - sine2));
  }
  return s;
}

// Numbers the planes that have enough points. Ids are dense from 1, in global order of their first cells.
PlanesResult number_planes(const Store& store, const JoinedPlanes& joined, bool part_of_a_run, double metres_per_unit) {
  PlanesResult r;
  r.final_id.assign(joined.planes.size() + 1, 0);
  each_tally(store, joined.planes.size(), [&](std::size_t i, const PlaneTally& tally) {
    if (tally.moments.n < (part_of_a_run ? 1 : joined.planes[i].min_points)) return;
    r.segments.push_back(segment_of(joined.planes[i], tally, store.unit(), metres_per_unit));
    r.segments.back().id = static_cast<std::uint32_t>(r.segments.size());
    r.planes.push_back(joined.planes[i]);
    r.final_id[i + 1] = r.segments.back().id;
  });
  return r;
}

ColourPalette make_palette(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                           const Settings& settings, const PassContext& context, RunRecord& record) {
  if (settings.planes.colour_classes == 0 || !colours_pass(store, inputs, context)) return {};
  ColourPalette palette =
      colour_palette(store, static_cast<std::uint32_t>(settings.planes.colour_classes), settings.seed);
  std::string centres;
  for (const auto& c : palette.centre)
    centres += fmt::format("{}({:.1f} {:.1f} {:.1f})", centres.empty() ? "" : ", ", c[0] / 100, c[1] / 100, c[2] / 100);
  record.chosen.push_back({"planes.colour_classes", static_cast<double>(palette.centre.size()),
                           "CIELAB of the classes from 1 on, the largest first: " + centres});
  return palette;
}

void find_neighbours(const Store& store, const std::vector<Cell>& cells, const CellPlanes& found,
                     const PassContext& context, PlanesResult& r) {
  adjacency_pass(store, cells, found, r.final_id, r.planes, context);
  each_touch(store, [&](const Touch& touch) {
    ++r.segments[touch.a - 1].neighbours;
    ++r.segments[touch.b - 1].neighbours;
  });
}

double median(std::vector<double> values) {
  return values.empty() ? 0 : upper_median(values);
}

std::size_t cells_searched_for_curved(const CellPlanes& found) {
  return static_cast<std::size_t>(std::count_if(found.cells.begin(), found.cells.end(),
                                                [](const CellSummary& cell) { return cell.searched_curved; }));
}

bool searched_for_curved(const CellPlanes& found, const PlanesSettings& settings) {
  return settings.curved.value_or(false) || cells_searched_for_curved(found) > 0;
}

void record_choices(const CellPlanes& found, const Settings& settings, double unit_m, RunRecord& record) {
  std::vector<double> epsilon, connectivity, step, noise, min_points, angle;
  std::size_t from_the_ground = 0;
  for (const CellSummary& c : found.cells) {
    from_the_ground += c.from == SeenFrom::ground;
    min_points.push_back(c.min_points);
    angle.push_back(c.normal_angle);
    epsilon.push_back(c.epsilon * unit_m);
    connectivity.push_back(static_cast<double>(c.connectivity) * unit_m);
    step.push_back(c.step * unit_m);
    noise.push_back(c.noise * unit_m);
  }
  const std::size_t from_the_air = found.cells.size() - from_the_ground;
  const std::string ground = std::to_string(from_the_ground), air = std::to_string(from_the_air);
  const std::string measured = "median over " + std::to_string(found.cells.size()) + " cells; sampling step " +
                               std::to_string(median(step)) + " m, noise " + std::to_string(median(noise)) + " m";
  if (!settings.planes.method)
    record.chosen.push_back(
        {"planes.method", std::string(from_the_ground > from_the_air ? "shape_ransac" : "ransac"),
         "shape_ransac in " + ground +
             " cells where more than a quarter of the normals are level (walls, seen from the ground), ransac in " +
             air + " others (seen from the air)"});
  if (!settings.planes.curved)
    record.chosen.push_back(
        {"planes.curved", std::string(searched_for_curved(found, settings.planes) ? "true" : "false"),
         settings.planes.method ? "planes.method is given"
                                : "looked for in " + std::to_string(cells_searched_for_curved(found)) + " of " +
                                      std::to_string(found.cells.size()) +
                                      " cells, where planes.curved_points points cover a square metre or less"});
  if (!settings.planes.epsilon)
    record.chosen.push_back({"planes.epsilon", median(epsilon),
                             "the larger of 3.5 times the noise and a quarter of the sampling step of each cell, each "
                             "plane's own stands in planes.csv; " +
                                 measured});
  if (!settings.planes.normal_angle)
    record.chosen.push_back({"planes.normal_angle", median(angle),
                             "25 degrees; in cells seen from the air times the square of a quarter of the step over "
                             "epsilon, at least 10: where epsilon is wide only normals separate faces; " +
                                 measured});
  if (!settings.planes.connectivity)
    record.chosen.push_back({"planes.connectivity", median(connectivity),
                             "4 times the sampling step in " + air + " cells seen from the air, 6 times in " + ground +
                                 " seen from the ground, where surfaces seen at a grazing angle have wide gaps; " +
                                 measured});
  if (!settings.planes.min_points)
    record.chosen.push_back({"planes.min_points", median(min_points),
                             "points on 1.2 m2, 12 to 200, in " + air +
                                 " cells seen from the air; on 50 cm2, 30 to "
                                 "200, in " +
                                 ground + " seen from the ground; " + measured});
}

// Turns an axis upwards; a horizontal axis is turned to the north, or to the east.
Vec3 pointing_up(Vec3 axis) {
  const bool down = axis.z < 0 || (axis.z == 0 && (axis.y < 0 || (axis.y == 0 && axis.x < 0)));
  return down ? -1.0 * axis : axis;
}

CurvedSegment curved_of(const JoinedShape& j, const ShapeTally& t, double unit, double metres_per_unit) {
  CurvedSegment s;
  s.content_id = mix64(t.content_id);
  s.kind = j.shape.kind;
  s.points = t.points;
  s.min = world(t.box.min, {}, unit);
  s.max = world(t.box.max, {}, unit);
  s.position = world(j.anchor, j.shape.origin, unit);
  if (s.kind != ShapeKind::kSphere) s.axis = j.shape.axis;
  if (s.kind == ShapeKind::kCylinder) {
    s.axis = pointing_up(s.axis);
    s.position = s.position + dot(0.5 * (s.min + s.max) - s.position, s.axis) * s.axis;
  }
  if (s.kind == ShapeKind::kCone)
    s.half_angle_deg = degrees_of_cosine(j.shape.cosine);
  else
    s.radius_m = j.shape.radius * unit * metres_per_unit;
  s.epsilon_m = j.epsilon * unit * metres_per_unit;
  s.rms_m = std::sqrt(static_cast<double>(t.squared_errors) * kErrorUnit / static_cast<double>(t.points)) * s.epsilon_m;
  return s;
}

// Numbers the shapes that have enough points. Ids are dense from 1, in global order of their first cells.
void find_shapes(const Store& store, const std::vector<Cell>& cells, const Settings& settings,
                 const PassContext& context, PlanesResult& r) {
  const JoinedShapes joined = join_shapes(store, cells);
  const std::vector<ShapeTally> tallies = shapes_pass(store, cells, joined, context);
  const std::uint64_t least = context.wanted ? 1 : static_cast<std::uint64_t>(settings.planes.curved_points);
  r.final_shape.assign(tallies.size() + 1, 0);
  std::vector<CurvedSegment>& curved = r.curved.emplace();
  for (std::size_t i = 0; i < tallies.size(); ++i) {
    if (tallies[i].points < least) continue;
    curved.push_back(curved_of(joined.shapes[i], tallies[i], store.unit(), context.metres_per_unit));
    r.final_shape[i + 1] = curved.back().id = static_cast<std::uint32_t>(curved.size());
  }
}

}  // namespace

void each_plane_neighbours(const Store& store, const PlanesResult& r, double metres_per_unit,
                           const std::function<void(const PlaneNeighbours&)>& take) {
  each_touch(store, [&](const Touch& touch) {
    take(neighbours_of(touch, r.planes[touch.a - 1], r.planes[touch.b - 1], store.unit(), metres_per_unit));
  });
}

PlanesResult make_planes(const Store& store, const std::vector<std::unique_ptr<PointReader>>& inputs,
                         const Settings& settings, const PassContext& context, Progress& progress, RunRecord& record) {
  progress.begin_stage("normals", store.points());
  normals_pass(store, settings.normals, context);

  progress.begin_stage("planes", store.points());
  const ColourPalette palette = make_palette(store, inputs, settings, context, record);
  const std::vector<Cell> cells = canonical_cells(store, context.metres_per_unit);
  record.cells = {store.unit(), largest_cell(store.unit() * context.metres_per_unit), kCellPoints};
  const CellPlanes found = planes_pass(store, cells, settings, context, palette);
  record_choices(found, settings, store.unit() * context.metres_per_unit, record);

  progress.begin_stage("join", store.points());
  std::vector<Contact> contacts = contact_pass(store, cells, found, context);
  JoinedPlanes joined =
      join_planes(store, cells, found, std::move(contacts), {cos_degrees(settings.planes.join_angle)});
  extend_pass(store, cells, found, joined, context);
  label_pass(store, cells, found, joined, context, palette);
  for (std::uint32_t b = 0; b < store.blocks().size(); ++b) forget_file(store.path(b, columns::kSegment));
  PlanesResult result = number_planes(store, joined, context.wanted != nullptr, context.metres_per_unit);
  joined = {};
  find_neighbours(store, cells, found, context, result);
  if (searched_for_curved(found, settings.planes)) find_shapes(store, cells, settings, context, result);
  progress.end_stage();
  result.ranges = neighbour_ranges(store, cells, found);
  return result;
}

}  // namespace ilot
