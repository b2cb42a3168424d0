// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/flat_zones.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "kernels/core/union_find.h"

namespace ilot {
namespace {

// Unsigned, so that no difference overflows.
bool near(Height a, Height b, Height lambda) {
  const auto ua = static_cast<std::uint32_t>(a), ub = static_cast<std::uint32_t>(b);
  return (a < b ? ub - ua : ua - ub) <= static_cast<std::uint32_t>(lambda);
}

// Gives every pixel the number of its run from 1, 0 where there is no height. Returns the number of runs.
std::uint32_t number_runs(const Image& image, Height lambda, std::span<std::uint32_t> run_of) {
  std::uint32_t runs = 0;
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const Height* row = image.values.data() + std::size_t{y} * image.width;
    std::uint32_t* out = run_of.data() + std::size_t{y} * image.width;
    Height last = kNoHeight;
    for (std::uint32_t x = 0; x < image.width; ++x) {
      const bool present = row[x] != kNoHeight;
      runs += present && (last == kNoHeight || !near(row[x], last, lambda));
      out[x] = present ? runs : 0;
      last = row[x];
    }
  }
  return runs;
}

// Joins the runs of two rows along the pairs (x, x + shift); a pair of runs met twice in a row is asked once.
void join_rows(const Image& image, std::uint32_t y, int shift, Height lambda, std::span<const std::uint32_t> run_of,
               UnionFind& sets) {
  const std::size_t upper = std::size_t{y - 1} * image.width, lower = upper + image.width;
  const std::uint32_t from = shift < 0 ? 1 : 0, to = image.width - (shift > 0 ? 1 : 0);
  std::uint32_t last_a = 0, last_b = 0;
  for (std::uint32_t x = from; x < to; ++x) {
    const std::size_t p = lower + x, q = upper + x + static_cast<std::size_t>(static_cast<std::ptrdiff_t>(shift));
    const std::uint32_t a = run_of[p], b = run_of[q];
    if ((a == last_a && b == last_b) || a == 0 || b == 0 || !near(image.values[p], image.values[q], lambda)) continue;
    sets.unite(a, b);
    last_a = a;
    last_b = b;
  }
}

}  // namespace

PixelLabels flat_zones(const Image& image, Height lambda, Adjacency adjacency) {
  assert(lambda >= 0);
  PixelLabels labels{image.width, image.height, 0, std::vector<std::uint32_t>(image.size())};
  const std::uint32_t runs = number_runs(image, lambda, labels.of);
  std::vector<std::uint32_t> zone(std::size_t{runs} + 1);
  UnionFind sets(zone);
  for (std::uint32_t y = 1; y < image.height; ++y) {
    join_rows(image, y, 0, lambda, labels.of, sets);
    if (adjacency == Adjacency::four) continue;
    join_rows(image, y, -1, lambda, labels.of, sets);
    join_rows(image, y, 1, lambda, labels.of, sets);
  }
  // A root is the first run of its set, so numbers rise with first pixels, and a parent is numbered before its child.
  for (std::uint32_t r = 1; r <= runs; ++r) zone[r] = zone[r] == r ? ++labels.count : zone[zone[r]];
  for (std::uint32_t& label : labels.of) label = zone[label];
  return labels;
}

std::vector<std::uint32_t> zone_sizes(const PixelLabels& labels) {
  std::vector<std::uint32_t> sizes(std::size_t{labels.count} + 1, 0);
  for (const std::uint32_t label : labels.of) ++sizes[label];
  return sizes;
}

std::uint32_t largest_zone(const PixelLabels& labels) {
  if (labels.count == 0) return 0;
  const auto sizes = zone_sizes(labels);
  return static_cast<std::uint32_t>(std::max_element(sizes.begin() + 1, sizes.end()) - sizes.begin());
}

}  // namespace ilot
