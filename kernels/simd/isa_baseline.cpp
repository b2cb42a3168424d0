// SPDX-License-Identifier: Apache-2.0
#include "kernels/simd/dispatch.h"
#include "kernels/simd/lanes_baseline.h"

namespace ilot::simd::baseline {
#include "kernels/neighbours/knn.inl"
#include "kernels/planes/plane_score.inl"
extern const Table kTable;
const Table kTable{"baseline", count_inliers, knn};
}  // namespace ilot::simd::baseline
