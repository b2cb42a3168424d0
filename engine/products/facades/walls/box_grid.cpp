// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/box_grid.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

std::uint64_t key_of(std::int64_t column, std::int64_t row) {
  return mix64(mix64(static_cast<std::uint64_t>(column)) ^ static_cast<std::uint64_t>(row));
}

}  // namespace

bool BoxGrid::cells_of(const FlatBox& box, Cells& cells) const {
  const double c0 = std::floor(box.min.x / cell_), c1 = std::floor(box.max.x / cell_);
  const double r0 = std::floor(box.min.y / cell_), r1 = std::floor(box.max.y / cell_);
  if (!((c1 - c0 + 1) * (r1 - r0 + 1) <= kMostCells)) return false;
  if (!(std::max({-c0, c1, -r0, r1}) < kFarthest)) return false;
  cells = {static_cast<std::int64_t>(c0), static_cast<std::int64_t>(c1), static_cast<std::int64_t>(r0),
           static_cast<std::int64_t>(r1)};
  return true;
}

void BoxGrid::add(std::uint32_t number, const FlatBox& box) {
  all_.push_back(number);
  Cells cells;
  if (!cells_of(box, cells)) return everywhere_.push_back(number);
  for (std::int64_t r = cells.r0; r <= cells.r1; ++r)
    for (std::int64_t c = cells.c0; c <= cells.c1; ++c) numbers_[key_of(c, r)].push_back(number);
}

std::vector<std::uint32_t> BoxGrid::near(const FlatBox& box) const {
  Cells cells;
  std::vector<std::uint32_t> found = everywhere_;
  if (cells_of(box, cells)) {
    for (std::int64_t r = cells.r0; r <= cells.r1; ++r)
      for (std::int64_t c = cells.c0; c <= cells.c1; ++c)
        if (const auto at = numbers_.find(key_of(c, r)); at != numbers_.end())
          found.insert(found.end(), at->second.begin(), at->second.end());
  } else {
    found = all_;
  }
  std::sort(found.begin(), found.end());
  found.erase(std::unique(found.begin(), found.end()), found.end());
  return found;
}

}  // namespace ilot
