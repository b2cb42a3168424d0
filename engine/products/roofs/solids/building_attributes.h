// SPDX-License-Identifier: Apache-2.0
// What is known of a building beside its shape.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include "engine/model/building.h"
#include "engine/products/roofs/sites/roof_site.h"
#include "engine/products/roofs/solids/roof_model.h"
#include "engine/units/value_counts.h"
#include "kernels/planes/plane_fit.h"

namespace ilot {

using BuildingAttributes = std::vector<std::pair<std::string, AttributeValue>>;

const char* name_of(RoofStatus status);

// A roof face of a model: its plane, metres from the site's anchor, and its area.
struct MeasuredFace {
  Plane plane;
  double area = 0;
};

// How a building's points and its model agree. Add every point of the building once, in global order: a mean depends on
// the order of its sum. Memory is bounded (value_counts.h).
class PointMeasures {
 public:
  PointMeasures(const RoofSite& site, const RoofModel& model, double metres_per_unit);

  // Metres from the anchor; the face that the point is on, a plane_id of lod22, or 0.
  void add(Vec3 p, std::uint32_t face);

  std::uint64_t points() const { return points_; }
  double rmse() const;       // of the points on faces from their planes; NaN without one
  double share_off() const;  // of the points that are on no face
  ValueCounts& heights() { return on_faces_.count() > 0 ? on_faces_ : off_faces_; }  // on faces, else of all
  const std::map<std::uint32_t, MeasuredFace>& faces() const { return faces_; }

 private:
  std::map<std::uint32_t, MeasuredFace> faces_;
  std::uint64_t points_ = 0, off_ = 0, measured_ = 0;
  ValueCounts on_faces_, off_faces_;
  double squares_ = 0;
};

// status, reason, points, heights, area, how well points and model agree: docs/outputs.md. Heights in CRS units.
BuildingAttributes building_attributes(const RoofSite& site, const RoofModel& model, double metres_per_unit,
                                       PointMeasures& measures);

// The outline as a flat surface on the ground, lod 0: what is left of a building without a solid.
Building flat_outline(const RoofSite& site, double metres_per_unit);

}  // namespace ilot
