// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "ilot/clusters.h"
#include "kernels/core/types.h"

namespace ilot {

// Euclidean clusters [Boltcheva et al. 2019, 3.1]: points at most `radius` units apart (closed) are in one cluster, and
// so are chains of them. `indices` picks the points; offsets are integers, radius at least 1 and above 2^-20 of the
// points' extent. Exact: the answer is a property of the point set alone. Points are binned into cells of which any two
// in one lie within the radius, so that only pairs between neighbouring cells are measured, and only until one joins
// them. O(n log n).
Clusters euclidean_clusters(Points points, std::span<const std::uint32_t> indices, std::int64_t radius);

}  // namespace ilot
