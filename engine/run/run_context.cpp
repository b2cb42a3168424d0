// SPDX-License-Identifier: Apache-2.0
#include "engine/run/run_context.h"

#include <cmath>

#include "engine/run/memory_budget.h"

namespace ilot {
namespace {

constexpr double kHalfDiagonal = 0.8660254037844387;  // of a cell: the greatest move by rounding

// The borders of a box are lattice lines and closed: a point on the border of two boxes belongs to both.
std::function<bool(Index3)> inside_area(const Area& area, double unit) {
  constexpr double kOnTheLine = 1e-6;  // of a unit: rounding of the division
  const auto x0 = static_cast<std::int64_t>(std::ceil(area.min_x / unit - kOnTheLine));
  const auto y0 = static_cast<std::int64_t>(std::ceil(area.min_y / unit - kOnTheLine));
  const auto x1 = static_cast<std::int64_t>(std::floor(area.max_x / unit + kOnTheLine));
  const auto y1 = static_cast<std::int64_t>(std::floor(area.max_y / unit + kOnTheLine));
  return [&area, unit, x0, y0, x1, y1](Index3 p) {
    if (p.x < x0 || p.x > x1 || p.y < y0 || p.y > y1) return false;
    return area.rings.empty() || area.contains(static_cast<double>(p.x) * unit, static_cast<double>(p.y) * unit);
  };
}

}  // namespace

PassContext pass_context(const RunOptions& options, const RunInputs& inputs, std::uint64_t block_points,
                         Progress& progress) {
  PassContext context;
  context.budget_bytes = memory_for_blocks(options);
  context.memory_bytes = options.memory_bytes;
  context.task_points = 2 * block_points;
  context.metres_per_unit = inputs.crs.metres_per_unit;
  context.advance = [&progress](std::uint64_t points) { progress.advance(points); };
  return context;
}

void set_lattice(const RunOptions& options, const RunInputs& inputs, const InputLattice& lattice,
                 PassContext& context) {
  context.rounding = 0;
  for (const auto& reader : inputs.readers)
    if (!LatticeMap(reader->info().layout, lattice.finest()).exact()) context.rounding = kHalfDiagonal;
  if (options.area) context.wanted = inside_area(*options.area, lattice.unit);
}

}  // namespace ilot
