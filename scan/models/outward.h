// SPDX-License-Identifier: Apache-2.0
// Which side of a face is outside. Models orient their faces in both ways, so the geometry decides.
#pragma once
#include <span>
#include <vector>

#include "scan/optics/part_scene.h"

namespace ilot::scan {

class Outward {
 public:
  // The parts must outlive it.
  explicit Outward(std::span<const Part> parts) : scene_(parts) {}

  // Returns `normal` or its opposite: the side on which a ray from the place leaves through fewer faces. With as many
  // on both sides it is `normal`. `normal` has unit length.
  Vec3 of(Vec3 place, Vec3 normal) const {
    return crossings(place, -1.0 * normal) < crossings(place, normal) ? -1.0 * normal : normal;
  }

 private:
  int crossings(Vec3 place, Vec3 direction) const {
    // A little off the normal, so that the ray does not run along edges of walls at right angles.
    const Vec3 way = direction + Vec3{0.013, 0.007, 0.003};
    const Ray ray{place, (1 / norm(way)) * way};
    std::vector<Candidate> candidates;
    scene_.candidates(ray, candidates);
    int count = 0;
    double from = 1e-3;
    while (const auto hit = scene_.nearest(ray, candidates, from)) {
      ++count;
      from = hit->t + 1e-6;
    }
    return count;
  }

  PartScene scene_;
};

}  // namespace ilot::scan
