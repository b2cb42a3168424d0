// SPDX-License-Identifier: Apache-2.0
#include "kernels/simd/dispatch.h"
#include "kernels/simd/lanes_baseline.h"

namespace ilot::simd::baseline {
constexpr char kName[] = "baseline";
#include "kernels/machines/radial_sums.inl"
#include "kernels/neighbours/leaves.inl"

#include "kernels/neighbours/knn.inl"

#include "kernels/neighbours/hough_normals.inl"
#include "kernels/neighbours/normals.inl"
#include "kernels/planes/plane_score.inl"
#include "kernels/rasters/rows.inl"
#include "kernels/shapes/shape_score.inl"

#include "kernels/simd/table.inl"
}  // namespace ilot::simd::baseline
