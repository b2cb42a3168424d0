// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/wall_form.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

// Returns a uniform value in [-1, 1) for each cell of a lattice.
double cell_value(std::int64_t x, std::int64_t z, std::uint64_t key) {
  const std::uint64_t bits = mix64(mix64(static_cast<std::uint64_t>(x) ^ key) ^ static_cast<std::uint64_t>(z));
  return static_cast<double>(bits >> 11) * 0x1p-52 - 1;
}

// Value noise in the plane: random values at the corners of a lattice with smooth interpolation between them.
double noise(double x, double z, std::uint64_t key) {
  const double fx = std::floor(x), fz = std::floor(z);
  const auto i = static_cast<std::int64_t>(fx), k = static_cast<std::int64_t>(fz);
  const auto smooth = [](double s) { return s * s * (3 - 2 * s); };
  const double u = smooth(x - fx), v = smooth(z - fz);
  const double low = cell_value(i, k, key) * (1 - u) + cell_value(i + 1, k, key) * u;
  const double high = cell_value(i, k + 1, key) * (1 - u) + cell_value(i + 1, k + 1, key) * u;
  return low * (1 - v) + high * v;
}

struct StonePlace {
  std::int64_t row = 0, column = 0;
  double x = 0, z = 0;  // from the lower left corner of the joint before the stone
};

StonePlace stone_at(const WallRelief& r, double x, double z) {
  StonePlace s;
  const double up = r.stone_height + r.joint, across = r.stone_width + r.joint;
  s.row = static_cast<std::int64_t>(std::floor(z / up));
  s.z = z - static_cast<double>(s.row) * up;
  const double from = x + (s.row % 2 == 0 ? 0 : across / 2);
  s.column = static_cast<std::int64_t>(std::floor(from / across));
  s.x = from - static_cast<double>(s.column) * across;
  return s;
}

}  // namespace

double WallForm::at(double x, double z) const {
  if (flat()) return 0;
  const double s = std::clamp(x / width, 0.0, 1.0), t = std::clamp(z / height, 0.0, 1.0);
  return lean * t + bow_across * 4 * s * (1 - s) + bow_up * 4 * t * (1 - t);
}

double WallForm::most() const {
  return std::abs(lean) + std::abs(bow_across) + std::abs(bow_up);
}

FormPlane plane_of_form(const WallForm& form, double x0, double x1, double z0, double z1) {
  // On a symmetric lattice the three unknowns are independent of each other.
  constexpr int kSteps = 4, kCells = 2 * kSteps + 1;
  const double mx = (x0 + x1) / 2, mz = (z0 + z1) / 2;
  double sum = 0, sx = 0, sz = 0, xx = 0, zz = 0;
  for (int i = -kSteps; i <= kSteps; ++i)
    for (int k = -kSteps; k <= kSteps; ++k) {
      const double dx = (x1 - x0) * i / kCells, dz = (z1 - z0) * k / kCells;
      const double h = form.at(mx + dx, mz + dz);
      sum += h;
      sx += h * dx;
      sz += h * dz;
      xx += dx * dx;
      zz += dz * dz;
    }
  FormPlane plane;
  plane.along = xx > 0 ? sx / xx : 0;
  plane.up = zz > 0 ? sz / zz : 0;
  plane.base = sum / (kCells * kCells) - plane.along * mx - plane.up * mz;
  return plane;
}

double relief_at(const WallRelief& r, double x, double z) {
  double out = 0;
  if (r.roughness > 0)
    out += r.roughness * (0.65 * noise(x / r.grain, z / r.grain, r.key) +
                          0.35 * noise(3.1 * x / r.grain, 3.1 * z / r.grain, r.key + 1));
  if (r.stone_out > 0 && r.stone_width > 0) {
    const StonePlace s = stone_at(r, x, z);
    out += r.stone_out * cell_value(s.column, s.row, r.key + 2);
  }
  return out;
}

bool in_joint(const WallRelief& r, double x, double z) {
  if (!(r.stone_width > 0) || !(r.joint > 0)) return false;
  const StonePlace s = stone_at(r, x, z);
  return s.x < r.joint || s.z < r.joint;
}

}  // namespace ilot::scan
