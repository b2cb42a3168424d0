// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/trees/tree_shape.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <vector>

namespace ilot {
namespace {

// Choice: a tenth of the crown may hang lower, as single twigs and points of what stands below do.
constexpr std::size_t kTenths = 10;
constexpr std::uint32_t kSides = 8;

// The side of a direction: one of eight of 45 degrees, from the signs of the offsets and which is longer.
std::uint32_t side_of(double x, double y) {
  const bool steep = std::abs(y) > std::abs(x);
  return (x < 0 ? 1u : 0u) | (y < 0 ? 2u : 0u) | (steep ? 4u : 0u);
}

// From the variances of the middles of cells, to which a cell itself adds a twelfth.
double elongation_of(double xx, double xy, double yy) {
  xx += 1.0 / 12, yy += 1.0 / 12;
  const double half = (xx + yy) / 2, apart = std::sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
  return std::sqrt((half + apart) / std::max(1e-9, half - apart));
}

}  // namespace

TreeShape tree_shape(const VegetationCells& cells, std::span<const std::uint32_t> crown, double x, double y,
                     double trunk) {
  TreeShape shape;
  std::vector<Height> low;
  double xx = 0, xy = 0, yy = 0;
  for (const std::uint32_t i : crown) {
    const double u = static_cast<double>(i % cells.top.width) + 0.5, v = static_cast<double>(i / cells.top.width) + 0.5;
    shape.x += u, shape.y += v;
    xx += u * u, xy += u * v, yy += v * v;
    ++shape.cells;
    shape.top = std::max(shape.top, cells.top.values[i]);
    shape.points += static_cast<std::uint64_t>(cells.points.values[i]);
    const double du = u - x, dv = v - y;
    if (trunk < 0 || du * du + dv * dv > trunk * trunk) low.push_back(cells.low.values[i]);
  }
  const auto n = static_cast<double>(shape.cells);
  shape.x /= n, shape.y /= n;
  shape.elongation = elongation_of(xx / n - shape.x * shape.x, xy / n - shape.x * shape.y, yy / n - shape.y * shape.y);
  if (low.empty())
    for (const std::uint32_t i : crown) low.push_back(cells.low.values[i]);
  const auto tenth = low.begin() + static_cast<std::ptrdiff_t>(low.size() / kTenths);
  std::nth_element(low.begin(), tenth, low.end());
  shape.base = *tenth;
  return shape;
}

double unseen_share(const VegetationCells& cells, std::span<const std::uint32_t> crown, double x, double y,
                    std::uint32_t first_bin, std::uint32_t last_bin) {
  std::array<std::uint32_t, kSides> seen{};
  for (const std::uint32_t i : crown) {
    const double u = static_cast<double>(i % cells.top.width) + 0.5, v = static_cast<double>(i / cells.top.width) + 0.5;
    seen[side_of(u - x, v - y)] |= static_cast<std::uint32_t>(cells.bins.values[i]);
  }
  const std::uint32_t last = std::min(last_bin, kVegetationBins - 1), first = std::min(first_bin, last);
  const std::uint32_t wanted = ((std::uint32_t{1} << (last - first + 1)) - 1) << first;
  std::uint32_t missing = 0;
  for (const std::uint32_t bins : seen) missing += static_cast<std::uint32_t>(std::popcount(wanted & ~bins));
  return static_cast<double>(missing) / (kSides * (last - first + 1));
}

}  // namespace ilot
