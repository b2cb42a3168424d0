// SPDX-License-Identifier: Apache-2.0
// The cloud on which kernels are timed: a town seen from the air at 1 mm, with gable roofs on ground, 12 points per
// square metre and 2 cm of noise. It is Morton sorted. It is made from a counter, so it is the same everywhere.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/core/rng.h"
#include "kernels/core/types.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/morton.h"

namespace ilot::bench {

struct Surface : PaddedPoints {
  Points view() const { return points(); }
};

// Makes the Morton-sorted surface from codes of integer millimetres.
inline Surface surface_of(std::vector<std::uint64_t> codes) {
  std::sort(codes.begin(), codes.end());
  Surface s;
  s.reset(codes.size());
  for (std::size_t i = 0; i < s.size; ++i) {
    const Cell3 c = morton_cell(codes[i]);
    s.x[i] = static_cast<float>(c.x);
    s.y[i] = static_cast<float>(c.y);
    s.z[i] = static_cast<float>(c.z);
  }
  return s;
}

// There is a house of 10 m with a gable roof every 20 m, and ground elsewhere.
inline std::uint64_t code_at(double x, double y, Rng& rng) {
  const double u = x - 20000 * std::floor(x / 20000), v = y - 20000 * std::floor(y / 20000);
  const bool roof = u < 10000 && v < 10000;
  double noise = -6;  // sum of twelve uniform numbers: sufficiently close to normal
  for (int i = 0; i < 12; ++i) noise += rng.uniform();
  const double z = 10000 + 20 * noise + (roof ? 5000 + 0.7 * (5000 - std::abs(v - 5000)) : 0);
  return morton_code({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z)});
}

inline Surface make_surface(std::size_t n) {
  Rng rng(1);
  const double side = 1000 * std::sqrt(static_cast<double>(n) / 12);  // millimetres
  std::vector<std::uint64_t> codes(n);
  for (std::uint64_t& code : codes) {
    const double x = rng.uniform() * side, y = rng.uniform() * side;
    code = code_at(x, y, rng);
  }
  return surface_of(std::move(codes));
}

// Makes only the roofs of such a town.
inline Surface make_houses(std::size_t n) {
  Rng rng(2);
  const double houses = std::ceil(std::sqrt(static_cast<double>(n) / (12 * 100)));  // per side of the town
  std::vector<std::uint64_t> codes(n);
  for (std::uint64_t& code : codes) {
    const double x = 20000 * std::floor(rng.uniform() * houses) + 10000 * rng.uniform();
    const double y = 20000 * std::floor(rng.uniform() * houses) + 10000 * rng.uniform();
    code = code_at(x, y, rng);
  }
  return surface_of(std::move(codes));
}

}  // namespace ilot::bench
