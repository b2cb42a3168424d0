// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/core/types.h"
#include "kernels/geometry/flat.h"

namespace ilot::scan {

// A flat polygon without holes, counter-clockwise seen against the normal of its plane. Patches of one plane meet along
// whole edges.
struct Patch {
  std::uint32_t plane = 0;  // number in a list of planes
  std::vector<std::uint32_t> ring;
};

struct MergedFace {
  std::uint32_t plane = 0;
  std::vector<std::vector<std::uint32_t>> rings;  // outline first, then holes, clockwise
};

// Unites the patches of a plane that share edges. Faces by plane, then by their smallest vertex. Where a face touches
// itself in a point only, it is two.
std::vector<MergedFace> merge_patches(std::span<const Patch> patches, std::span<const Vec3> vertices,
                                      std::span<const Plane> planes);

// Removes from the rings the vertices at which no ring has a corner, so that faces that share an edge still do.
void drop_straight_vertices(std::vector<MergedFace>& faces, std::span<const Vec3> vertices);

// The polygon seen along the axis in which the normal is largest, keeping its sense of rotation.
FlatPoint flatten(Vec3 p, Vec3 normal);

}  // namespace ilot::scan
