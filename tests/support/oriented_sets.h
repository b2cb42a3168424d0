// SPDX-License-Identifier: Apache-2.0
// Integer points with normals, made patch by patch, in Morton order. They are scenes for plane extraction.
#pragma once
#include <cmath>
#include <numeric>

#include "kernels/core/radix_sort.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/planes/plane_score.h"
#include "tests/support/point_sets.h"

namespace ilot::test {

inline constexpr Vec3 kX{1, 0, 0}, kY{0, 1, 0}, kZ{0, 0, 1};

struct OrientedSet : PaddedOrientedPoints {
  OrientedPoints view() const { return oriented(); }
};

// Returns the sum of twelve uniform numbers. It is bell-shaped with standard deviation 1 and never beyond 6.
inline double bell(Rng& rng) {
  double sum = -6;
  for (int i = 0; i < 12; ++i) sum += rng.uniform();
  return sum;
}

// A rectangle of columns x rows points, `step` apart, along the unit vectors u and v.
struct Patch {
  Vec3 origin, u, v;
  int columns = 0, rows = 0;
  double step = 1, noise = 0;
  Vec3 normal() const { return cross(u, v); }
};

class OrientedSetBuilder {
 public:
  explicit OrientedSetBuilder(std::uint64_t key) : rng_(key) {}

  void add(Vec3 p, Vec3 n) { points_.push_back({p, n}); }
  // Normals deviate by up to `lean` (tangent of an angle) in either direction.
  void add(const Patch& patch, double lean = 0) {
    for (int i = 0; i < patch.columns; ++i)
      for (int j = 0; j < patch.rows; ++j) {
        const Vec3 p = patch.origin + patch.step * i * patch.u + patch.step * j * patch.v;
        const double a = lean * (2 * rng_.uniform() - 1), b = lean * (2 * rng_.uniform() - 1);
        const Vec3 n = patch.normal() + a * patch.u + b * patch.v;
        add(p + patch.noise * bell(rng_) * patch.normal(), (1 / norm(n)) * n);
      }
  }
  // Rounds the points to integers and sorts them. Coordinates must not be negative.
  OrientedSet build() const {
    std::vector<std::uint64_t> codes;
    for (const auto& [p, n] : points_) {
      const auto whole = [](double v) { return static_cast<std::uint32_t>(std::nearbyint(v)); };
      codes.push_back(morton_code({whole(p.x), whole(p.y), whole(p.z)}));
    }
    OrientedSet set;
    for (const std::uint32_t i : sorted_order(codes)) {
      const Cell3 c = morton_cell(codes[i]);
      const Vec3 n = points_[i].second;
      set.add(static_cast<float>(c.x), static_cast<float>(c.y), static_cast<float>(c.z));
      set.nx.push_back(static_cast<float>(n.x));
      set.ny.push_back(static_cast<float>(n.y));
      set.nz.push_back(static_cast<float>(n.z));
    }
    set.pad();
    return set;
  }

 private:
  Rng rng_;
  std::vector<std::pair<Vec3, Vec3>> points_;
};

}  // namespace ilot::test
