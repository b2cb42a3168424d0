// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/wall_areas.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>
#include <vector>

#include "kernels/core/quantile.h"
#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

// Choice: ten degrees; a wall that turns by more runs away from its neighbour.
constexpr double kAlong = 0.985;  // cosine of the greatest angle between the two outlines
// Choice: half of the least height of an eave over the floor (roof_solid.cpp); only outer walls go down so far.
constexpr double kOnFloor = 0.05;  // metres
// Derived: roofs.margin, within which points beside an outline are gathered, is at most that.
constexpr double kFarthest = 5;  // metres from a wall
// Choice: a metre of wall has points at one point a square metre, the least density for roofs.
constexpr double kStretch = 1;  // metres of wall for which the neighbour's height is one value

struct Span {
  double from = 0, to = 0;  // metres along a wall
};

// An outer wall as seen from above, with the heights of its top at both ends.
struct OuterWall {
  double ax = 0, ay = 0, ux = 0, uy = 0, length = 0;  // metres from the anchor; u: direction, the outside on its right
  double bottom = 0, top_a = 0, top_b = 0;

  double along(double x, double y) const { return (x - ax) * ux + (y - ay) * uy; }
  double outside(double x, double y) const { return (x - ax) * uy - (y - ay) * ux; }
  double top(double t) const { return top_a + (top_b - top_a) * (length > 0 ? t / length : 0); }
};

double wall_area(const Building& solid, const BuildingSurface& wall) {
  Vec3 sum;
  for (const auto& ring : wall.rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec3 o = solid.vertices[wall.rings[0][0]];
      sum = sum + cross(solid.vertices[ring[i]] - o, solid.vertices[ring[(i + 1) % ring.size()]] - o);
    }
  return norm(sum) / 2;
}

// The wall as one over an edge of the outline; nullopt for a wall between two heights of the roof.
std::optional<OuterWall> outer_wall(const Building& solid, const BuildingSurface& wall, double floor,
                                    const RoofSite& site, double metres_per_unit) {
  const auto place = [&](std::uint32_t v) { return metres_per_unit * (solid.vertices[v] - site.anchor); };
  // The ring begins with the lower border, seen from outside from left to right (roof_solid.cpp).
  const auto& ring = wall.rings[0];
  const Vec3 a = place(ring[0]);
  Vec3 b = a;
  for (const std::uint32_t v : ring)
    if (const Vec3 p = place(v); norm(FlatPoint{p.x - a.x, p.y - a.y}) > norm(FlatPoint{b.x - a.x, b.y - a.y})) b = p;
  OuterWall w{a.x, a.y, 0, 0, norm(FlatPoint{b.x - a.x, b.y - a.y}), a.z, a.z, b.z};
  if (!(w.length > 0)) return std::nullopt;
  w.ux = (b.x - a.x) / w.length;
  w.uy = (b.y - a.y) / w.length;
  for (const std::uint32_t v : ring) {
    const Vec3 p = place(v);
    w.bottom = std::min(w.bottom, p.z);
    double& top = w.along(p.x, p.y) < w.length / 2 ? w.top_a : w.top_b;
    top = std::max(top, p.z);
  }
  if (w.bottom > floor + kOnFloor) return std::nullopt;
  return w;
}

// The part of the wall along which one edge runs, within the distance of a common wall.
std::optional<Span> shared_span(const OuterWall& w, Point2 from, Point2 to) {
  const double fx = from.x / 1000.0, fy = from.y / 1000.0, gx = to.x / 1000.0, gy = to.y / 1000.0;
  double t0 = w.along(fx, fy), t1 = w.along(gx, gy), d0 = w.outside(fx, fy), d1 = w.outside(gx, gy);
  const double length = norm(FlatPoint{gx - fx, gy - fy});
  if (!(length > 0) || std::abs(t1 - t0) < kAlong * length) return std::nullopt;
  if (t0 > t1) std::swap(t0, t1), std::swap(d0, d1);
  // The distance is a linear function of the place; it is limited on both sides.
  double from_t = std::max(t0, 0.0), to_t = std::min(t1, w.length);
  const double slope = (d1 - d0) / (t1 - t0);
  for (const double sign : {-1.0, 1.0}) {
    const double at_start = sign * (d0 + slope * (from_t - t0)), rise = sign * slope;
    if (at_start > kSameWall && rise >= 0) return std::nullopt;
    if (at_start > kSameWall) from_t += (kSameWall - at_start) / rise;
    if (rise > 0) to_t = std::min(to_t, t0 + (kSameWall - sign * d0) / rise);
  }
  if (!(to_t > from_t)) return std::nullopt;
  return Span{from_t, to_t};
}

// All parts of the wall that have a neighbour, without overlaps, ascending.
std::vector<Span> shared_spans(const OuterWall& w, std::span<const SitePolygon> neighbours) {
  std::vector<Span> spans;
  for (const SitePolygon& polygon : neighbours)
    for (const auto& ring : polygon)
      for (std::size_t i = 0; i < ring.size(); ++i)
        if (const auto span = shared_span(w, ring[i], ring[(i + 1) % ring.size()])) spans.push_back(*span);
  std::sort(spans.begin(), spans.end(), [](const Span& a, const Span& b) { return a.from < b.from; });
  std::vector<Span> joined;
  for (const Span& s : spans) {
    if (joined.empty() || s.from > joined.back().to)
      joined.push_back(s);
    else
      joined.back().to = std::max(joined.back().to, s.to);
  }
  return joined;
}

// The area of the wall over one span up to the neighbour's roof.
double party_area(const OuterWall& w, const Span& span, std::span<const Vec3> beside) {
  const auto stretches = static_cast<std::size_t>(std::ceil((span.to - span.from) / kStretch));
  const double width = (span.to - span.from) / static_cast<double>(stretches);
  std::vector<std::vector<double>> heights(stretches);
  std::vector<double> all;
  for (const Vec3& p : beside) {
    const double t = w.along(p.x, p.y), out = w.outside(p.x, p.y);
    if (t < span.from || t >= span.to || out < -kSameWall || out > kFarthest) continue;
    heights[std::min(stretches - 1, static_cast<std::size_t>((t - span.from) / width))].push_back(p.z);
    all.push_back(p.z);
  }
  if (all.empty()) return 0;
  const double middle = lower_quantile(all, 0.5);
  double area = 0;
  for (std::size_t i = 0; i < stretches; ++i) {
    const double roof = heights[i].empty() ? middle : lower_quantile(heights[i], 0.5);
    const double top = w.top(span.from + (static_cast<double>(i) + 0.5) * width);
    area += width * std::max(0.0, std::min(roof, top) - w.bottom);
  }
  return area;
}

}  // namespace

WallAreas wall_areas(const Building& solid, const RoofSite& site, std::span<const SitePolygon> neighbours,
                     double metres_per_unit) {
  WallAreas areas;
  double floor = HUGE_VAL;
  for (const Vec3& v : solid.vertices) floor = std::min(floor, metres_per_unit * (v.z - site.anchor.z));
  for (const BuildingSurface& surface : solid.surfaces) {
    if (surface.kind != SurfaceKind::wall) continue;
    const double area = wall_area(solid, surface) * metres_per_unit * metres_per_unit;
    double party = 0;
    if (const auto wall = outer_wall(solid, surface, floor, site, metres_per_unit); wall && !neighbours.empty())
      for (const Span& span : shared_spans(*wall, neighbours)) party += party_area(*wall, span, site.beside);
    party = std::min(party, area);
    areas.party += party;
    areas.exterior += area - party;
  }
  return areas;
}

}  // namespace ilot
