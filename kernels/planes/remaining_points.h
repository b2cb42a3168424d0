// SPDX-License-Identifier: Apache-2.0
// The data that a search for planes still has to examine: the points without a plane, and boxes with which a plane
// skips most of them.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/geometry/padded_points.h"
#include "kernels/planes/plane_score.h"

namespace ilot {

// The points that have no plane yet, compact and in their given order.
struct RemainingPoints : PaddedOrientedPoints {
  std::vector<std::uint32_t> index;  // index into the caller's points

  void add(const RemainingPoints& from, std::size_t i) {
    add_from(from.oriented(), i);
    index.push_back(from.index[i]);
  }
};

// Returns the points that have a normal. O(n).
RemainingPoints with_normals(const OrientedPoints& points);

// Removes the members (positions, ascending). The others keep their order. O(n) from the first member on.
void remove(RemainingPoints& points, std::span<const std::uint32_t> members);

// The axis-parallel box around points.
struct PointExtent {
  float min[3]{INFINITY, INFINITY, INFINITY};
  float max[3]{-INFINITY, -INFINITY, -INFINITY};

  void add(Vec3 p) {
    const double v[3]{p.x, p.y, p.z};
    for (int axis = 0; axis < 3; ++axis) {
      min[axis] = std::min(min[axis], static_cast<float>(v[axis]));
      max[axis] = std::max(max[axis], static_cast<float>(v[axis]));
    }
  }
  bool contains(Vec3 p, std::int64_t margin) const {
    const double v[3]{p.x, p.y, p.z};
    const auto m = static_cast<double>(margin);
    bool inside = true;
    for (int axis = 0; axis < 3; ++axis)
      inside = inside && v[axis] >= static_cast<double>(min[axis]) - m && v[axis] <= static_cast<double>(max[axis]) + m;
    return inside;
  }
  // Returns false only where all points of the box are farther than `distance` from the plane.
  bool may_reach(const Plane& plane, double distance) const {
    // Derived: above the rounding of float32 in a cell.
    constexpr double kRounding = 1e-3;
    const double n[3]{plane.n.x, plane.n.y, plane.n.z};
    double centre = plane.d, half = 0;
    for (int axis = 0; axis < 3; ++axis) {
      centre += n[axis] * 0.5 * (static_cast<double>(min[axis]) + static_cast<double>(max[axis]));
      half += std::abs(n[axis]) * 0.5 * (static_cast<double>(max[axis]) - static_cast<double>(min[axis]));
    }
    return std::abs(centre) <= half + distance + kRounding;
  }
  bool meets(const PointExtent& o, double margin) const {
    bool meet = true;
    for (int axis = 0; axis < 3; ++axis) {
      meet = meet && min[axis] - margin <= static_cast<double>(o.max[axis]) &&
             o.min[axis] - margin <= static_cast<double>(max[axis]);
    }
    return meet;
  }
};

// Boxes around every kRun consecutive points. Points are in the order of a space-filling curve, so a plane misses most
// boxes.
class RunBoxes {
 public:
  static constexpr std::size_t kRun = 32;

  // Computes the boxes of the runs from the point `from` on again.
  void update(const RemainingPoints& r, std::size_t from) {
    boxes_.resize((r.size + kRun - 1) / kRun);
    for (std::size_t b = from / kRun; b < boxes_.size(); ++b) {
      boxes_[b] = {};
      for (std::size_t i = b * kRun; i < end(b, r); ++i) boxes_[b].add(r.position(i));
    }
  }
  std::size_t count() const { return boxes_.size(); }
  static std::size_t end(std::size_t run, const RemainingPoints& r) { return std::min(r.size, (run + 1) * kRun); }
  const PointExtent& operator[](std::size_t run) const { return boxes_[run]; }

 private:
  std::vector<PointExtent> boxes_;
};

}  // namespace ilot
