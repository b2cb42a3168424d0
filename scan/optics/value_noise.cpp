// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/value_noise.h"

#include <array>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

// Returns a uniform value in [-1, 1) for each lattice cell.
double cell_value(std::int64_t x, std::int64_t y, std::int64_t z, std::uint64_t key) {
  const std::uint64_t bits = mix64(mix64(mix64(static_cast<std::uint64_t>(x) ^ key) ^ static_cast<std::uint64_t>(y)) ^
                                   static_cast<std::uint64_t>(z));
  return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

double mix(double a, double b, double share) {
  return a + (b - a) * share;
}

}  // namespace

double value_noise(Vec3 p, std::uint64_t key) {
  const double fx = std::floor(p.x), fy = std::floor(p.y), fz = std::floor(p.z);
  const auto x = static_cast<std::int64_t>(fx), y = static_cast<std::int64_t>(fy), z = static_cast<std::int64_t>(fz);
  const auto smooth = [](double s) { return s * s * (3 - 2 * s); };
  const double u = smooth(p.x - fx), v = smooth(p.y - fy), w = smooth(p.z - fz);
  std::array<double, 2> layers{};
  for (std::int64_t k = 0; k < 2; ++k)
    layers[static_cast<std::size_t>(k)] =
        mix(mix(cell_value(x, y, z + k, key), cell_value(x + 1, y, z + k, key), u),
            mix(cell_value(x, y + 1, z + k, key), cell_value(x + 1, y + 1, z + k, key), u), v);
  return mix(layers[0], layers[1], w);
}

}  // namespace ilot::scan
