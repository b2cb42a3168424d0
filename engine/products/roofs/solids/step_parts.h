// SPDX-License-Identifier: Apache-2.0
// The parts of a building between which its roof steps: LoD1.3.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/faces/roof_planes.h"

namespace ilot {

struct StepParts {
  Partition parts;                // regions are the parts
  std::vector<RoofPlane> planes;  // per part, level
};

struct StepPartParams {
  double step = 3;        // metres; parts that share an edge differ by as much at least
  double quantile = 0.7;  // of the heights of its points: the height of a part
};

// Joins faces into parts, as the buildings of 3DBAG have them [Peters et al. 2022]: of all parts that share an edge and
// differ by less than a step the two that differ least become one, until there are none. The height of a part is that
// quantile of its points; that of a part without a point is the mean height of its corners. `faces` and `planes` are of
// LoD2.2; `points` are those of the roof, metres from the anchor. Corners of the outline stay.
// O(points + faces x (faces + edges)) beside sorting.
StepParts step_parts(const Partition& faces, std::span<const RoofPlane> planes, const SitePolygon& outline,
                     std::span<const Vec3> points, const StepPartParams& params);

}  // namespace ilot
