// SPDX-License-Identifier: Apache-2.0
// Compiled with -mavx2: nothing of the standard library with linkage may be instantiated here.
#include "kernels/simd/dispatch.h"
#include "kernels/simd/lanes_avx2.h"

namespace ilot::simd::avx2 {
constexpr char kName[] = "avx2";
#include "kernels/machines/radial_sums.inl"
#include "kernels/neighbours/leaves.inl"

#include "kernels/neighbours/knn.inl"

#include "kernels/neighbours/hough_normals.inl"
#include "kernels/neighbours/normals.inl"
#include "kernels/planes/plane_score.inl"
#include "kernels/rasters/rows.inl"
#include "kernels/shapes/shape_score.inl"

#include "kernels/simd/table.inl"
}  // namespace ilot::simd::avx2
