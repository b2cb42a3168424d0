// SPDX-License-Identifier: Apache-2.0
// Compiled with -mavx2: nothing of the standard library with linkage may be instantiated here.
#include "kernels/simd/dispatch.h"
#include "kernels/simd/lanes_avx2.h"

namespace ilot::simd::avx2 {
#include "kernels/neighbours/knn.inl"
#include "kernels/planes/plane_score.inl"
extern const Table kTable;
const Table kTable{"avx2", count_inliers, knn};
}  // namespace ilot::simd::avx2
