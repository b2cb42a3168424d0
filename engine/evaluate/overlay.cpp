// SPDX-License-Identifier: Apache-2.0
#include "engine/evaluate/overlay.h"

#include <geos_c.h>

#include <utility>

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
  if (!geometry) throw Error("polygons could not be laid over each other (GEOS gave none); are their corners finite?");
  return Owned(geometry);
}

Owned linear_ring(std::span<const FlatPoint> ring) {
  GEOSCoordSequence* corners = GEOSCoordSeq_create_r(context(), static_cast<unsigned>(ring.size() + 1), 2);
  if (!corners) throw Error("out of memory: polygons");
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const FlatPoint p = ring[i == ring.size() ? 0 : i];
    GEOSCoordSeq_setXY_r(context(), corners, static_cast<unsigned>(i), p.x, p.y);
  }
  return checked(GEOSGeom_createLinearRing_r(context(), corners));
}

// A ring's inside; of one that crosses itself, what GEOS makes of it.
Owned inside_of(std::span<const FlatPoint> ring) {
  Owned made = checked(GEOSGeom_createPolygon_r(context(), linear_ring(ring).release(), nullptr, 0));
  if (GEOSisValid_r(context(), made.get()) == 1) return made;
  return checked(GEOSMakeValid_r(context(), made.get()));
}

// Holes are taken away one by one: they may touch the outer ring, or run along it.
Owned polygon_of(const FlatPolygon& polygon) {
  Owned made = inside_of(polygon.ring);
  for (const std::vector<FlatPoint>& hole : polygon.holes)
    if (hole.size() >= 3) made = checked(GEOSDifference_r(context(), made.get(), inside_of(hole).get()));
  return made;
}

double area_of(const GEOSGeometry* geometry) {
  double area = 0;
  GEOSArea_r(context(), geometry, &area);
  return area;
}

void append_ring(const GEOSGeometry* ring, std::vector<FlatEdge>& edges) {
  const GEOSCoordSequence* corners = GEOSGeom_getCoordSeq_r(context(), ring);
  unsigned count = 0;
  GEOSCoordSeq_getSize_r(context(), corners, &count);
  FlatPoint last;
  for (unsigned i = 0; i < count; ++i) {
    FlatPoint p;
    GEOSCoordSeq_getXY_r(context(), corners, i, &p.x, &p.y);
    if (i > 0) edges.push_back({last, p});
    last = p;
  }
}

void append_edges(const GEOSGeometry* geometry, std::vector<FlatEdge>& edges) {
  const int type = GEOSGeomTypeId_r(context(), geometry);
  if (type == GEOS_POLYGON) {
    if (GEOSisEmpty_r(context(), geometry) == 1) return;
    append_ring(GEOSGetExteriorRing_r(context(), geometry), edges);
    for (int i = 0; i < GEOSGetNumInteriorRings_r(context(), geometry); ++i)
      append_ring(GEOSGetInteriorRingN_r(context(), geometry, i), edges);
  } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    for (int i = 0; i < GEOSGetNumGeometries_r(context(), geometry); ++i)
      append_edges(GEOSGetGeometryN_r(context(), geometry, i), edges);
  }
}

}  // namespace

struct FlatArea::Geometry {
  Owned shape;
  double area = 0;
};

FlatArea::FlatArea(std::span<const FlatPolygon> polygons, double grid) {
  std::vector<Owned> owned;
  for (const FlatPolygon& polygon : polygons)
    if (polygon.ring.size() >= 3) owned.push_back(polygon_of(polygon));
  std::vector<GEOSGeometry*> parts;
  for (Owned& part : owned) parts.push_back(part.release());
  const Owned all = checked(GEOSGeom_createCollection_r(context(), GEOS_GEOMETRYCOLLECTION, parts.data(),
                                                        static_cast<unsigned>(parts.size())));
  Geometry made;
  made.shape =
      checked(grid > 0 ? GEOSUnaryUnionPrec_r(context(), all.get(), grid) : GEOSUnaryUnion_r(context(), all.get()));
  made.area = area_of(made.shape.get());
  geometry_ = std::make_shared<const Geometry>(std::move(made));
}

double FlatArea::area() const {
  return geometry_->area;
}

double FlatArea::common_area(const FlatArea& other) const {
  return area_of(checked(GEOSIntersection_r(context(), geometry_->shape.get(), other.geometry_->shape.get())).get());
}

std::vector<FlatEdge> FlatArea::edges() const {
  std::vector<FlatEdge> edges;
  append_edges(geometry_->shape.get(), edges);
  return edges;
}

double intersection_over_union(const FlatArea& a, const FlatArea& b) {
  const double common = a.common_area(b), together = a.area() + b.area() - common;
  return together > 0 ? common / together : 0;
}

}  // namespace ilot
