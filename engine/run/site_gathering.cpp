// SPDX-License-Identifier: Apache-2.0
#include "engine/run/site_gathering.h"

#include <algorithm>
#include <cmath>

#include "engine/store/stretches.h"

namespace ilot {
namespace {

constexpr std::int64_t kFar = std::int64_t{1} << 52;
constexpr double kGridMetres = 0.001;

// One axis of the lattice as seen from a site's anchor.
struct Axis {
  std::int64_t from;  // lattice coordinate nearest to the anchor
  double rest, step;  // metres: where that lies from the anchor; a lattice unit

  Axis(std::int64_t anchor_mm, double unit_metres) : step(unit_metres) {
    constexpr double kRounding = 1e-7;
    const double anchor = static_cast<double>(anchor_mm) * kGridMetres;
    from = std::llround(anchor / step);
    rest = static_cast<double>(from) * step - anchor;
    if (std::abs(rest) < kRounding) rest = 0;
  }
  double metres(std::int64_t v) const { return static_cast<double>(v - from) * step + rest; }
};

IndexBox column_over(const SiteWork& work, const PlannedSite& site) {
  const double step = work.store.unit() * work.metres_per_unit;
  const double reach = reach_of(work.params);
  const auto low = [&](std::int64_t mm) {
    return static_cast<std::int64_t>(std::floor((static_cast<double>(mm) * kGridMetres - reach) / step)) - 1;
  };
  const auto high = [&](std::int64_t mm) {
    return static_cast<std::int64_t>(std::ceil((static_cast<double>(mm) * kGridMetres + reach) / step)) + 1;
  };
  const GridBox& box = site.outline.box;
  return {{low(box.min_x), low(box.min_y), -kFar}, {high(box.max_x), high(box.max_y), kFar}};
}

struct Read {
  Surroundings around;
  std::vector<StorePlace> places;
};

// The points in the box, z in metres of the CRS.
Read read_points(const SiteWork& work, const IndexBox& box, Index3 anchor_mm) {
  const double step = work.store.unit() * work.metres_per_unit;
  const Axis x(anchor_mm.x, step), y(anchor_mm.y, step);
  Read read;
  for_each_stretch(work.store, plan_view(work.store, box, {}).slices, [&](const Stretch& s) {
    const auto roles = s.read(work.store, columns::kRole);
    for (std::uint32_t i = 0; i < roles.size(); ++i) {
      const Index3 p = s.position(i);
      if (!box.contains(p)) continue;
      read.around.points.push_back({x.metres(p.x), y.metres(p.y), static_cast<double>(p.z) * step});
      read.around.roles.push_back(roles[i]);
      read.places.push_back({s.block, s.first + i});
    }
  });
  return read;
}

// The site's outline and those within reach of it, seen from its anchor; `own` is its place among them.
std::vector<SitePolygon> outlines_around(const SiteWork& work, std::size_t number, std::size_t& own) {
  const PlacedOutline& outline = work.sites[number].outline;
  const auto reach_mm = static_cast<std::int64_t>(std::ceil(reach_of(work.params) / kGridMetres));
  std::vector<SitePolygon> outlines;
  for (const std::uint32_t n : work.map.near(outline.box.grown(reach_mm))) {
    if (n == number) own = outlines.size();
    outlines.push_back(seen_from(work.sites[n].outline, outline.x, outline.y));
  }
  return outlines;
}

}  // namespace

std::uint64_t points_to_read(const SiteWork& work, std::size_t site) {
  if (work.sites[site].outline.polygon.empty()) return 0;
  return plan_view(work.store, column_over(work, work.sites[site]), {}).size;
}

GatheredSite gather_site(const SiteWork& work, std::size_t number) {
  const PlannedSite& planned = work.sites[number];
  const PlacedOutline& outline = planned.outline;
  const Read read = read_points(work, column_over(work, planned), {outline.x, outline.y, 0});
  std::size_t own = 0;
  const std::vector<SitePolygon> outlines = outlines_around(work, number, own);
  const SitePoints chosen = choose_points(read.around, outlines, own, work.params);

  GatheredSite gathered;
  gathered.by_class = chosen.by_class;
  gathered.points_around = read.around.points.size();
  RoofSite& site = gathered.site;
  site.id = planned.id;
  site.outline = outline.polygon;
  site.ground_source = chosen.ground_source;
  double lowest = chosen.ground;
  for (const std::uint32_t i : chosen.building) lowest = std::min(lowest, read.around.points[i].z);
  const double anchor_z = std::floor(lowest);
  site.anchor = {static_cast<double>(outline.x) * kGridMetres / work.metres_per_unit,
                 static_cast<double>(outline.y) * kGridMetres / work.metres_per_unit, anchor_z / work.metres_per_unit};
  site.ground = chosen.ground - anchor_z;
  site.points.reserve(chosen.building.size());
  gathered.places.reserve(chosen.building.size());
  for (const std::uint32_t i : chosen.building) {
    const Vec3 p = read.around.points[i];
    site.points.push_back({p.x, p.y, p.z - anchor_z});
    gathered.places.push_back(read.places[i]);
  }
  return gathered;
}

ShiftCounts shifts_around(const SiteWork& work, std::size_t number) {
  const PlannedSite& planned = work.sites[number];
  const Read read = read_points(work, column_over(work, planned), {planned.outline.x, planned.outline.y, 0});
  std::vector<Vec3> points;
  for (std::size_t i = 0; i < read.around.points.size(); ++i)
    if (read.around.roles[i] == PointRole::building) points.push_back(read.around.points[i]);
  std::size_t own = 0;
  std::vector<SitePolygon> outlines = outlines_around(work, number, own);
  std::swap(outlines[0], outlines[own]);
  ShiftCounts counts;
  count_shifts(points, outlines, counts);
  return counts;
}

}  // namespace ilot
