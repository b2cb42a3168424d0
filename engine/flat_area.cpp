// SPDX-License-Identifier: Apache-2.0
#include "engine/flat_area.h"

#include <algorithm>
#include <utility>

#include "engine/error.h"
#include "engine/geos_context.h"
#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

GeosOwned checked(GEOSGeometry* geometry) {
  if (!geometry) throw Error("polygons could not be laid over each other (GEOS gave none); are their corners finite?");
  return GeosOwned(geometry);
}

GeosOwned linear_ring(std::span<const FlatPoint> ring) {
  GEOSCoordSequence* corners = GEOSCoordSeq_create_r(geos_context(), static_cast<unsigned>(ring.size() + 1), 2);
  if (!corners) throw Error("out of memory: polygons");
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const FlatPoint p = ring[i == ring.size() ? 0 : i];
    GEOSCoordSeq_setXY_r(geos_context(), corners, static_cast<unsigned>(i), p.x, p.y);
  }
  return checked(GEOSGeom_createLinearRing_r(geos_context(), corners));
}

// The inside of a ring. If the ring crosses itself, it is repaired by GEOS.
GeosOwned inside_of(std::span<const FlatPoint> ring) {
  GeosOwned made = checked(GEOSGeom_createPolygon_r(geos_context(), linear_ring(ring).release(), nullptr, 0));
  if (GEOSisValid_r(geos_context(), made.get()) == 1) return made;
  return checked(GEOSMakeValid_r(geos_context(), made.get()));
}

// Holes are subtracted one by one, because they may touch the outer ring or run along it.
GeosOwned polygon_of(const FlatPolygon& polygon) {
  GeosOwned made = inside_of(polygon.ring);
  for (const std::vector<FlatPoint>& hole : polygon.holes)
    if (hole.size() >= 3) made = checked(GEOSDifference_r(geos_context(), made.get(), inside_of(hole).get()));
  return made;
}

double area_of(const GEOSGeometry* geometry) {
  double area = 0;
  GEOSArea_r(geos_context(), geometry, &area);
  return area;
}

void append_ring(const GEOSGeometry* ring, std::vector<FlatEdge>& edges) {
  const GEOSCoordSequence* corners = GEOSGeom_getCoordSeq_r(geos_context(), ring);
  unsigned count = 0;
  GEOSCoordSeq_getSize_r(geos_context(), corners, &count);
  FlatPoint last;
  for (unsigned i = 0; i < count; ++i) {
    FlatPoint p;
    GEOSCoordSeq_getXY_r(geos_context(), corners, i, &p.x, &p.y);
    if (i > 0) edges.push_back({last, p});
    last = p;
  }
}

GeosOwned normalised(const GEOSGeometry* geometry) {
  GeosOwned normal = checked(GEOSGeom_clone_r(geos_context(), geometry));
  GEOSNormalize_r(geos_context(), normal.get());
  return normal;
}

std::vector<FlatPoint> corners_of(const GEOSGeometry* ring) {
  std::vector<FlatEdge> edges;
  append_ring(ring, edges);
  std::vector<FlatPoint> corners;
  for (const FlatEdge& edge : edges) corners.push_back(edge.a);
  return corners;
}

// GEOS begins outer rings to the right and holes to the left.
std::vector<FlatPoint> turned_corners(const GEOSGeometry* ring) {
  std::vector<FlatPoint> corners = corners_of(ring);
  std::reverse(corners.begin() + 1, corners.end());
  return corners;
}

void append_edges(const GEOSGeometry* geometry, std::vector<FlatEdge>& edges) {
  const int type = GEOSGeomTypeId_r(geos_context(), geometry);
  if (type == GEOS_POLYGON) {
    if (GEOSisEmpty_r(geos_context(), geometry) == 1) return;
    append_ring(GEOSGetExteriorRing_r(geos_context(), geometry), edges);
    for (int i = 0; i < GEOSGetNumInteriorRings_r(geos_context(), geometry); ++i)
      append_ring(GEOSGetInteriorRingN_r(geos_context(), geometry, i), edges);
  } else if (type == GEOS_MULTIPOLYGON || type == GEOS_GEOMETRYCOLLECTION) {
    for (int i = 0; i < GEOSGetNumGeometries_r(geos_context(), geometry); ++i)
      append_edges(GEOSGetGeometryN_r(geos_context(), geometry, i), edges);
  }
}

}  // namespace

