// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/depth_image.h"

#include <algorithm>
#include <array>

namespace ilot {
namespace {

constexpr double kCellSteps = 2, kLeastCell = 0.03, kMostCell = 0.15;  // metres
constexpr double kTail = 0.15;   // of a region's rows and columns that may end farther out
constexpr double kMiddle = 0.5;  // of its columns: below what stands out hang consoles
constexpr int kNeighbours = 5;   // of eight that tell what a gap is

// Cells that nothing was seen in become what most of their neighbours are, once: gaps between points.
void close_gaps(DepthImage& image) {
  const std::vector<std::int8_t> before = image.what;
  for (std::int64_t r = 1; r + 1 < image.rows; ++r)
    for (std::int64_t c = 1; c + 1 < image.columns; ++c) {
      const std::int64_t i = r * image.columns + c;
      if (before[static_cast<std::size_t>(i)] != kNothing) continue;
      std::array<int, 3> votes{};
      for (std::int64_t dr = -1; dr <= 1; ++dr)
        for (std::int64_t dc = -1; dc <= 1; ++dc)
          if (const int near = before[static_cast<std::size_t>(i + dr * image.columns + dc)]; near != kNothing)
            ++votes[static_cast<std::size_t>(near + 1)];
      const auto most = std::max_element(votes.begin(), votes.end());
      if (*most >= kNeighbours)
        image.what[static_cast<std::size_t>(i)] = static_cast<std::int8_t>(most - votes.begin() - 1);
    }
}

std::int64_t quantile(std::vector<std::int64_t>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

// Where most of its rows and columns end: ground at its foot and single cells leak out.
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
  region.c0 = quantile(left, kTail), region.c1 = quantile(right, 1 - kTail);
  region.r0 = quantile(low, region.what == kBefore ? kMiddle : kTail), region.r1 = quantile(high, 1 - kTail);
}

}  // namespace

DepthImage depth_image(const RaySamples& samples, double least_depth, double most_depth) {
  const FacadeSite& site = samples.site();
  DepthImage image;
  image.cell = std::clamp(kCellSteps * site.step, kLeastCell, kMostCell);
  image.columns = static_cast<std::int64_t>((site.width + 2 * kAroundWall) / image.cell) + 1;
  image.rows = static_cast<std::int64_t>((site.height + 2 * kAroundWall) / image.cell) + 1;
  const auto count = static_cast<std::size_t>(image.columns * image.rows);
  image.front.assign(count, -INFINITY);
  std::vector<std::uint32_t> wall(count), other(count);
  const auto depth = [&](const FacadePoint& p) { return std::abs(static_cast<double>(p.w)) <= most_depth; };
  for (const FacadePoint& p : site.points)
    if (const std::int64_t i = image.at(p); i >= 0 && depth(p))
      image.front[static_cast<std::size_t>(i)] = std::max(image.front[static_cast<std::size_t>(i)], p.w);
  for (std::uint32_t k = 0; k < site.points.size(); ++k) {
    const FacadePoint& p = site.points[k];
    const std::int64_t i = image.at(p);
    if (i < 0 || !depth(p)) continue;
    if (samples.on_wall(k))
      ++wall[static_cast<std::size_t>(i)];
    else if (static_cast<double>(p.w) > static_cast<double>(image.front[static_cast<std::size_t>(i)]) - kForemostSheet)
      ++other[static_cast<std::size_t>(i)];
  }
  const double least = std::max(least_depth, 3 * site.epsilon);
  image.what.assign(count, kNothing);
  for (std::size_t i = 0; i < count; ++i) {
    const double w = image.front[i];
    if (other[i] > 0 && w > least && other[i] >= wall[i])
      image.what[i] = kBefore;
    else if (wall[i] > 0)
      image.what[i] = kWall;
    else if (other[i] > 0 && w < -least)
      image.what[i] = kBehind;
    else if (other[i] > 0)
      image.what[i] = kWall;
  }
  close_gaps(image);
  return image;
}

std::vector<DepthRegion> depth_regions(const DepthImage& image) {
  std::vector<DepthRegion> regions;
  std::vector<std::uint8_t> taken(image.what.size());
  for (std::int64_t start = 0; start < static_cast<std::int64_t>(taken.size()); ++start) {
    const std::int8_t what = image.what[static_cast<std::size_t>(start)];
    if (taken[static_cast<std::size_t>(start)] != 0 || (what != kBehind && what != kBefore)) continue;
    DepthRegion region;
    region.what = what;
    region.cells = {start};
    taken[static_cast<std::size_t>(start)] = 1;
    for (std::size_t i = 0; i < region.cells.size(); ++i) {
      const std::int64_t c = region.cells[i] % image.columns, r = region.cells[i] / image.columns;
      const auto visit = [&](std::int64_t nc, std::int64_t nr) {
        if (nc < 0 || nr < 0 || nc >= image.columns || nr >= image.rows) return;
        const auto n = static_cast<std::size_t>(nr * image.columns + nc);
        if (taken[n] != 0 || image.what[n] != what) return;
        taken[n] = 1;
        region.cells.push_back(nr * image.columns + nc);
      };
      visit(c - 1, r), visit(c + 1, r), visit(c, r - 1), visit(c, r + 1);
    }
    find_box(region, image.columns);
    regions.push_back(std::move(region));
  }
  return regions;
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
