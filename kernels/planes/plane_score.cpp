// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/plane_score.h"

#include <cassert>

#include "kernels/planes/plane_score_body.h"

namespace ilot {

void count_inliers(const OrientedPoints& points, std::span<const PlaneHypothesis> hypotheses,
                   const PlaneScoreParams& params, std::span<std::uint32_t> counts) {
  assert(counts.size() == hypotheses.size());
  if (hypotheses.empty()) return;
  simd::kPlaneScore.best().count_inliers({points.points.x, points.points.y, points.points.z, points.nx, points.ny,
                                          points.nz, points.points.size, hypotheses.data()->data(), hypotheses.size(),
                                          params.max_distance, params.min_cos, counts.data()});
}

}  // namespace ilot