bool contains(const FlatPolygon& polygon, FlatPoint p) {
  const auto in = [&](const std::vector<FlatPoint>& ring) {
    bool inside = false;
    for (std::size_t i = 0; i < ring.size(); ++i) inside ^= ray_crosses(p, ring[i], ring[(i + 1) % ring.size()]);
    return inside;
  };
  return in(polygon.ring) && std::none_of(polygon.holes.begin(), polygon.holes.end(), in);
}

struct FlatArea::Geometry {
  GeosOwned shape;
  double area = 0;
};

FlatArea::FlatArea(std::span<const FlatPolygon> polygons, double grid) {
  std::vector<GeosOwned> owned;
  for (const FlatPolygon& polygon : polygons)
    if (polygon.ring.size() >= 3) owned.push_back(polygon_of(polygon));
  std::vector<GEOSGeometry*> parts;
  for (GeosOwned& part : owned) parts.push_back(part.release());
  const GeosOwned all = checked(GEOSGeom_createCollection_r(geos_context(), GEOS_GEOMETRYCOLLECTION, parts.data(),
                                                            static_cast<unsigned>(parts.size())));
  Geometry made;
  made.shape = checked(grid > 0 ? GEOSUnaryUnionPrec_r(geos_context(), all.get(), grid)
                                : GEOSUnaryUnion_r(geos_context(), all.get()));
  made.area = area_of(made.shape.get());
  geometry_ = std::make_shared<const Geometry>(std::move(made));
}

double FlatArea::area() const {
  return geometry_->area;
}

double FlatArea::common_area(const FlatArea& other) const {
  return area_of(
      checked(GEOSIntersection_r(geos_context(), geometry_->shape.get(), other.geometry_->shape.get())).get());
}

std::vector<FlatEdge> FlatArea::edges() const {
  std::vector<FlatEdge> edges;
  append_edges(geometry_->shape.get(), edges);
  return edges;
}

std::vector<FlatPoint> FlatArea::largest_ring() const {
  const GEOSGeometry* largest = nullptr;
  double most = 0;
  for (int i = 0; i < GEOSGetNumGeometries_r(geos_context(), geometry_->shape.get()); ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(geos_context(), geometry_->shape.get(), i);
    const double area = area_of(part);
    if (GEOSGeomTypeId_r(geos_context(), part) != GEOS_POLYGON || !(area > most)) continue;
    largest = part;
    most = area;
  }
  return largest ? corners_of(GEOSGetExteriorRing_r(geos_context(), largest)) : std::vector<FlatPoint>{};
}

// GEOS keeps the corner with which a ring begins. That of the normal form is the leftmost, so it is on the hull.
FlatArea::FlatArea(const FlatArea& whole, double tolerance) {
  Geometry made;
  made.shape = normalised(whole.geometry_->shape.get());
  made.shape = checked(GEOSTopologyPreserveSimplify_r(geos_context(), made.shape.get(), tolerance));
  made.area = area_of(made.shape.get());
  geometry_ = std::make_shared<const Geometry>(std::move(made));
}

FlatArea FlatArea::simplified(double tolerance) const {
  return FlatArea(*this, tolerance);
}

std::vector<FlatPolygon> FlatArea::polygons() const {
  const GeosOwned normal = normalised(geometry_->shape.get());
  std::vector<FlatPolygon> polygons;
  for (int i = 0; i < GEOSGetNumGeometries_r(geos_context(), normal.get()); ++i) {
    const GEOSGeometry* part = GEOSGetGeometryN_r(geos_context(), normal.get(), i);
    if (GEOSGeomTypeId_r(geos_context(), part) != GEOS_POLYGON || GEOSisEmpty_r(geos_context(), part) == 1) continue;
    FlatPolygon polygon{turned_corners(GEOSGetExteriorRing_r(geos_context(), part)), {}};
    for (int k = 0; k < GEOSGetNumInteriorRings_r(geos_context(), part); ++k)
      polygon.holes.push_back(turned_corners(GEOSGetInteriorRingN_r(geos_context(), part, k)));
    polygons.push_back(std::move(polygon));
  }
  return polygons;
}

double intersection_over_union(const FlatArea& a, const FlatArea& b) {
  const double common = a.common_area(b), together = a.area() + b.area() - common;
  return together > 0 ? common / together : 0;
}

}  // namespace ilot
