// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/stretch_index.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

// Choice: a cell has a few lines; time alone depends on it.
constexpr double kCell = 64;  // metres
// Derived: a quarter of a cell, so that no cell along a line is missed.
constexpr double kStep = 16;  // metres along a line between the places whose surrounding cells are examined

}  // namespace

StretchIndex::StretchIndex(const std::vector<StreetStretch>& stretches, const RasterScale& scale, double farthest)
    : stretches_(stretches), pixel_(scale.pixel), farthest_(farthest) {
  const double reach = (farthest_ + kStep) / pixel_;
  for (std::uint32_t s = 0; s < stretches.size(); ++s) {
    const StreetStretch& stretch = stretches[s];
    const auto steps = static_cast<std::int64_t>(std::ceil(stretch.length / kStep));
    for (std::int64_t i = 0; i <= steps; ++i) {
      const double along = std::min(static_cast<double>(i) * kStep, stretch.length) / pixel_;
      const double x = stretch.x + along * stretch.dx, y = stretch.y + along * stretch.dy;
      const Cell low = cell_of(x - reach, y - reach), high = cell_of(x + reach, y + reach);
      for (std::int64_t row = low.first; row <= high.first; ++row)
        for (std::int64_t column = low.second; column <= high.second; ++column) {
          std::vector<std::uint32_t>& list = near_[{row, column}];
          if (list.empty() || list.back() != s) list.push_back(s);
        }
    }
  }
}

StretchIndex::Cell StretchIndex::cell_of(double x, double y) const {
  const auto at = [&](double v) { return static_cast<std::int64_t>(std::floor(v * pixel_ / kCell)); };
  return {at(y), at(x)};
}

BlockAddress StretchIndex::address(double x, double y) const {
  BlockAddress found;
  const auto near = near_.find(cell_of(x, y));
  if (near == near_.end()) return found;
  double nearest = farthest_;
  for (const std::uint32_t s : near->second) {
    const StreetStretch& stretch = stretches_[s];
    const double px = (x - stretch.x) * pixel_, py = (y - stretch.y) * pixel_;
    const double along = px * stretch.dx + py * stretch.dy;
    const double across = std::abs(py * stretch.dx - px * stretch.dy);
    const double beyond = std::max({0.0, -along, along - stretch.length});
    const double distance = std::sqrt(across * across + beyond * beyond);
    if (distance >= nearest) continue;
    nearest = distance;
    double least = INFINITY;
    for (std::size_t b = 0; b < stretch.blocks.size(); ++b) {
      const double outside = std::max({0.0, stretch.blocks[b].from - along, along - stretch.blocks[b].to});
      if (outside >= least) continue;
      least = outside;
      found = {s + 1, static_cast<std::uint32_t>(b + 1)};
    }
  }
  return found;
}

}  // namespace ilot
