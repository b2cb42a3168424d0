// SPDX-License-Identifier: Apache-2.0
// How the boundaries pass cuts the points into pieces, and what it has to know around each for the pieces' triangles to
// be those of the whole.
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

// The sampling step at a place is told by the distance of its neighbour of that rank.
inline constexpr int kStepNeighbours = 6;

// The points of one octree cell of a block. What happens there belongs to it: the points of a plane whose feet on the
// plane lie in its box, wherever noise has put the points themselves. A plane along the border of two cells would else
// be torn into as many parts as it has points.
struct BoundaryStretch {
  Node node;
  std::uint32_t block = 0, first = 0, count = 0;
  IndexBox box;  // what of the cell is near points of the block
};

// What all blocks share.
struct BoundaryWork {
  const BoundaryParams& params;
  std::int64_t across = 0;                 // units; most that two points of a plane lie apart across it
  std::vector<std::uint64_t> first;        // per block its first point in global order, and the number of all points
  std::vector<BoundaryStretch> stretches;  // in global order
  std::vector<std::size_t> of_block;       // per block its first stretch, and the number of all

  std::span<const BoundaryStretch> of(std::uint32_t block) const {
    return std::span(stretches).subspan(of_block[block], of_block[block + 1] - of_block[block]);
  }
};
BoundaryWork boundary_work(const Store& store, const BoundaryParams& params, const PassContext& context);

// Bytes that the work on one block holds.
std::uint64_t boundary_bytes(const Store& store, std::uint32_t block, const BoundaryWork& work);

// The frame on which a plane's points are triangulated: lattice units, relative to its anchor.
PlaneFrame frame_of_joined(const JoinedPlane& plane);

// The points of one plane around a stretch, those at one place once.
struct PlanePlaces {
  std::uint32_t plane = 0;             // final id
  PlaneOrder order;                    // its indices: points of the view
  std::vector<std::uint8_t> own;       // per place, 1 = the stretch's
  std::vector<std::int64_t> farthest;  // per place, of its point's range, in steps
};

// A stretch with what lies around it: the points that its planes have near it. 32 bytes a point.
class BoundarySurroundings {
 public:
  BoundarySurroundings(const Store& store, const BoundaryStretch& stretch, const BoundaryWork& work);

  // A point of the stretch's own stretch of its block.
  bool is_inside(std::uint32_t i) const {
    return points_[i].number >= first_own_ && points_[i].number < first_own_ + stretch_.count;
  }

  // In global order.
  std::uint64_t number(std::uint32_t i) const { return points_[i].number; }

  // Of points above a plane, in steps of its frame.
  std::vector<std::int32_t> heights(std::uint32_t plane, std::span<const std::uint32_t> points) const;

  // One after the other, by id, the planes that have points of the stretch or next to it.
  void each_plane(const std::function<void(const PlanePlaces&)>& use) const;

 private:
  struct PlanePoint {
    std::uint64_t number = 0;   // in global order
    float x = 0, y = 0, z = 0;  // from the anchor
    std::uint32_t plane = 0;    // final id
    std::int64_t farthest = 1;  // of its range, in steps
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
  std::vector<std::uint32_t> planes_;  // that have points of the stretch or next to it, by id
  std::vector<PlanePoint> points_;     // of these planes, in global order
};

}  // namespace ilot
