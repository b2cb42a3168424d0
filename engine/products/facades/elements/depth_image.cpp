// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/depth_image.h"

#include <algorithm>
#include <array>

#include "engine/products/facades/rays/cell_bands.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: two steps leave few cells without a point (e^-4 of them at random); a scan with steps above 7.5 cm gets more
// empty cells.
constexpr double kDepthCellSteps = 2, kLeastDepthCell = 0.03, kMostDepthCell = 0.15;  // metres
// Choice: a fringe of noise and consoles; a part whose side slopes over more than this share ends too far in.
constexpr double kTailOfSides = 0.15;  // share of the rows and columns of a region that may end farther out
// Derived: the median; a part of which more than half hangs lower has another bottom.
constexpr double kMiddle = 0.5;  // share of its columns: consoles hang below what stands out
constexpr int kNeighbours = 5;   // of the eight neighbours that must agree on a gap

// A cell in which nothing was seen takes the kind of most of its neighbours: it is a gap between points. This is done
// once.
void close_gaps(DepthImage& image) {
  const std::vector<std::int8_t> before = image.what;
  for (std::int64_t r = 1; r + 1 < image.rows; ++r)
    for (std::int64_t c = 1; c + 1 < image.columns; ++c) {
      const std::int64_t i = r * image.columns + c;
      if (before[static_cast<std::size_t>(i)] != kNothing) continue;
      std::array<int, 3> votes{};
      for (std::int64_t dr = -1; dr <= 1; ++dr)
        for (std::int64_t dc = -1; dc <= 1; ++dc)
          if (const std::ptrdiff_t near = before[static_cast<std::size_t>(i + dr * image.columns + dc)];
              near != kNothing)
            ++votes[static_cast<std::size_t>(near + 1)];
      const auto most = std::max_element(votes.begin(), votes.end());
      if (*most >= kNeighbours)
        image.what[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(most - votes.begin() - 1);
    }
}

// The box ends where most rows and columns end: ground at its foot and single cells go beyond it.
void find_box(DepthRegion& region, std::int64_t columns) {
  std::int64_t c0 = INT64_MAX, c1 = -1, r0 = INT64_MAX, r1 = -1;
  for (const std::int64_t i : region.cells) {
    c0 = std::min(c0, i % columns), c1 = std::max(c1, i % columns);
    r0 = std::min(r0, i / columns), r1 = std::max(r1, i / columns);
  }
  std::vector<std::int64_t> left(static_cast<std::size_t>(r1 - r0 + 1), INT64_MAX), right(left.size(), -1);
  std::vector<std::int64_t> low(static_cast<std::size_t>(c1 - c0 + 1), INT64_MAX), high(low.size(), -1);
  for (const std::int64_t i : region.cells) {
    const auto r = static_cast<std::size_t>(i / columns - r0), c = static_cast<std::size_t>(i % columns - c0);
    left[r] = std::min(left[r], i % columns), right[r] = std::max(right[r], i % columns);
    low[c] = std::min(low[c], i / columns), high[c] = std::max(high[c], i / columns);
  }
  region.c0 = lower_quantile(left, kTailOfSides), region.c1 = lower_quantile(right, 1 - kTailOfSides);
  region.r0 = lower_quantile(low, region.what == kBefore ? kMiddle : kTailOfSides),
  region.r1 = lower_quantile(high, 1 - kTailOfSides);
}

// The points of a cell: those on the wall, and the others of the foremost sheet.
struct SheetCounts {
  std::uint32_t wall = 0, other = 0;

  std::int8_t what(double front, double least) const {
    if (other > 0 && front > least && other >= wall) return kBefore;
    if (wall > 0) return kWall;
    if (other > 0) return front < -least ? kBehind : kWall;
    return kNothing;
  }
};

void fill_rows(const RaySamples& samples, const RowBand& band, double least, double most_depth, DepthImage& image) {
  const double u1 = image.u(image.columns), v0 = image.u(band.first), v1 = image.u(band.end);
  const auto first = static_cast<std::int64_t>(band.first * image.columns);
  const auto count = static_cast<std::int64_t>((band.end - band.first) * image.columns);
  const auto cell_of = [&](const Ray& ray) {  // cell in the band; -1 outside of it
    const std::int64_t i = std::abs(static_cast<double>(ray.at.w)) <= most_depth ? image.at(ray.at) : -1;
    return i < first || i >= first + count ? -1 : i;
  };
  Rays rays = samples.at_places(Box2{-kAroundWall, u1, v0, v1}.grown(image.cell));
  for (const Ray& ray : rays)
    if (const std::int64_t i = cell_of(ray); i >= 0) {
      float& front = image.front[static_cast<std::size_t>(i)];
      front = std::max(front, ray.at.w);
    }
  std::vector<SheetCounts> counts(static_cast<std::size_t>(count));
  for (const Ray& ray : rays) {
    const std::int64_t i = cell_of(ray);
    if (i < 0) continue;
    SheetCounts& at = counts[static_cast<std::size_t>(i - first)];
    const double front = image.front[static_cast<std::size_t>(i)];
    if (samples.on_wall(ray))
      ++at.wall;
    else
      at.other += static_cast<double>(ray.at.w) > front - kForemostSheet;
  }
  for (std::size_t i = 0; i < counts.size(); ++i) {
    const std::size_t at = static_cast<std::size_t>(first) + i;
    image.what[at] = counts[i].what(image.front[at], least);
  }
}

}  // namespace

