// SPDX-License-Identifier: Apache-2.0
// Tells whether one place is visible from another.
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "kernels/outlines/plane_section.h"

namespace ilot {

// Tells whether one of a set of flat faces is between two places. Embree only excludes faces, with boxes that are
// larger than the rounding of its floats. Hits are decided in doubles relative to an anchor in the middle of the faces.
// So the result does not depend on the instruction set that Embree chose. A face blocks inside its rings (even-odd
// rule) in both orientations. Corners that are not on its plane are projected onto it perpendicularly; faces without
// area block nothing. Several threads may ask at once. Any finite coordinates are allowed. O(n log n) in corners to
// build. A question takes about O(log faces), and for a face that is hit the edges near the height of the hit. About 30
// bytes a corner and 300 a face.
class LineOfSight {
 public:
  explicit LineOfSight(const std::vector<SectionFace>& faces);
  // Calls its argument for each face, with the same faces each time.
  using Faces = std::function<void(const std::function<void(const SectionFace&)>&)>;
  static LineOfSight past(const Faces& faces);
  ~LineOfSight();
  LineOfSight(LineOfSight&&) noexcept;
  LineOfSight& operator=(LineOfSight&&) noexcept;

  // False when a face meets the straight line between the places, ends included.
  bool clear(Vec3 from, Vec3 to) const;

 private:
  void build(const Faces& faces);
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot
