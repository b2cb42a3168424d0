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
  std::uint32_t triangle = kNoTriangle;  // in the list that was given
  Vec3 point;
  double squared_distance = std::numeric_limits<double>::infinity();
};

// Answers which point of a set of triangles lies nearest. Embree only culls, with boxes and radii grown beyond the
// rounding of its floats; distances are compared in doubles relative to an anchor in the triangles' midst, ties go to
// the smaller triangle, so the answer does not depend on the instruction set that Embree chose. Several threads may ask
// at once. Any finite coordinates. O(n log n) to build, about O(log n) a question.
class ClosestPoint {
 public:
  explicit ClosestPoint(std::vector<Triangle3> triangles);
  ~ClosestPoint();
  ClosestPoint(ClosestPoint&&) noexcept;
  ClosestPoint& operator=(ClosestPoint&&) noexcept;

  // kNoTriangle when nothing lies within `reach` (closed).
  SurfacePoint nearest(Vec3 p, double reach = std::numeric_limits<double>::infinity()) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot
