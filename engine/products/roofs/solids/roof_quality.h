// SPDX-License-Identifier: Apache-2.0
// How well a model agrees with all points of its building, and whether it should be looked at.
#pragma once
#include <cstdint>
#include <map>
#include <string>

#include "engine/products/roofs/sites/roof_site.h"
#include "engine/products/roofs/solids/roof_model.h"
#include "engine/products/roofs/solids/roof_raster.h"
#include "engine/units/value_counts.h"
#include "engine/visibility/closest_point.h"
#include "kernels/planes/plane_fit.h"

namespace ilot {

// A roof face of a model: its plane in metres from the site's anchor, and its area.
struct MeasuredFace {
  Plane plane;
  double area = 0;
};

// The worst of the figures decides (thresholds: roof_quality.cpp).
struct RoofVerdict {
  const char* quality = "bad";  // good, check or bad
  std::string reason;           // the figure that decides; empty when the quality is good
};

// Measures how a building's points and its model agree. Add every point of the building once, in global order, because
// a mean depends on the order of its sum. The model is the solid of the highest level of detail. Memory is bounded
// (value_counts.h, roof_raster.h).
class PointMeasures {
 public:
  PointMeasures(const RoofSite& site, const RoofModel& model, double metres_per_unit);

  // Adds a point in metres from the anchor. `face` is the face that contains the point, a plane_id of lod22, or 0. The
  // distance of a point on a face is that to its plane; of others, that to the nearest roof, wall or floor.
  void add(Vec3 p, std::uint32_t face);

  std::uint64_t points() const { return points_; }
  bool measured() const { return distances_.count() > 0; }  // there are points and a solid; else what follows is NaN
  double rmse() const;                                      // of all points
  double quantile(double share);                            // of the distances of all points
  double explained() const;                                 // share of the points within reach() of the model
  double reach() const { return reach_; }                   // metres
  double step() const;                                      // metres between points in plan, if they were spread evenly
  double largest_off() const { return raster_.largest_off(); }
  double bare_share() const { return raster_.bare_share(); }
  double overshoot() const;
  ValueCounts& heights() { return on_faces_.count() > 0 ? on_faces_ : off_faces_; }  // on faces, else of all points
  const std::map<std::uint32_t, MeasuredFace>& faces() const { return faces_; }
  RoofVerdict verdict(RoofStatus status);

 private:
  std::map<std::uint32_t, MeasuredFace> faces_;
  ClosestPoint surface_;
  double reach_ = 0, top_ = 0, area_ = 0;  // top: of the solid, metres above the anchor
  bool solid_ = false;
  RoofRaster raster_;
  std::uint64_t points_ = 0, off_ = 0, explained_ = 0;
  ValueCounts on_faces_, off_faces_, distances_;
  double squares_ = 0, highest_ = -HUGE_VAL;
};

}  // namespace ilot