DepthImage depth_image(const RaySamples& samples, double least_depth, double most_depth) {
  const FacadeSite& site = samples.site();
  DepthImage image;
  const double width = site.width + 2 * kAroundWall, height = site.height + 2 * kAroundWall;
  image.cell = cell_for(width, height, std::clamp(kDepthCellSteps * site.step, kLeastDepthCell, kMostDepthCell));
  image.columns = static_cast<std::int64_t>(width / image.cell) + 1;
  image.rows = static_cast<std::int64_t>(height / image.cell) + 1;
  const auto count = static_cast<std::size_t>(image.columns * image.rows);
  image.front.assign(count, -INFINITY);
  image.what.assign(count, kNothing);
  const double least = std::max(least_depth, 3 * site.epsilon);
  for (const RowBand& band : bands_of(image.columns, image.rows)) fill_rows(samples, band, least, most_depth, image);
  close_gaps(image);
  return image;
}

void for_each_depth_region(const DepthImage& image, const std::function<void(const DepthRegion&)>& visit) {
  std::vector<bool> taken(image.what.size(), false);
  for (std::size_t start = 0; start < taken.size(); ++start) {
    const std::int8_t what = image.what[start];
    if (taken[start] || (what != kBehind && what != kBefore)) continue;
    DepthRegion region;
    region.what = what;
    region.cells = {static_cast<std::uint32_t>(start)};
    taken[start] = true;
    for (std::size_t i = 0; i < region.cells.size(); ++i) {
      const std::int64_t c = region.cells[i] % image.columns, r = region.cells[i] / image.columns;
      const auto take = [&](std::int64_t nc, std::int64_t nr) {
        if (nc < 0 || nr < 0 || nc >= image.columns || nr >= image.rows) return;
        const auto n = static_cast<std::size_t>(nr * image.columns + nc);
        if (taken[n] || image.what[n] != what) return;
        taken[n] = true;
        region.cells.push_back(static_cast<std::uint32_t>(n));
      };
      take(c - 1, r), take(c + 1, r), take(c, r - 1), take(c, r + 1);
    }
    find_box(region, image.columns);
    visit(region);
  }
}

double bounded_by_wall(const DepthImage& image, const DepthRegion& region, Side side) {
  const bool across = side == Side::left || side == Side::right;
  const std::int64_t from = across ? region.r0 : region.c0, to = across ? region.r1 : region.c1;
  std::int64_t found = 0;
  for (std::int64_t i = from; i <= to; ++i) {
    std::int64_t c = side == Side::left ? region.c0 - 1 : side == Side::right ? region.c1 + 1 : i;
    std::int64_t r = side == Side::bottom ? region.r0 - 1 : side == Side::top ? region.r1 + 1 : i;
    bool met = false;
    while (!met && c >= 0 && r >= 0 && c < image.columns && r < image.rows) {
      const std::int8_t what = image.what[static_cast<std::size_t>(r * image.columns + c)];
      met = what == kWall || (what == kBefore && region.what == kBehind);
      c += side == Side::left ? -1 : side == Side::right ? 1 : 0;
      r += side == Side::bottom ? -1 : side == Side::top ? 1 : 0;
    }
    found += met;
  }
  return static_cast<double>(found) / static_cast<double>(to - from + 1);
}

}  // namespace ilot
