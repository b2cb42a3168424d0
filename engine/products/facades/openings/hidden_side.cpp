// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/hidden_side.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Derived: far more than a rounded number is wrong by, far less than a cell.
constexpr double kOnBorder = 1e-9;  // share of a cell

// The cells from the first one within a side to its last one, of `most` cells. A side that ends on the border of a cell
// does not lie in this cell.
std::pair<std::int64_t, std::int64_t> cells_between(double from, double to, double cell, std::int64_t most) {
  const auto of = [&](double at) { return std::clamp<std::int64_t>(static_cast<std::int64_t>(at), 0, most - 1); };
  const std::int64_t first = of(std::floor(from / cell + kOnBorder));
  return {first, std::max(first, of(std::ceil(to / cell - kOnBorder) - 1))};
}

}  // namespace

double wall_beyond(const WallCells& cells, const Box2& box, Side side) {
  const bool u = along_u(side);
  const std::int64_t step = outwards(side) > 0 ? 1 : -1, lines = u ? cells.columns : cells.rows;
  const double at = side == Side::left ? box.u0 : side == Side::right ? box.u1 : side == Side::top ? box.v1 : box.v0;
  const auto [from, to] = u ? cells_between(box.v0, box.v1, cells.cell, cells.rows)
                            : cells_between(box.u0, box.u1, cells.cell, cells.columns);
  const std::int64_t first = cells_between(at, at, cells.cell, lines).first;
  std::vector<std::int64_t> free;
  for (std::int64_t i = from; i <= to; ++i) {
    std::int64_t k = first;
    while (k >= 0 && k < lines && (u ? cells.at(k, i) : cells.at(i, k)) != WallCells::kSolid) k += step;
    free.push_back(k);
  }
  const std::int64_t wall = upper_median(std::move(free));
  const double end = static_cast<double>(step > 0 ? wall : wall + 1) * cells.cell;
  return std::max(cells.cell, outwards(side) * (end - at));
}

}  // namespace ilot
