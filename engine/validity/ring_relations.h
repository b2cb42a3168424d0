// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <vector>

#include "kernels/geometry/point2.h"

namespace ilot {

// How the rings of a polygon, each simple, lie to each other: 0 = as they should, 201 they cross or share a piece of an
// edge, 202 two are the same, 205 they cut the inside in two, 206 a hole lies outside, 207 a hole lies in another one,
// 999 anything else. The judge is GEOS; rings may touch in points.
int ring_relation_fault(std::span<const std::vector<Point2>> rings);

}  // namespace ilot
