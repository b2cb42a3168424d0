// SPDX-License-Identifier: Apache-2.0
#include "engine/run/planes_product.h"

#include <algorithm>

#include "engine/segments/auto_params.h"
#include "engine/segments/join_pass.h"
#include "engine/segments/label_pass.h"
#include "engine/segments/normals_pass.h"
#include "engine/segments/planes_pass.h"
#include "kernels/core/portable_math.h"
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
  return s;
}

// Ids are dense from 1 over the planes that kept enough points, in global order of their first cells.
PlanesResult number_planes(const JoinedPlanes& joined, const std::vector<PlaneTally>& tallies, std::int64_t min_points,
                           double unit, double metres_per_unit) {
  PlanesResult r;
  r.final_id.assign(joined.planes.size() + 1, 0);
  for (std::size_t i = 0; i < joined.planes.size(); ++i) {
    if (tallies[i].moments.n < min_points) continue;
    r.segments.push_back(segment_of(joined.planes[i], tallies[i], unit, metres_per_unit));
    r.segments.back().id = static_cast<std::uint32_t>(r.segments.size());
    r.planes.push_back(joined.planes[i]);
    r.final_id[i + 1] = r.segments.back().id;
  }
  return r;
}

double median(std::vector<double> values) {
  if (values.empty()) return 0;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

// Which method `auto` took in how many cells.
ChosenRecord method_choice(const CellPlanes& found) {
  std::size_t from_the_ground = 0;
  for (const CellSummary& c : found.cells) from_the_ground += c.method == PlaneMethod::shape_ransac;
  const std::size_t from_the_air = found.cells.size() - from_the_ground;
  return {"planes.method", std::string(from_the_ground > from_the_air ? "shape_ransac" : "ransac"),
          "shape_ransac in " + std::to_string(from_the_ground) +
              " cells where more than a quarter of the normals are level (walls, seen from the ground), ransac in " +
              std::to_string(from_the_air) + " others"};
}

void record_choices(const CellPlanes& found, const Settings& settings, double unit_m, RunRecord& record) {
  std::vector<double> epsilon, connectivity, step, noise;
  for (const CellSummary& c : found.cells) {
    epsilon.push_back(c.epsilon * unit_m);
    connectivity.push_back(static_cast<double>(c.connectivity) * unit_m);
    step.push_back(c.step * unit_m);
    noise.push_back(c.noise * unit_m);
  }
  const std::string measured = "median over " + std::to_string(found.cells.size()) + " cells; sampling step " +
                               std::to_string(median(step)) + " m, noise " + std::to_string(median(noise)) + " m";
  if (!settings.planes.method) record.chosen.push_back(method_choice(found));
  if (!settings.planes.epsilon)
    record.chosen.push_back({"planes.epsilon", median(epsilon),
                             "the larger of 3.5 times the noise and a quarter of the sampling step of each cell, each "
                             "plane's own stands in "
                             "planes.csv; " +
                                 measured});
  if (!settings.planes.connectivity)
    record.chosen.push_back(
        {"planes.connectivity", median(connectivity), "3 times the sampling step of each cell; " + measured});
  if (!settings.planes.min_points) record.chosen.push_back({"planes.min_points", double{kAutoMinPoints}, "fixed"});
}

}  // namespace

PlanesResult make_planes(const Store& store, const Settings& settings, const PassContext& context, Progress& progress,
                         RunRecord& record) {
  progress.begin_stage("normals", store.points());
  normals_pass(store, settings.normals, context);

  progress.begin_stage("planes", store.points());
  const std::vector<Cell> cells = canonical_cells(store, context.metres_per_unit);
  const CellPlanes found = planes_pass(store, cells, settings, context);
  record_choices(found, settings, store.unit() * context.metres_per_unit, record);

  progress.begin_stage("join", store.points());
  std::vector<Contact> contacts = contact_pass(store, cells, found, context);
  const auto min_points = static_cast<std::uint32_t>(settings.planes.min_points.value_or(kAutoMinPoints));
  const JoinedPlanes joined =
      join_planes(store, cells, found, std::move(contacts), {cos_degrees(settings.planes.join_angle), min_points});
  const std::vector<PlaneTally> tallies = label_pass(store, cells, found, joined, context);
  progress.end_stage();
  PlanesResult result =
      number_planes(joined, tallies, context.wanted ? 1 : min_points, store.unit(), context.metres_per_unit);
  result.ranges = neighbour_ranges(store, cells, found);
  return result;
}

}  // namespace ilot
