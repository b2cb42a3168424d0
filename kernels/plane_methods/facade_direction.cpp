// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/facade_direction.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr std::size_t kBins = 180;
constexpr std::size_t kWindow = 5;
// Choice: normals within 20 degrees of level are of walls.
constexpr double kUprightSine = 0.3420201433256687;  // 20 degrees
// Choice: 5 degrees, the width of the peak of directions.
constexpr double kNearCos2 = 0.9924038765061041;  // cosine squared of 5 degrees

// Returns the directions of the azimuths 0, 1, ... 180 degrees.
std::array<Vec3, kBins + 1> bin_edges() {
  std::array<Vec3, kBins + 1> edges;
  for (std::size_t i = 0; i <= kBins; ++i)
    edges[i] = {cos_degrees(static_cast<double>(i)), cos_degrees(static_cast<double>(i) - 90), 0};
  return edges;
}

struct Flat {
  double x, y;
};

// The half plane above the x axis contains one of each pair of opposite vectors.
Flat turned_up(double x, double y) {
  return y < 0 || (y == 0 && x < 0) ? Flat{-x, -y} : Flat{x, y};
}

std::size_t bin_of(const std::array<Vec3, kBins + 1>& edges, Flat v) {
  std::size_t low = 0, high = kBins;  // edges[low] is at or before v
  while (high - low > 1) {
    const std::size_t middle = (low + high) / 2;
    const bool before = edges[middle].x * v.y - edges[middle].y * v.x >= 0;
    (before ? low : high) = middle;
  }
  return low;
}

}  // namespace

FacadeDirection facade_direction(const OrientedPoints& points) {
  if (points.nx == nullptr) return {};
  const auto edges = bin_edges();
  std::array<std::size_t, kBins> count{};
  std::size_t normals = 0;
  const auto upright = [&](std::size_t i) {
    return std::abs(points.nz[i]) < kUprightSine && (points.nx[i] != 0 || points.ny[i] != 0);
  };
  for (std::size_t i = 0; i < points.points.size; ++i) {
    normals += points.nx[i] != 0 || points.ny[i] != 0 || points.nz[i] != 0;
    if (upright(i)) ++count[bin_of(edges, turned_up(points.nx[i], points.ny[i]))];
  }
  std::size_t best = 0, most = 0;
  for (std::size_t b = 0; b < kBins; ++b) {
    std::size_t sum = 0;
    for (std::size_t w = 0; w < kWindow; ++w) sum += count[(b + w) % kBins];
    if (sum <= most) continue;
    most = sum;
    best = b;
  }
  if (most == 0) return {};
  const double middle = static_cast<double>(best) + static_cast<double>(kWindow) / 2;
  const Vec3 peak{cos_degrees(middle), cos_degrees(middle - 90), 0};
  double c = 0, s = 0;  // doubled angles
  std::size_t near = 0;
  for (std::size_t i = 0; i < points.points.size; ++i) {
    if (!upright(i)) continue;
    const double x = points.nx[i], y = points.ny[i], length2 = x * x + y * y;
    const double along = x * peak.x + y * peak.y;
    if (along * along < kNearCos2 * length2) continue;
    c += (x * x - y * y) / length2;
    s += 2 * x * y / length2;
    ++near;
  }
  const double length = std::sqrt(c * c + s * s);
  if (!(length > 0)) return {};
  c /= length;
  const double across = std::sqrt(std::max(0.0, (1 + c) / 2)), up = std::sqrt(std::max(0.0, (1 - c) / 2));
  const Flat n = turned_up(s < 0 ? -across : across, up);
  return {{n.x, n.y, 0}, {-n.y, n.x, 0}, static_cast<double>(near) / static_cast<double>(normals), true};
}

}  // namespace ilot
