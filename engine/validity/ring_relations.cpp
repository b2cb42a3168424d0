// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/ring_relations.h"

#include <memory>
#include <string_view>
#include <utility>

#include "engine/error.h"
#include "engine/geos_context.h"

namespace ilot {
namespace {

GEOSGeometry* linear_ring(const std::vector<Point2>& ring) {
  GEOSCoordSequence* corners = GEOSCoordSeq_create_r(geos_context(), static_cast<unsigned>(ring.size() + 1), 2);
  if (!corners) throw Error("out of memory: polygons");
  for (std::size_t i = 0; i <= ring.size(); ++i) {
    const Point2 p = ring[i == ring.size() ? 0 : i];
    GEOSCoordSeq_setXY_r(geos_context(), corners, static_cast<unsigned>(i), p.x, p.y);
  }
  GEOSGeometry* made = GEOSGeom_createLinearRing_r(geos_context(), corners);
  if (!made) throw Error("out of memory: polygons");
  return made;
}

int code_of(std::string_view reason) {
  constexpr std::pair<std::string_view, int> kReasons[] = {{"Self-intersection", 201},
                                                           {"Duplicate Rings", 202},
                                                           {"Interior is disconnected", 205},
                                                           {"Hole lies outside shell", 206},
                                                           {"Holes are nested", 207}};
  for (const auto& [words, code] : kReasons)
    if (reason.find(words) != reason.npos) return code;
  return reason.find("Valid Geometry") != reason.npos ? 0 : 999;
}

}  // namespace

int ring_relation_fault(std::span<const std::vector<Point2>> rings) {
  std::vector<GEOSGeometry*> holes;
  for (const std::vector<Point2>& hole : rings.subspan(1)) holes.push_back(linear_ring(hole));
  GEOSGeometry* polygon = GEOSGeom_createPolygon_r(geos_context(), linear_ring(rings[0]), holes.data(),
                                                   static_cast<unsigned>(holes.size()));
  if (!polygon) throw Error("out of memory: polygons");
  char* reason = GEOSisValidReason_r(geos_context(), polygon);
  const int code = reason ? code_of(reason) : 999;
  GEOSFree_r(geos_context(), reason);
  GEOSGeom_destroy_r(geos_context(), polygon);
  return code;
}

}  // namespace ilot
