// SPDX-License-Identifier: Apache-2.0
// Compares drawn vertices with the true ones. [Marchand 2018, II.5.3]
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "engine/compare/truth.h"
#include "engine/model/facade.h"

namespace ilot {

struct ControlPointParams {
  double limit_m = 0.3;  // a drawn vertex farther away than this, in the plane of the facade, is not homologous
  double depth_m = 0.5;  // a drawn vertex farther than this in front of or behind the true one is not homologous
  double metres_per_unit = 1;
  bool as_documents = false;  // vertices on occluded edges count as completed, as in the tables of the documents
};

struct MeanAndSpread {
  double mean = 0, sd = 0;  // sample standard deviation; 0 for fewer than two
};

struct ControlGroup {
  std::string name;
  std::uint64_t count = 0;       // true control points
  std::uint64_t drawn = 0;       // control points with a homologous vertex
  std::uint64_t missed = 0;      // control points without a homologous vertex
  MeanAndSpread dx_m, dz_m;      // absolute differences along and up the facade, over those drawn
  MeanAndSpread dd_m;            // distances in its plane
  std::uint64_t completed = 0;   // drawn vertices of elements or edges that are completed, not seen
  MeanAndSpread completed_dd_m;  // of these alone
};

// Returns groups in the order of their first control point. The name of a group before the first underscore gives the
// kind of element on which its vertices are searched: window_top on windows (and on elements of kind `opening`). Every
// vertex serves at most one control point of a group. Pairs are made in the order of their distance (ties: the earlier
// control point, then the earlier vertex). A control point without a vertex within the limit is missed. Occluded
// elements have no drawn vertices, and a vertex between an occluded edge and any other is not drawn: its control point
// is missed. There may be several facades; each control point is measured in the axes of the
// facade of its vertex. O(c v) per group.
std::vector<ControlGroup> evaluate_control_points(std::span<const TrueControlPoint> truth,
                                                  std::span<const Facade> facades,
                                                  const ControlPointParams& params = {});

// The mean and the sample standard deviation of the values.
MeanAndSpread mean_and_spread(std::span<const double> values);

}  // namespace ilot
