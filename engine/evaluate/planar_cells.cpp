// SPDX-License-Identifier: Apache-2.0
#include "engine/evaluate/planar_cells.h"

#include <geos_c.h>

#include <array>
#include <memory>

#include "engine/error.h"

namespace ilot {
namespace {

// GEOS keeps its state in a context that one thread uses at a time.
GEOSContextHandle_t context() {
  struct Holder {
    GEOSContextHandle_t handle = GEOS_init_r();
    ~Holder() { GEOS_finish_r(handle); }
  };
  thread_local const Holder holder;
  return holder.handle;
}

struct Destroy {
  void operator()(GEOSGeometry* g) const { GEOSGeom_destroy_r(context(), g); }
};
using Owned = std::unique_ptr<GEOSGeometry, Destroy>;

Owned checked(GEOSGeometry* geometry) {
  if (!geometry) throw Error("lines could not be cut into cells (GEOS gave none)");
  return Owned(geometry);
}

GEOSGeometry* line(FlatPoint a, FlatPoint b, FlatPoint origin) {
  GEOSCoordSequence* ends = GEOSCoordSeq_create_r(context(), 2, 2);
  if (!ends) throw Error("out of memory: cells");
  GEOSCoordSeq_setXY_r(context(), ends, 0, a.x - origin.x, a.y - origin.y);
  GEOSCoordSeq_setXY_r(context(), ends, 1, b.x - origin.x, b.y - origin.y);
  return checked(GEOSGeom_createLineString_r(context(), ends)).release();
}

Owned cells_of(std::span<const FlatPoint, 3> triangle, std::span<const FlatEdge> lines) {
  std::vector<GEOSGeometry*> all;
  for (std::size_t i = 0; i < 3; ++i) all.push_back(line(triangle[i], triangle[(i + 1) % 3], triangle[0]));
  for (const FlatEdge& e : lines) all.push_back(line(e.a, e.b, triangle[0]));
  const Owned loose = checked(
      GEOSGeom_createCollection_r(context(), GEOS_MULTILINESTRING, all.data(), static_cast<unsigned>(all.size())));
  const Owned noded = checked(GEOSUnaryUnionPrec_r(context(), loose.get(), 1.0));
  const GEOSGeometry* const parts[] = {noded.get()};
  return checked(GEOSPolygonize_r(context(), parts, 1));
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
  const Owned cells = cells_of(triangle, lines);
  std::vector<FlatPoint> points;
  for (int i = 0; i < GEOSGetNumGeometries_r(context(), cells.get()); ++i) {
    const GEOSGeometry* cell = GEOSGetGeometryN_r(context(), cells.get(), i);
    double area = 0;
    GEOSArea_r(context(), cell, &area);
    if (!(area >= least_area)) continue;
    const Owned inner = checked(GEOSPointOnSurface_r(context(), cell));
    FlatPoint p;
    GEOSGeomGetX_r(context(), inner.get(), &p.x);
    GEOSGeomGetY_r(context(), inner.get(), &p.y);
    p = {p.x + triangle[0].x, p.y + triangle[0].y};
    if (in_triangle(p, triangle)) points.push_back(p);
  }
  return points;
}

}  // namespace ilot
