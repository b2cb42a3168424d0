// SPDX-License-Identifier: Apache-2.0
// Adjusts the planes of roof faces so that those that meet in a corner have the same height there.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

// Faces around a vertex whose heights there follow each other within `tolerance` metres are meant to meet. Their planes
// are changed by least squares: the sum of the squared changes at the faces' points, those by tilting ten times, is
// least while the heights agree (penalty method, conjugate gradients). A face whose points would move by more than half
// of the tolerance (root mean square), or any corner by more than it, keeps its plane, and others no longer meet it.
// of_point: per point its face or 0. O(points + rounds x edges).
void adjust_to_concur(const Partition& faces, std::span<const Vec3> points, std::span<const std::uint32_t> of_point,
                      double tolerance, std::vector<RoofPlane>& planes);

}  // namespace ilot
