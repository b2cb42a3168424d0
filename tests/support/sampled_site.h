// SPDX-License-Identifier: Apache-2.0
// Facades made without a scan: points at random positions on flat faces, with noise across the wall and without
// stations.
#pragma once
#include <cmath>

#include "engine/products/facades/facade_site.h"
#include "kernels/core/rng.h"

namespace ilot::test {

class SampledSite {
 public:
  SampledSite(double width, double height, double step, double noise, std::uint64_t seed = 5)
      : step_(step), noise_(noise), rng_(seed) {
    site.axes = {{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
    site.width = width;
    site.height = height;
    site.step = step;
    site.noise = noise;
    site.epsilon = 3.5 * noise;
    site.wall = {1};
  }
  // Adds the parallelogram at `from` along both directions, in the axes of the wall.
  void face(Vec3 from, Vec3 along, Vec3 up, std::uint32_t plane) {
    const auto count = static_cast<std::size_t>(norm(cross(along, up)) / (step_ * step_));
    const Vec3 out = (1 / norm(cross(along, up))) * cross(along, up);
    for (std::size_t i = 0; i < count; ++i) {
      const double off = noise_ * 2 * (rng_.uniform() + rng_.uniform() + rng_.uniform() - 1.5);
      const Vec3 p = from + rng_.uniform() * along + rng_.uniform() * up + off * out;
      site.points.push_back({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z), plane});
    }
  }
  // Adds a rectangle parallel to the wall at the distance w.
  void sheet(double u0, double u1, double v0, double v1, double w, std::uint32_t plane) {
    face({u0, v0, w}, {u1 - u0, 0, 0}, {0, v1 - v0, 0}, plane);
  }
  // Adds the wall except for a hole.
  void wall_around(double u0, double u1, double v0, double v1) {
    if (u0 > 0) sheet(0, u0, 0, site.height, 0, 1);
    if (u1 < site.width) sheet(u1, site.width, 0, site.height, 0, 1);
    if (v0 > 0) sheet(u0, u1, 0, v0, 0, 1);
    if (v1 < site.height) sheet(u0, u1, v1, site.height, 0, 1);
  }

  FacadeSite site;

 private:
  double step_, noise_;
  Rng rng_;
};

}  // namespace ilot::test
