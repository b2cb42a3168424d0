// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>

#include "ilot/clusters.h"
#include "kernels/core/types.h"

namespace ilot {

// Euclidean clusters [Boltcheva et al. 2019, 3.1]. Points at most `radius` units apart (inclusive) are in one cluster,
// and so are points joined by a chain of such steps. `indices` selects the points. Offsets are integers. The radius is
// at least 1 and above 2^-20 of the extent of the points. The result is exact and depends on the set of points alone.
// Points are sorted into bins so small that any two points of a bin are within the radius. So only pairs of points in
// neighbouring bins are measured, and only until one pair joins the bins. O(n log n).
Clusters euclidean_clusters(Points points, std::span<const std::uint32_t> indices, std::int64_t radius);

}  // namespace ilot
