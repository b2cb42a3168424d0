// SPDX-License-Identifier: Apache-2.0
// Whether one place is seen from another.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "kernels/outlines/plane_section.h"

namespace ilot {

// Answers whether one of a set of flat faces stands between two places. Embree only culls, with boxes grown beyond the
// rounding of its floats; hits are decided in doubles relative to an anchor in the faces' midst, so the answer does not
// depend on the instruction set that Embree chose. A face blocks inside of its rings (even-odd rule), whatever way it
// turns; corners off its plane are taken square onto it, faces without area block nothing. Several threads may ask at
// once. Any finite coordinates. O(n log n) in corners to build; about O(log faces) a question, and of a face that is
// met the edges near the height of the hit. Some 30 bytes a corner and 300 a face.
class LineOfSight {
 public:
  explicit LineOfSight(const std::vector<SectionFace>& faces);
  // Calls what it is given for each face, the same each time.
  using Faces = std::function<void(const std::function<void(const SectionFace&)>&)>;
  static LineOfSight past(const Faces& faces);
  ~LineOfSight();
  LineOfSight(LineOfSight&&) noexcept;
  LineOfSight& operator=(LineOfSight&&) noexcept;

  // False where a face meets the straight line between them, ends included.
  bool clear(Vec3 from, Vec3 to) const;

 private:
  void build(const Faces& faces);
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot
