// SPDX-License-Identifier: Apache-2.0
// Drawn vertices against the true ones. [Marchand 2018, II.5.3]
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/compare/truth.h"
#include "engine/model/facade.h"

namespace ilot {

struct ControlPointParams {
  double limit_m = 0.3;  // a drawn vertex farther than this, in the plane of the facade, is not homologous
  double depth_m = 0.5;  // nor is one farther in front of or behind the true one
  double metres_per_unit = 1;
};

struct MeanAndSpread {
  double mean = 0, sd = 0;  // sample standard deviation; 0 for fewer than two
};

struct ControlGroup {
  std::string name;
  std::uint64_t count = 0;       // true control points
  std::uint64_t drawn = 0;       // with a homologous vertex
  std::uint64_t missed = 0;      // without
  MeanAndSpread dx_m, dz_m;      // absolute differences along and up the facade, over those drawn
  MeanAndSpread dd_m;            // distances in its plane
  std::uint64_t completed = 0;   // drawn vertices of elements or edges that are completed, not seen
  MeanAndSpread completed_dd_m;  // of these alone
};

// Groups in the order of their first control point. A group's name tells the kind of element its vertices are sought
// on, before the first underscore: window_top on windows (and on elements of kind `opening`). Every vertex serves one
// control point of a group, pairs in the order of their distance (ties: the earlier control point, then the earlier
// vertex). A control point without a vertex within the limit is missed. Occluded elements draw nothing. Facades may be
// several; each control point is measured in the axes of the facade whose vertex it gets. O(c v) a group.
std::vector<ControlGroup> evaluate_control_points(std::span<const TrueControlPoint> truth,
                                                  std::span<const Facade> facades,
                                                  const ControlPointParams& params = {});

// Mean and sample standard deviation.
MeanAndSpread mean_and_spread(std::span<const double> values);

}  // namespace ilot
