// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/relief_cells.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace ilot {
namespace {

// Choice: a leaf 4 cm before the wall hides twice that from an oblique ray; sills hide more.
constexpr double kUnseenBeside = 0.1;  // metres beside a plate that may be hidden before the wall begins

using enum WallCells::What;

// The cells before the wall that lie deeper than plates that begin within reach on the same row on both sides.
std::vector<bool> deeper_cells(const ReliefCells& relief, double apart, std::int64_t reach) {
  const WallCells& cells = relief.cells;
  const auto plate = std::max<std::int64_t>(2, std::llround(kNarrowestPlate / cells.cell));
  std::vector<bool> is_deeper(cells.what.size(), false);
  for (std::int64_t r = 0; r < cells.rows; ++r)
    for (std::int64_t c = 0; c < cells.columns; ++c) {
      if (cells.at(c, r) != kRelief) continue;
      const auto i = static_cast<std::size_t>(r * cells.columns + c);
      const float least = relief.out[i] + static_cast<float>(apart);
      const auto meets_plate = [&](std::int64_t by) {
        std::int64_t run = 0;
        for (std::int64_t k = 1, n = c + by; k < reach + plate && run < plate && n >= 0 && n < cells.columns;
             ++k, n += by)
          run = relief.out[static_cast<std::size_t>(r * cells.columns + n)] > least ? run + 1 : 0;
        return run >= plate;
      };
      is_deeper[i] = meets_plate(-1) && meets_plate(1);
    }
  return is_deeper;
}

}  // namespace

std::vector<bool> pier_cells(const ReliefCells& relief, double apart) {
  const WallCells& cells = relief.cells;
  const auto reach = static_cast<std::int64_t>(kAboutPlate / cells.cell) + 1;
  const std::vector<bool> is_deeper = deeper_cells(relief, apart, reach);
  std::vector<bool> is_pier(cells.what.size(), false);
  for (std::int64_t c = 0; c < cells.columns; ++c)
    for (std::int64_t r = 0; r < cells.rows; ++r) {
      if (cells.at(c, r) != kRelief) continue;
      std::int64_t deeper = 0, all = 0;
      for (std::int64_t k = std::max<std::int64_t>(0, r - reach); k <= std::min(cells.rows - 1, r + reach); ++k) {
        all += cells.at(c, k) == kRelief;
        deeper += is_deeper[static_cast<std::size_t>(k * cells.columns + c)];
      }
      is_pier[static_cast<std::size_t>(r * cells.columns + c)] = 2 * deeper > all;
    }
  return is_pier;
}

double wall_beyond(const ReliefCells& relief, const std::vector<bool>& is_pier, const CellBox& b, double out,
                   Side side) {
  const WallCells& cells = relief.cells;
  const bool u = along_u(side);
  const auto reach = static_cast<std::int64_t>(kAboutPlate / cells.cell) + 1;
  const auto gap = std::max<std::int64_t>(1, std::llround(kUnseenBeside / cells.cell));
  const auto hiding = static_cast<float>(out + kBeforePlate);
  const auto ends = [&](std::int64_t c, std::int64_t r) {
    std::int64_t unseen = 0;
    for (std::int64_t k = 1; k <= reach && unseen <= gap; ++k) {
      c += side == Side::left ? -1 : side == Side::right, r += side == Side::bottom ? -1 : side == Side::top;
      if (c < 0 || r < 0 || c >= cells.columns || r >= cells.rows) break;
      const auto i = static_cast<std::size_t>(r * cells.columns + c);
      if (cells.what[i] == kThrough || relief.out[i] > hiding) break;
      if (cells.what[i] == kSolid || (u && is_pier[i])) return true;
      unseen += !u && cells.what[i] == kUnknown;
    }
    return false;
  };
  double found = 0, lines = 0;
  for (std::int64_t i = u ? b.r0 : b.c0; i <= (u ? b.r1 : b.c1); ++i, ++lines)
    found += u ? ends(side == Side::left ? b.c0 : b.c1, i) : ends(i, side == Side::bottom ? b.r0 : b.r1);
  return found / lines;
}

double relief_share(const ReliefCells& relief, const Box2& box) {
  const WallCells& cells = relief.cells;
  double before = 0, all = 0;
  for (std::int64_t r = 0; r < cells.rows; ++r)
    for (std::int64_t c = 0; c < cells.columns; ++c) {
      const Place2 middle{(static_cast<double>(c) + 0.5) * cells.cell, (static_cast<double>(r) + 0.5) * cells.cell};
      if (!box.contains(middle)) continue;
      ++all, before += cells.at(c, r) == kRelief;
    }
  return all > 0 ? before / all : 0;
}

}  // namespace ilot
