// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/planar_cells.h"

#include <array>
#include <memory>

#include "engine/error.h"
#include "engine/geos_context.h"

namespace ilot {
namespace {

GeosOwned checked(GEOSGeometry* geometry) {
  if (!geometry) throw Error("lines could not be cut into cells (GEOS gave none)");
  return GeosOwned(geometry);
}

GEOSGeometry* line(FlatPoint a, FlatPoint b, FlatPoint origin) {
  GEOSCoordSequence* ends = GEOSCoordSeq_create_r(geos_context(), 2, 2);
  if (!ends) throw Error("out of memory: cells");
  GEOSCoordSeq_setXY_r(geos_context(), ends, 0, a.x - origin.x, a.y - origin.y);
  GEOSCoordSeq_setXY_r(geos_context(), ends, 1, b.x - origin.x, b.y - origin.y);
  return checked(GEOSGeom_createLineString_r(geos_context(), ends)).release();
}

GeosOwned cells_of(std::span<const FlatPoint, 3> triangle, std::span<const FlatEdge> lines) {
  std::vector<GEOSGeometry*> all;
  for (std::size_t i = 0; i < 3; ++i) all.push_back(line(triangle[i], triangle[(i + 1) % 3], triangle[0]));
  for (const FlatEdge& e : lines) all.push_back(line(e.a, e.b, triangle[0]));
  const GeosOwned loose = checked(
      GEOSGeom_createCollection_r(geos_context(), GEOS_MULTILINESTRING, all.data(), static_cast<unsigned>(all.size())));
  const GeosOwned noded = checked(GEOSUnaryUnionPrec_r(geos_context(), loose.get(), 1.0));
  const GEOSGeometry* const parts[] = {noded.get()};
  return checked(GEOSPolygonize_r(geos_context(), parts, 1));
}

bool in_triangle(FlatPoint p, std::span<const FlatPoint, 3> t) {
  std::array<double, 3> side;
  for (std::size_t i = 0; i < 3; ++i) {
    const FlatPoint a = t[i], b = t[(i + 1) % 3];
    side[i] = (b.x - a.x) * (p.y - a.y) - (b.y - a.y) * (p.x - a.x);
  }
  return (side[0] > 0 && side[1] > 0 && side[2] > 0) || (side[0] < 0 && side[1] < 0 && side[2] < 0);
}

}  // namespace

std::vector<FlatPoint> cell_points(std::span<const FlatPoint, 3> triangle, std::span<const FlatEdge> lines,
                                   double least_area) {
  const GeosOwned cells = cells_of(triangle, lines);
  std::vector<FlatPoint> points;
  for (int i = 0; i < GEOSGetNumGeometries_r(geos_context(), cells.get()); ++i) {
    const GEOSGeometry* cell = GEOSGetGeometryN_r(geos_context(), cells.get(), i);
    double area = 0;
    GEOSArea_r(geos_context(), cell, &area);
    if (!(area >= least_area)) continue;
    const GeosOwned inner = checked(GEOSPointOnSurface_r(geos_context(), cell));
    FlatPoint p;
    GEOSGeomGetX_r(geos_context(), inner.get(), &p.x);
    GEOSGeomGetY_r(geos_context(), inner.get(), &p.y);
    p = {p.x + triangle[0].x, p.y + triangle[0].y};
    if (in_triangle(p, triangle)) points.push_back(p);
  }
  return points;
}

}  // namespace ilot
