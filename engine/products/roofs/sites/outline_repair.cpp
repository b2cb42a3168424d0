// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/outline_repair.h"

#include <geos_c.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

constexpr std::int64_t kLeastEdge = 2;  // millimetres: validators regard the ends of a shorter edge as one vertex

using GridRing = std::vector<Point2>;

struct Geos {
  Geos() : handle(GEOS_init_r()) {}
  ~Geos() { GEOS_finish_r(handle); }
  Geos(const Geos&) = delete;
  Geos& operator=(const Geos&) = delete;
  GEOSContextHandle_t handle;
};

struct GeometryDelete {
  GEOSContextHandle_t handle;
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(handle, g); }
};
using Geometry = std::unique_ptr<GEOSGeometry, GeometryDelete>;

std::int64_t twice_area(const GridRing& ring) {
  return static_cast<std::int64_t>(doubled_area(ring));
}

// Removes the greater of any two consecutive vertices that lie nearer than kLeastEdge. The same one is removed wherever
// the ring starts and whichever way it runs, so that neighbours lose the same vertices.
GridRing without_repeats(const GridRing& ring) {
  const auto near = [](Point2 p, Point2 q) { return squared_distance(p, q) < kLeastEdge * kLeastEdge; };
  GridRing result;
  const auto add = [&](Point2 p) {
    while (!result.empty() && near(result.back(), p) && p <= result.back()) result.pop_back();
    if (result.empty() || !near(result.back(), p)) result.push_back(p);
  };
  for (const Point2 p : ring) add(p);
  while (result.size() > 1 && near(result.front(), result.back()))
    result.erase(result.front() < result.back() ? result.end() - 1 : result.begin());
  return result;
}

// Returns the ring from its smallest vertex, in the orientation asked for.
GridRing oriented(GridRing ring, bool counter_clockwise) {
  if ((twice_area(ring) > 0) != counter_clockwise) std::reverse(ring.begin(), ring.end());
  std::rotate(ring.begin(), std::min_element(ring.begin(), ring.end()), ring.end());
  return ring;
}

SitePolygon oriented(const SitePolygon& rings) {
  SitePolygon polygon;
  for (const GridRing& ring : rings) polygon.push_back(oriented(ring, polygon.empty()));
  std::sort(polygon.begin() + 1, polygon.end());
  return polygon;
}

GEOSGeometry* ring_geometry(const Geos& geos, const GridRing& ring) {
  const auto n = static_cast<unsigned>(ring.size());
  GEOSCoordSequence* sequence = GEOSCoordSeq_create_r(geos.handle, n + 1, 2);
  for (unsigned i = 0; i <= n; ++i) GEOSCoordSeq_setXY_r(geos.handle, sequence, i, ring[i % n].x, ring[i % n].y);
  return GEOSGeom_createLinearRing_r(geos.handle, sequence);
}

Geometry polygon_geometry(const Geos& geos, const SitePolygon& rings) {
  std::vector<GEOSGeometry*> holes;
  for (std::size_t i = 1; i < rings.size(); ++i) holes.push_back(ring_geometry(geos, rings[i]));
  GEOSGeometry* polygon = GEOSGeom_createPolygon_r(geos.handle, ring_geometry(geos, rings[0]), holes.data(),
                                                   static_cast<unsigned>(holes.size()));
  return {polygon, {geos.handle}};
}

GridRing ring_of(const Geos& geos, const GEOSGeometry* ring) {
  const GEOSCoordSequence* sequence = GEOSGeom_getCoordSeq_r(geos.handle, ring);
  unsigned n = 0;
  GEOSCoordSeq_getSize_r(geos.handle, sequence, &n);
  GridRing result;
  for (unsigned i = 0; i < n; ++i) {
    FlatPoint p;
    GEOSCoordSeq_getXY_r(geos.handle, sequence, i, &p.x, &p.y);
    result.push_back(lattice_point(p, 1));
  }
  return without_repeats(result);
}

