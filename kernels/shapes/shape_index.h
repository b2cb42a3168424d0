// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/planes/plane_score.h"

namespace ilot {

// Points with normals in Morton order of their own box, under a hierarchy of bounding balls: 64 points are a leaf,
// eight leaves a node, and so on. Points can be taken out; a hole is a point that is not a number, so no test finds it,
// and a ball without points has a radius that is not a number, so that none comes near.
struct ShapeIndex {
  // All normals of a leaf, one way round or the other, lie about the axis within the angle of this cosine and sine.
  struct Cone {
    float x = 0, y = 0, z = 0;
    float cosine = -1, sine = 0;  // of unit normals; -1 and 0: of any others
  };

  static constexpr std::uint32_t kLeaf = 64;

  std::vector<float> x, y, z, nx, ny, nz;  // whole leaves
  std::vector<std::uint32_t> index;        // per position: into the caller's points
  std::vector<std::uint64_t> code;         // per position: Morton code from the box's corner
  std::vector<std::uint32_t> in_leaf;      // points left per leaf
  std::vector<std::uint64_t> changed;      // per leaf: the epoch since which its points are what they are
  std::vector<std::vector<float>> balls;   // per level, groups of 8: x8 y8 z8 radius8
  std::vector<Cone> cones;                 // per leaf
  std::size_t size = 0;                    // positions, holes included
  std::size_t left = 0;                    // points
  std::uint64_t epoch = 1;                 // grows whenever points are taken out
  Vec3 centre;                             // of the box
  double reach = 0;                        // half its diagonal
  int first_level = 0, levels = 0;         // octree levels worth sampling from: cells of 2^(first_level + i) units

  bool is_hole(std::size_t i) const { return x[i] != x[i]; }
  Vec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vec3 normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
  // Positions of the octree cell of edge 2^level units around position i.
  struct Range {
    std::size_t begin, end;
  };
  Range cell_around(std::size_t i, int level) const;
};

// Of the chosen points (indices) that have a normal; without normals at all, of all of them, with normals of zero,
// which agree with a shape where min_cos is zero. Offsets are integers, the box's edges below 2^21 units. The answer
// does not depend on the order of the indices, up to points that coincide. O(n). `epoch` (from 1) is that of the index
// and of all its leaves: one that takes the place of another goes on with the next one.
ShapeIndex build_shape_index(const OrientedPoints& points, std::span<const std::uint32_t> chosen,
                             std::uint64_t epoch = 1);

// Makes holes of the positions, in a new epoch. O(positions).
void take_out(ShapeIndex& index, std::span<const std::uint32_t> positions);

}  // namespace ilot
