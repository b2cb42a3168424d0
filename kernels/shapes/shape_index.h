// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/planes/plane_score.h"

namespace ilot {

// Leaves of 64 points with normals, each with a ball around its points and a cone around its normals. Places without a
// point are NaN.
struct ShapeLeaves {
  static constexpr std::uint32_t kLeaf = 64;
  static constexpr std::size_t kBallFloats = 4, kConeFloats = 7;

  // All normals of a leaf, in one sense or the other, are within an angle about its axis. Along the axis, all its
  // points are at most half of its thickness from a middle, which is given from the centre of its ball.
  struct Cone {
    float x = 0, y = 0, z = 0;
    float cosine = -1, sine = 0;  // of the angle; -1 and 0, and no axis, where the normals are not unit
    float middle = 0, half = 0;
  };

  std::vector<float> x, y, z, nx, ny, nz;  // whole leaves
  std::vector<std::vector<float>> balls;   // per level, groups of 8: x8 y8 z8 radius8
  std::vector<float> cones;                // of leaves, in groups of 8: x8 y8 z8 cosine8 sine8 middle8 half8

  Vec3 position(std::size_t i) const { return {x[i], y[i], z[i]}; }
  Vec3 normal(std::size_t i) const { return {nx[i], ny[i], nz[i]}; }
};

// Points that were removed, in the order of their removal, with one level of balls. Leaves have points of one removal.
struct RemovedPoints : ShapeLeaves {
  std::vector<std::uint64_t> epoch;  // of each leaf: the epoch that began with its removal, ascending
};

// Points with normals in Morton order of their own box, under a hierarchy of bounding balls. 64 points are a leaf,
// eight leaves are a node, and so on. Points can be removed. A removed point is a hole: its coordinates are NaN, so no
// test finds it. A ball without points has the radius NaN, so no shape comes near it.
struct ShapeIndex : ShapeLeaves {
  std::vector<std::uint32_t> index;  // per position: index of the caller's point
  std::vector<std::uint64_t>
      code;  // per position: Morton code from the box's corner; its step is a unit in boxes below 2^21 units
  std::vector<std::uint32_t> in_leaf;  // per leaf: points that are left
  RemovedPoints removed;               // since epoch `built`
  std::size_t size = 0;                // number of positions, holes included
  std::size_t left = 0;                // number of points
  std::uint64_t epoch = 1, built = 1;  // grows whenever points are removed; where `removed` begins
  Vec3 centre;                         // of the box
  double reach = 0;                    // half its diagonal
  int first_level = 0,
      levels = 0;  // octree levels that are useful for sampling: cells of 2^(first_level + i) steps of the codes

  bool is_hole(std::size_t i) const { return x[i] != x[i]; }
  // Returns the positions of the octree cell of edge 2^level steps around position i.
  struct Range {
    std::size_t begin, end;
  };
  Range cell_around(std::size_t i, int level) const;
};

// Builds the index of the chosen points (indices) that have a normal. When there are no normals at all, it contains all
// chosen points with normals of zero. These agree with a shape where min_cos is zero. Offsets are integers. The result
// does not depend on the order of the indices, except for points that coincide. O(n). `epoch` (from 1) is that of the
// index. Where counts of another index are kept, the one that replaces it must continue with the next epoch.
ShapeIndex build_shape_index(const OrientedPoints& points, std::span<const std::uint32_t> chosen,
                             std::uint64_t epoch = 1);

// Removes the points at these positions, in a new epoch, and lists them as removed, where wanted. O(positions). The
// list is of most use where they are in order. It begins anew, with the points removed later, where points are removed
// that are not listed, and where it would have more leaves than the index, as after many removals of a few points.
void take_out(ShapeIndex& index, std::span<const std::uint32_t> positions, bool listed = true);

}  // namespace ilot
