// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/flat.h"

namespace ilot::scan {

// A flat polygon without holes. It is counter-clockwise if it is seen against the normal of its plane. Patches of one
// plane meet along whole edges.
struct Patch {
  std::uint32_t plane = 0;  // index into a list of planes
  std::vector<std::uint32_t> ring;
};

struct MergedFace {
  std::uint32_t plane = 0;
  std::vector<std::vector<std::uint32_t>> rings;  // outline first, then the holes, which are clockwise
};

// Unites the patches of a plane that share edges. The faces are sorted by plane, then by their smallest vertex. Where a
// region touches itself only in a point, it becomes two faces.
std::vector<MergedFace> merge_patches(std::span<const Patch> patches, std::span<const Vec3> vertices,
                                      std::span<const Plane> planes);

// Removes from the rings the vertices at which no ring has a corner. Faces that share an edge still share it
// afterwards.
void drop_straight_vertices(std::vector<MergedFace>& faces, std::span<const Vec3> vertices);

// Projects a point along the axis in which the normal is largest. The sense of rotation of a polygon does not change.
FlatPoint flatten(Vec3 p, Vec3 normal);

}  // namespace ilot::scan
