// SPDX-License-Identifier: Apache-2.0
// How the boundaries pass divides the points into stretches, and which points around a stretch it needs so that its
// triangles are those of the whole cloud.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/products/planes/boundaries/boundaries_pass.h"
#include "engine/store/lattice.h"
#include "engine/store/view.h"
#include "kernels/delaunay/plane_frame.h"
#include "kernels/delaunay/plane_order.h"
#include "kernels/geometry/box3.h"

namespace ilot {

// The distance of the neighbour of this rank gives the sampling step at a place.
inline constexpr int kStepNeighbours = 6;

// The points of one octree cell of a block. The stretch owns the points of a plane whose feet on the plane are in its
// box, wherever noise has moved the points themselves. Otherwise a plane along the border of two cells would be divided
// into as many parts as it has points.
struct BoundaryStretch {
  Node node;
  std::uint32_t block = 0, first = 0, count = 0;
  IndexBox box;  // the part of the cell that is near points of the block
};

// Data that all blocks share.
struct BoundaryWork {
  const BoundaryParams& params;
  std::int64_t across = 0;           // units; greatest distance of two points of a plane across it
  std::vector<std::uint64_t> first;  // for each block its first point in global order; then the number of all points
  std::vector<BoundaryStretch> stretches;  // in global order
  std::vector<std::size_t> of_block;       // for each block its first stretch; then the number of all stretches

  std::span<const BoundaryStretch> of(std::uint32_t block) const {
    return std::span(stretches).subspan(of_block[block], of_block[block + 1] - of_block[block]);
  }
};
BoundaryWork boundary_work(const Store& store, const BoundaryParams& params, const PassContext& context);

// The bytes of memory that the work on one block needs.
std::uint64_t boundary_bytes(const Store& store, std::uint32_t block, const BoundaryWork& work);

// The frame in which the points of a plane are triangulated: in lattice units, relative to the anchor of the plane.
PlaneFrame frame_of_joined(const JoinedPlane& plane);

// The points of one plane around a stretch; points at one place appear once.
struct PlanePlaces {
  std::uint32_t plane = 0;             // final id
  PlaneOrder order;                    // its indices are points of the BoundarySurroundings
  std::vector<std::uint8_t> own;       // per place; 1 = it belongs to the stretch
  std::vector<std::int64_t> farthest;  // per place; `farthest` of the range of its point, in steps
};

// A stretch and the points around it that are on its planes. Needs 32 bytes per point.
class BoundarySurroundings {
 public:
  BoundarySurroundings(const Store& store, const BoundaryStretch& stretch, const BoundaryWork& work);

  // Whether the point is one of the stretch in its block.
  bool is_inside(std::uint32_t i) const {
    return points_[i].number >= first_own_ && points_[i].number < first_own_ + stretch_.count;
  }

  // The number of the point in global order.
  std::uint64_t number(std::uint32_t i) const { return points_[i].number; }

  // The heights of points above a plane, in steps of its frame.
  std::vector<std::int32_t> heights(std::uint32_t plane, std::span<const std::uint32_t> points) const;

  // Calls `use` for each plane that has points in the stretch or next to it, in the order of the ids.
  void each_plane(const std::function<void(const PlanePlaces&)>& use) const;

 private:
  struct PlanePoint {
    std::uint64_t number = 0;   // number in global order
    float x = 0, y = 0, z = 0;  // coordinates from the anchor
    std::uint32_t plane = 0;    // final id
    std::int64_t farthest = 1;  // `farthest` of its range, in steps
  };
  Index3 position_of(std::uint32_t i) const {
    const PlanePoint& p = points_[i];
    return {static_cast<std::int64_t>(p.x) + anchor_.x, static_cast<std::int64_t>(p.y) + anchor_.y,
            static_cast<std::int64_t>(p.z) + anchor_.z};
  }
  void find_planes(const Store& store);
  void load(const Store& store, const View& plan, const IndexBox& box);
  bool is_own(std::uint32_t i, Index3 foot) const;
  PlanePlaces placed(std::uint32_t plane, const std::vector<std::uint32_t>& members) const;
  Vec3 from_anchor(const JoinedPlane& joined, std::uint32_t i) const;

  const BoundaryWork& work_;
  const BoundaryStretch& stretch_;
  Index3 anchor_;
  std::uint64_t first_own_ = 0;        // in global order
  std::vector<std::uint32_t> planes_;  // planes that have points in the stretch or next to it, by id
  std::vector<PlanePoint> points_;     // points of these planes, in global order
};

}  // namespace ilot