void collect_polygons(const Geos& geos, const GEOSGeometry* g, std::vector<SitePolygon>& polygons) {
  const int parts = GEOSGetNumGeometries_r(geos.handle, g);
  const int type = GEOSGeomTypeId_r(geos.handle, g);
  if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    for (int i = 0; i < parts; ++i) collect_polygons(geos, GEOSGetGeometryN_r(geos.handle, g, i), polygons);
    return;
  }
  if (type != GEOS_POLYGON || GEOSisEmpty_r(geos.handle, g) == 1) return;
  SitePolygon polygon{ring_of(geos, GEOSGetExteriorRing_r(geos.handle, g))};
  for (int i = 0; i < GEOSGetNumInteriorRings_r(geos.handle, g); ++i)
    polygon.push_back(ring_of(geos, GEOSGetInteriorRingN_r(geos.handle, g, i)));
  if (polygon[0].size() < 3) return;
  std::erase_if(polygon, [](const GridRing& ring) { return ring.size() < 3; });
  polygons.push_back(oriented(polygon));
}

std::vector<SitePolygon> rebuilt(const Geos& geos, const GEOSGeometry* broken) {
  Geometry valid(GEOSMakeValid_r(geos.handle, broken), {geos.handle});
  if (!valid) return {};
  const Geometry on_grid(GEOSGeom_setPrecision_r(geos.handle, valid.get(), 1.0, 0), {geos.handle});
  std::vector<SitePolygon> polygons;
  if (on_grid) collect_polygons(geos, on_grid.get(), polygons);
  return polygons;
}

// Removes short edges. Returns the same polygon where it would not be valid without them.
SitePolygon without_short_edges(const Geos& geos, const SitePolygon& polygon) {
  SitePolygon shorter;
  for (const GridRing& ring : polygon) {
    shorter.push_back(without_repeats(ring));
    if (shorter.back().size() < 3) return polygon;
  }
  const Geometry geometry = polygon_geometry(geos, shorter);
  return geometry && GEOSisValid_r(geos.handle, geometry.get()) == 1 ? oriented(shorter) : polygon;
}

bool larger(const SitePolygon& a, const SitePolygon& b) {
  const double of_a = area_of(a), of_b = area_of(b);
  return of_a != of_b ? of_a > of_b : a < b;
}

}  // namespace

double area_of(const SitePolygon& polygon) {
  std::int64_t twice = 0;
  for (const GridRing& ring : polygon) twice += twice_area(ring);
  return static_cast<double>(twice) * 0.5e-6;
}

double shared_area(const SitePolygon& a, const SitePolygon& b) {
  const Geos geos;
  const Geometry of_a = polygon_geometry(geos, a), of_b = polygon_geometry(geos, b);
  const Geometry common(GEOSIntersection_r(geos.handle, of_a.get(), of_b.get()), {geos.handle});
  double area = 0;
  if (common) GEOSArea_r(geos.handle, common.get(), &area);
  return area * 1e-6;
}

RepairedOutline repair_outline(const SitePolygon& rings, double least_area) {
  SitePolygon given;
  bool dropped = false;
  for (const GridRing& ring : rings) {
    GridRing whole = without_repeats(ring);
    if (whole.size() >= 3) {
      given.push_back(std::move(whole));
    } else if (given.empty()) {
      return {{}, "its outline has fewer than three corners"};
    } else {
      dropped = true;
    }
  }
  if (given.empty()) return {{}, "it has no outline"};
  const Geos geos;
  const Geometry polygon = polygon_geometry(geos, given);
  if (!polygon) return {{}, "it is no polygon"};
  RepairedOutline result;
  if (GEOSisValid_r(geos.handle, polygon.get()) == 1) {
    result.polygons.push_back(oriented(given));
    if (dropped) result.repair = "a hole without area was left out";
  } else {
    char* reason = GEOSisValidReason_r(geos.handle, polygon.get());
    const std::string text = reason != nullptr ? reason : "unknown";
    GEOSFree_r(geos.handle, reason);
    result.repair = "it was not valid (" + text.substr(0, text.find('[')) + ") and has been mended";
    for (const SitePolygon& p : rebuilt(geos, polygon.get())) result.polygons.push_back(without_short_edges(geos, p));
  }
  std::erase_if(result.polygons, [&](const SitePolygon& p) { return area_of(p) < least_area; });
  if (result.polygons.empty()) return {{}, "its outline has no area"};
  std::sort(result.polygons.begin(), result.polygons.end(), larger);
  return result;
}

}  // namespace ilot
