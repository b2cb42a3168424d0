// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/site_gathering.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>

#include "kernels/geometry/box3.h"

namespace ilot {
namespace {

// Choice: the width of a street, of a block and of a large hall with its yard.
constexpr std::array kGroundRings{10.0, 25.0, 50.0};  // metres around an outline in which ground is searched
constexpr std::uint64_t kFewestGroundPoints = 10;

double lattice_step(const SiteWork& work) {
  return work.store.unit() * work.metres_per_unit;
}

IndexBox column_around(const SiteWork& work, const PlannedSite& site, double reach) {
  const double step = lattice_step(work);
  const auto low = [&](std::int64_t mm) {
    return static_cast<std::int64_t>(std::floor((static_cast<double>(mm) * kGridMetres - reach) / step)) - 1;
  };
  const auto high = [&](std::int64_t mm) {
    return static_cast<std::int64_t>(std::ceil((static_cast<double>(mm) * kGridMetres + reach) / step)) + 1;
  };
  const GridBox& box = site.outline.box;
  return column_over(low(box.min_x), low(box.min_y), high(box.max_x), high(box.max_y));
}

IndexBox column_of_site(const SiteWork& work, const PlannedSite& site) {
  return column_around(work, site, reach_of(work.params));
}

// The site's outline, then the others within reach of it, seen from its anchor.
std::vector<SitePolygon> outlines_around(const SiteWork& work, std::size_t number) {
  const PlacedOutline& outline = work.sites[number].outline;
  const auto reach_mm = static_cast<std::int64_t>(std::ceil(reach_of(work.params) / kGridMetres));
  std::vector<SitePolygon> outlines{outline.polygon};
  for (const std::uint32_t n : work.map.near(outline.box.grown(reach_mm)))
    if (n != number) outlines.push_back(seen_from(work.sites[n].outline, outline.x, outline.y));
  return outlines;
}

bool any_ground(std::span<const PointRole> roles) {
  static_assert(sizeof(PointRole) == 1);
  return std::memchr(roles.data(), static_cast<int>(PointRole::ground), roles.size()) != nullptr;
}

// Calls visit(position) for the ground points in the box, in global order. Roles come first: most clouds have no ground
// where this is asked, and then no place of a point is read.
template <class Visit>
void for_each_ground_point(const Store& store, const IndexBox& box, const Visit& visit) {
  std::vector<PointRole> roles;
  for (const Slice& s : plan_view(store, box, {}).slices) {
    const auto reader = store.open(s.block, columns::kRole);
    const Tile tile = store.blocks()[s.block].node.tile;
    for (std::uint32_t done = 0; done < s.count; done += kStretchPoints) {
      roles.resize(std::min(kStretchPoints, s.count - done));
      reader.read(s.first + done, roles);
      if (!any_ground(roles)) continue;
      const auto codes = store.read(s.block, columns::kCodes, s.first + done, roles.size());
      for (std::size_t i = 0; i < roles.size(); ++i) {
        if (roles[i] != PointRole::ground) continue;
        if (const Index3 p = index_of({tile, codes[i]}); box.contains(p)) visit(p);
      }
    }
  }
}

}  // namespace

SiteReader::Axis::Axis(std::int64_t anchor_mm, double unit_metres) : step(unit_metres) {
  // Derived: above the rounding of doubles at 1e7 m, far below a step.
  constexpr double kRounding = 1e-7;
  const double anchor = static_cast<double>(anchor_mm) * kGridMetres;
  from = std::llround(anchor / step);
  rest = static_cast<double>(from) * step - anchor;
  if (std::abs(rest) < kRounding) rest = 0;
}

double farthest_points(const SitePointsParams& params) {
  return std::max(kGroundRings.back(), reach_of(params));
}

std::uint64_t points_to_read(const SiteWork& work, std::size_t site) {
  if (work.sites[site].outline.polygon.empty()) return 0;
  return plan_view(work.store, column_of_site(work, work.sites[site]), {}).size;
}

SiteReader::SiteReader(const SiteWork& work, std::size_t site)
    : work_(work),
      number_(site),
      planned_(work.sites[site]),
      box_(column_of_site(work, planned_)),
      x_(planned_.outline.x, lattice_step(work)),
      y_(planned_.outline.y, lattice_step(work)),
      filter_(planned_.outline.polygon, work.params) {
  if (work.class_edits != nullptr) class_edits_ = work.class_edits->near(box_);
}

bool SiteReader::by_hand(Index3 position) const {
  return std::ranges::any_of(class_edits_, [&](std::size_t i) { return work_.class_edits->contains(i, position); });
}

// Collects the building's points. Their class is known only after the last point around them is read. So points of both
// possible classes are collected as long as there are not too many.
UnitSample SiteReader::sample(GatheredSite& gathered) {
  SiteMeasure measure(filter_);
  UnitCollector building(work_.most_points), unclassified(work_.most_points);
  for_each_around([&](const AroundPoint& p, Index3 position) {
    ++gathered.points_around;
    measure.add(p.at, p.role, p.membership);
    gathered.by_hand += p.membership != PointMembership::none && by_hand(position);
    if (!may_be_of_building(p.membership)) return;
    if (p.role == PointRole::building) building.add({p.place, position});
    if (p.role == PointRole::unclassified) unclassified.add({p.place, position});
  });
  rule_ = measure.rule();
  UnitCollector& kind = rule_.by_class ? building : unclassified;
  if (!kind.has_all()) return sample_unit(work_.store, box_, work_.most_points, building_points());
  UnitCollector taken(work_.most_points);
  for (const KeptPoint& p : kind.take())
    if (metres(p.position).z >= rule_.lowest) taken.add(p);
  const std::uint64_t total = taken.total();
  const Index3 corner = taken.corner();
  return {taken.take(), total, corner};
}

// Takes the ground of a site without ground points around it from the nearest of some rings that has any. The ground is
// not above the lowest point of the building's edge.
void SiteReader::find_nearby_ground() {
  const SitePointsParams& params = filter_.params();
  std::array<ValueCounts, kGroundRings.size()> rings;
  const IndexBox box = column_around(work_, planned_, kGroundRings.back());
  for_each_ground_point(work_.store, box, [&](Index3 position) {
    const Vec3 at = metres(position);
    if (filter_.of(at, PointRole::ground) == PointMembership::held) return;
    const double distance = filter_.distance(at, kGroundRings.back());
    for (std::size_t ring = 0; ring < kGroundRings.size(); ++ring)
      if (distance <= kGroundRings[ring]) rings[ring].add(at.z);
  });
  for (ValueCounts& ring : rings) {
    if (ring.count() < kFewestGroundPoints) continue;
    const double last = static_cast<double>(ring.count() - 1);
    rule_.ground = std::min(rule_.ground, ring.nth(static_cast<std::uint64_t>(params.ground_share * last)));
    rule_.ground_source = GroundSource::nearby;
    return;
  }
}

GatheredSite SiteReader::gather() {
  GatheredSite gathered;
  const UnitSample chosen = sample(gathered);
  if (rule_.ground_source == GroundSource::lowest_point && chosen.total > 0) find_nearby_ground();
  gathered.by_class = rule_.by_class;
  gathered.thinned = chosen.thinned();
  gathered.points = chosen.total;
  RoofSite& site = gathered.site;
  site.id = planned_.id;
  site.outline = planned_.outline.polygon;
  site.ground_source = rule_.ground_source;
  site.merges = merges_of(work_.merges, number_);
  const double lowest = chosen.points.empty() ? rule_.ground : std::min(rule_.ground, metres(chosen.corner).z);
  anchor_z_ = std::floor(lowest);
  site.anchor = {static_cast<double>(planned_.outline.x) * kGridMetres / work_.metres_per_unit,
                 static_cast<double>(planned_.outline.y) * kGridMetres / work_.metres_per_unit,
                 anchor_z_ / work_.metres_per_unit};
  site.ground = rule_.ground - anchor_z_;
  site.points.reserve(chosen.points.size());
  gathered.places.reserve(chosen.points.size());
  for (const KeptPoint& k : chosen.points) {
    const Vec3 p = metres(k.position);
    const bool inside = filter_.away(p) == 0;
    (inside ? site.points : site.beside).push_back({p.x, p.y, p.z - anchor_z_});
    (inside ? gathered.places : gathered.beside).push_back(k.place);
  }
  return gathered;
}

std::vector<AroundPoint> SiteReader::points_around(std::size_t most) const {
  const std::uint64_t all = plan_view(work_.store, box_, {}).size, every = 1 + all / std::max<std::size_t>(most, 1);
  std::vector<AroundPoint> points;
  std::uint64_t number = 0;
  for_each_around([&](const AroundPoint& p, Index3) {
    if (number++ % every == 0) points.push_back(p);
  });
  return points;
}

void SiteReader::for_each_stretch(const Visit& visit) const {
  std::vector<std::uint32_t> numbers;
  std::vector<Vec3> at;
  const auto takes = building_points();
  for_each_stretch_in(work_.store, box_, [&](const Stretch& s, std::span<const StretchPoint> inside) {
    const auto taken = takes(s);
    numbers.clear();
    at.clear();
    for (const StretchPoint& p : inside) {
      if (!taken(p)) continue;
      const Vec3 m = metres(p.position);
      numbers.push_back(s.first + p.number);
      at.push_back({m.x, m.y, m.z - anchor_z_});
    }
    if (!at.empty()) visit(s.block, numbers, at);
  });
}

UnitSample SiteReader::buildings_around() const {
  return sample_unit(work_.store, box_, work_.most_points, [&](const Stretch& s) {
    return [roles = s.read(work_.store, columns::kRole)](const StretchPoint& p) {
      return roles[p.number] == PointRole::building;
    };
  });
}

ShiftCounts shifts_around(const SiteWork& work, std::size_t number) {
  const SiteReader reader(work, number);
  const UnitSample sample = reader.buildings_around();
  std::vector<Vec3> points;
  points.reserve(sample.points.size());
  for (const KeptPoint& k : sample.points) points.push_back(reader.metres(k.position));
  ShiftCounts counts;
  count_shifts(points, outlines_around(work, number), counts);
  return counts;
}

}  // namespace ilot
