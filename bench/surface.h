// SPDX-License-Identifier: Apache-2.0
// The cloud that kernels are timed on: a town seen from the air at 1 mm, gable roofs on ground, 12 points a square
// metre with 2 cm of noise, Morton sorted. Made from a counter, so it is the same everywhere.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "kernels/core/rng.h"
#include "kernels/core/types.h"
#include "kernels/neighbours/morton.h"

namespace ilot::bench {

struct Surface {
  std::vector<float> x, y, z;
  std::size_t size = 0;
  Points view() const { return {x.data(), y.data(), z.data(), size}; }
};

inline Surface make_surface(std::size_t n) {
  Rng rng(1);
  const double side = 1000 * std::sqrt(static_cast<double>(n) / 12);  // millimetres
  std::vector<std::uint64_t> codes(n);
  for (std::uint64_t& code : codes) {
    const double x = rng.uniform() * side, y = rng.uniform() * side;
    const double u = x - 20000 * std::floor(x / 20000), v = y - 20000 * std::floor(y / 20000);
    const bool roof = u < 10000 && v < 10000;
    double noise = -6;  // sum of twelve uniforms: near enough to normal
    for (int i = 0; i < 12; ++i) noise += rng.uniform();
    const double z = 10000 + 20 * noise + (roof ? 5000 + 0.7 * (5000 - std::abs(v - 5000)) : 0);
    code = morton_code({static_cast<std::uint32_t>(x), static_cast<std::uint32_t>(y), static_cast<std::uint32_t>(z)});
  }
  std::sort(codes.begin(), codes.end());
  Surface s;
  s.size = n;
  for (auto* column : {&s.x, &s.y, &s.z}) column->resize(n + 16);
  for (std::size_t i = 0; i < n; ++i) {
    const Cell3 c = morton_cell(codes[i]);
    s.x[i] = static_cast<float>(c.x);
    s.y[i] = static_cast<float>(c.y);
    s.z[i] = static_cast<float>(c.z);
  }
  return s;
}

}  // namespace ilot::bench
