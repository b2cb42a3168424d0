// SPDX-License-Identifier: Apache-2.0
// The attributes of a building beside its shape.
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

// A roof face of a model: its plane in metres from the site's anchor, and its area.
struct MeasuredFace {
  Plane plane;
  double area = 0;
};

// Measures how a building's points and its model agree. Add every point of the building once, in global order, because
// a mean depends on the order of its sum. Memory is bounded (value_counts.h).
class PointMeasures {
 public:
  PointMeasures(const RoofSite& site, const RoofModel& model, double metres_per_unit);

  // Adds a point in metres from the anchor. `face` is the face that contains the point, a plane_id of lod22, or 0.
  void add(Vec3 p, std::uint32_t face);

  std::uint64_t points() const { return points_; }
  double rmse() const;       // of the points on faces, to their planes; NaN without such a point
  double share_off() const;  // share of the points that are on no face
  ValueCounts& heights() { return on_faces_.count() > 0 ? on_faces_ : off_faces_; }  // on faces, else of all points
  const std::map<std::uint32_t, MeasuredFace>& faces() const { return faces_; }

 private:
  std::map<std::uint32_t, MeasuredFace> faces_;
  std::uint64_t points_ = 0, off_ = 0, measured_ = 0;
  ValueCounts on_faces_, off_faces_;
  double squares_ = 0;
};

// Returns the attributes of docs/outputs.md: status, reason, points, heights, area, and how well points and model
// agree. Heights are in CRS units.
BuildingAttributes building_attributes(const RoofSite& site, const RoofModel& model, double metres_per_unit,
                                       PointMeasures& measures);

// Returns the outline as a flat surface on the ground, lod 0. It is the result for a building without a solid.
Building flat_outline(const RoofSite& site, double metres_per_unit);

}  // namespace ilot
