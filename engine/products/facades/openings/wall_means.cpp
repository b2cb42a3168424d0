// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/wall_means.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>
#include <utility>

#include "engine/products/facades/rays/cell_bands.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Derived: twice the quantile of the normal distribution that one in 62 exceeds.
constexpr double kStepOfMeans = 4.28;           // times the scatter of means: the step that they show
constexpr double kMicrometres = 1e6;            // Derived: in a metre
constexpr double kNormalOfMedianMean = 1.4826;  // Derived: standard deviation over median distance, normal noise

// Takes the means of rows [r0, r1). A point before the form is where it is, one behind it where its ray went through.
void mean_rows(const RaySamples& samples, const TrendSurface& form, const MeanLimits& limits, std::int64_t r0,
               std::int64_t r1, const WallCells& grid, WallMeans& means) {
  const auto first = static_cast<std::size_t>(r0 * grid.columns);
  // Whole micrometres, so that the order of the points does not matter.
  std::vector<std::int64_t> sums(static_cast<std::size_t>((r1 - r0) * grid.columns), 0);
  const Box2 rows{0, static_cast<double>(grid.columns) * grid.cell, static_cast<double>(r0) * grid.cell,
                  static_cast<double>(r1) * grid.cell};
  for (const Ray& ray : samples.near(rows.grown(grid.cell + 2 * std::max(0.0, limits.to)))) {
    const double off = static_cast<double>(ray.at.w) - form.at(ray.at.u, ray.at.v);
    if (off < limits.from || off > limits.to) continue;
    const Place2 p = off > 0 ? Place2{ray.at.u, ray.at.v} : samples.crossing(ray, 0);
    if (p.u < 0 || p.v < 0) continue;
    const auto c = static_cast<std::int64_t>(p.u / grid.cell), r = static_cast<std::int64_t>(p.v / grid.cell);
    if (c >= grid.columns || r < r0 || r >= r1) continue;
    const auto at = static_cast<std::size_t>(r * grid.columns + c);
    sums[at - first] += std::llround(kMicrometres * std::clamp(off, limits.low, limits.high));
    ++means.points[at];
  }
  for (std::size_t i = 0; i < sums.size(); ++i)
    if (means.has(first + i))
      means.mean[first + i] = static_cast<float>(static_cast<double>(sums[i]) / kMicrometres / means.points[first + i]);
}

WallMeans no_means(const WallCells& grid) {
  return {std::vector<float>(grid.what.size(), 0), std::vector<std::int32_t>(grid.what.size(), 0), 0, 0};
}

// Means over squares of 2 reach + 1 cells about each cell that has points itself.
WallMeans means_over(const WallMeans& cells, const WallCells& grid, std::int64_t reach) {
  WallMeans out = no_means(grid);
  for (std::int64_t r = 0; r < grid.rows; ++r)
    for (std::int64_t c = 0; c < grid.columns; ++c) {
      const auto at = static_cast<std::size_t>(r * grid.columns + c);
      if (!cells.has(at)) continue;
      double sum = 0;
      for (std::int64_t y = std::max<std::int64_t>(0, r - reach); y <= std::min(grid.rows - 1, r + reach); ++y)
        for (std::int64_t x = std::max<std::int64_t>(0, c - reach); x <= std::min(grid.columns - 1, c + reach); ++x) {
          const auto from = static_cast<std::size_t>(y * grid.columns + x);
          sum += static_cast<double>(cells.mean[from]) * cells.points[from];
          out.points[at] += cells.points[from];
        }
      out.mean[at] = static_cast<float>(sum / out.points[at]);
    }
  return out;
}

// The standard deviation of the means that lie before the form: panes lie behind it.
double scatter_before(const WallMeans& means) {
  std::vector<float> before;
  for (std::size_t i = 0; i < means.points.size(); ++i)
    if (means.has(i) && means.mean[i] >= 0) before.push_back(means.mean[i]);
  return before.empty() ? 0 : kNormalOfMedianMean * static_cast<double>(upper_median(before));
}

// The standard deviation of a mean over 2 reach + 1 cells, from its differences to the next one beside it.
double noise_of(const WallMeans& means, const WallCells& grid, std::int64_t reach) {
  const std::int64_t apart = 2 * reach + 1;
  std::vector<float> differences;
  for (std::int64_t r = 0; r < grid.rows; ++r)
    for (std::int64_t c = 0; c + apart < grid.columns; ++c) {
      const auto at = static_cast<std::size_t>(r * grid.columns + c), next = at + static_cast<std::size_t>(apart);
      if (means.has(at) && means.has(next)) differences.push_back(std::abs(means.mean[at] - means.mean[next]));
    }
  return differences.empty()
             ? 0
             : kNormalOfMedianMean * static_cast<double>(upper_median(differences)) / std::numbers::sqrt2;
}

}  // namespace

WallMeans means_about_cells(const RaySamples& samples, const TrendSurface& form, const WallCells& grid,
                            const MeanLimits& limits) {
  WallMeans cells = no_means(grid);
  for (const RowBand& band : bands_of(grid.columns, grid.rows))
    mean_rows(samples, form, limits, band.first, band.end, grid, cells);
  cells.step = kStepOfMeans * noise_of(cells, grid, 0);
  std::optional<WallMeans> best;
  for (std::int64_t reach = 1; (best ? best->step : cells.step) > kLeastStep; ++reach) {
    if (static_cast<double>(2 * reach + 1) * grid.cell > kWidestMean) break;
    WallMeans wider = means_over(cells, grid, reach);
    wider.step = kStepOfMeans * noise_of(wider, grid, reach);
    if (wider.step >= (best ? best->step : cells.step)) break;
    best = std::move(wider);
  }
  WallMeans& means = best ? *best : cells;
  means.step = std::max(kLeastStep, means.step);
  means.scatter = scatter_before(means);
  return std::move(means);
}

}  // namespace ilot
