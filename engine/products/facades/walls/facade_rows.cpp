// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/facade_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Whether the second facade continues the first one on its right.
bool continues(const Facade& a, const Facade& b, const RowParams& params) {
  // Derived: neighbours that overlap by more lie one before the other.
  constexpr double kCommon = 0.5;  // share of the narrower one
  const double m = params.metres_per_unit;
  if (dot(a.out, b.out) < cos_degrees(params.turn_deg)) return false;
  const Vec3 d = m * (b.origin - a.origin);
  const double along = dot(d, a.right), low = dot(d, a.up);
  const double off = dot(d - (along - a.width_m) * a.right, b.out) - a.width_m * dot(a.right, b.out);
  if (std::abs(off) > params.step || along <= 0) return false;
  if (along - a.width_m > params.gap || a.width_m - along > kCommon * std::min(a.width_m, b.width_m)) return false;
  return std::min(a.height_m, low + b.height_m) - std::max(0.0, low) >= params.least_height;
}

// Whether the second facade stands before or behind the first one, within its ends: an avant-corps, a storey that
// stands back.
bool stands_along(const Facade& a, const Facade& b, const RowParams& params) {
  // Derived: a majority, so that it belongs to one of two neighbours.
  constexpr double kWithin = 0.5;  // share of its width and of its height
  const double m = params.metres_per_unit;
  if (dot(a.out, b.out) < cos_degrees(params.turn_deg) || b.width_m > a.width_m) return false;
  const Vec3 d = m * (b.origin - a.origin);
  const double along = dot(d, a.right), low = dot(d, a.up);
  if (std::abs(dot(d, a.out)) > params.step) return false;
  const double wide = std::min(a.width_m, along + b.width_m) - std::max(0.0, along);
  const double high = std::min(a.height_m, low + b.height_m) - std::max(0.0, low);
  return wide > kWithin * b.width_m && high > kWithin * b.height_m;
}

// How far each facade of a row begins along the first one. What stands along another one comes after it.
std::vector<double> places_in_row(std::span<const Facade> facades, std::span<const std::size_t> row,
                                  const RowParams& params) {
  const Facade& first = facades[row[0]];
  std::vector<double> places(facades.size());
  for (const std::size_t k : row) places[k] = dot(facades[k].origin - first.origin, first.right);
  for (const std::size_t a : row)
    for (const std::size_t b : row)
      if (a < b && stands_along(facades[a], facades[b], params)) places[b] = std::max(places[b], places[a]);
  return places;
}

}  // namespace

std::vector<std::vector<std::size_t>> facade_rows(std::span<const Facade> facades, const RowParams& params) {
  std::vector<std::size_t> root(facades.size());
  std::iota(root.begin(), root.end(), std::size_t{0});
  const auto find = [&](std::size_t i) {
    while (root[i] != i) i = root[i];
    return i;
  };
  for (std::size_t i = 0; i < facades.size(); ++i)
    for (std::size_t k = 0; k < facades.size(); ++k)
      if (i != k &&
          (continues(facades[i], facades[k], params) || (i < k && stands_along(facades[i], facades[k], params)))) {
        const std::size_t a = find(i), b = find(k);
        root[std::max(a, b)] = std::min(a, b);
      }
  std::vector<std::vector<std::size_t>> rows;
  for (std::size_t i = 0; i < facades.size(); ++i) {
    if (find(i) != i) continue;
    std::vector<std::size_t> row;
    for (std::size_t k = i; k < facades.size(); ++k)
      if (find(k) == i) row.push_back(k);
    if (row.size() < 2) continue;
    const std::vector<double> places = places_in_row(facades, row, params);
    std::stable_sort(row.begin(), row.end(), [&](std::size_t a, std::size_t b) { return places[a] < places[b]; });
    rows.push_back(std::move(row));
  }
  return rows;
}

}  // namespace ilot
