// SPDX-License-Identifier: Apache-2.0
// The nearest point of a model.
#pragma once
#include <cstdint>
#include <limits>
#include <memory>
#include <vector>

#include "kernels/geometry/closest.h"

namespace ilot {

constexpr std::uint32_t kNoTriangle = 0xffffffffu;

struct SurfacePoint {
  std::uint32_t triangle = kNoTriangle;  // index in the given list
  Vec3 point;
  double squared_distance = std::numeric_limits<double>::infinity();
};

// Finds the point of a set of triangles that is nearest to a place. Embree only excludes triangles, with boxes and
// radii that are larger than the rounding of its floats. Distances are compared in doubles relative to an anchor in the
// middle of the triangles; ties go to the smaller triangle. So the result does not depend on the instruction set that
// Embree chose. Several threads may ask at once. Any finite coordinates are allowed. O(n log n) to build, about O(log
// n) a question.
class ClosestPoint {
 public:
  explicit ClosestPoint(std::vector<Triangle3> triangles);
  ~ClosestPoint();
  ClosestPoint(ClosestPoint&&) noexcept;
  ClosestPoint& operator=(ClosestPoint&&) noexcept;

  // Returns kNoTriangle when no triangle is within `reach` (closed).
  SurfacePoint nearest(Vec3 p, double reach = std::numeric_limits<double>::infinity()) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot
