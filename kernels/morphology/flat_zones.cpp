// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/flat_zones.h"

#include <algorithm>
#include <cassert>
#include <span>

#include "kernels/core/union_find.h"
#include "kernels/morphology/zone_runs.h"
#include "kernels/rasters/where.h"

namespace ilot {
namespace {

// The arithmetic is unsigned, so that no difference overflows.
bool near(Height a, Height b, Height lambda) {
  const auto ua = static_cast<std::uint32_t>(a), ub = static_cast<std::uint32_t>(b);
  return (a < b ? ub - ua : ua - ub) <= static_cast<std::uint32_t>(lambda);
}

// Finds the runs of a row. It calls put(from, to) between the pixels where a run cannot continue from the pixel before.
template <class Breaks, class Put>
void for_runs(std::uint32_t width, const Breaks& breaks, const Put& put) {
  std::uint32_t from = 0;
  const auto end_at = [&](std::uint32_t to) {
    put(from, to);
    from = to;
  };
  for_each_where(
      width - 1, [&](std::size_t i) { return breaks(i + 1); },
      [&](std::size_t i) { end_at(static_cast<std::uint32_t>(i) + 1); });
  end_at(width);
}

ZoneRuns find_runs(const Image& image, Height lambda) {
  ZoneRuns zones{image.width, image.height};
  zones.first.push_back(0);
  for (std::uint32_t y = 0; y < image.height; ++y) {
    const Height* row = image.values.data() + std::size_t{y} * image.width;
    for_runs(
        image.width,
        [&](std::size_t x) {
          const Height a = row[x - 1], b = row[x];
          const auto step = static_cast<Height>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
          const int far = (step > lambda) | (step < -lambda), missing = (a == kNoHeight) | (b == kNoHeight);
          return (far | missing) & (a != b);  // missing pixels continue a run of missing pixels
        },
        [&](std::uint32_t from, std::uint32_t to) {
          if (row[from] != kNoHeight) zones.runs.push_back({from, to});
        });
    zones.first.push_back(static_cast<std::uint32_t>(zones.runs.size()));
  }
  return zones;
}

// Whether a pixel of run a has a neighbour within lambda in run b of the row above.
bool touch(const Height* row, PixelRun a, const Height* above, PixelRun b, Height lambda, std::uint32_t reach) {
  for (std::uint32_t x = std::max(a.from, b.from - std::min(b.from, reach)); x < std::min(a.to, b.to + reach); ++x)
    for (std::uint32_t q = std::max(b.from, x - std::min(x, reach)); q < std::min(b.to, x + reach + 1); ++q)
      if (near(row[x], above[q], lambda)) return true;
  return false;
}

void join_rows(const Image& image, const ZoneRuns& runs, std::uint32_t y, Height lambda, std::uint32_t reach,
               UnionFind& sets) {
  const Height* row = image.values.data() + std::size_t{y} * image.width;
  const Height* above = row - image.width;
  std::uint32_t first = runs.first[y - 1];
  for (std::uint32_t a = runs.first[y]; a < runs.first[y + 1]; ++a) {
    const PixelRun run = runs.runs[a];
    while (first < runs.first[y] && runs.runs[first].to + reach <= run.from) ++first;
    for (std::uint32_t b = first; b < runs.first[y] && runs.runs[b].from < run.to + reach; ++b)
      if (!sets.same(a, b) && touch(row, run, above, runs.runs[b], lambda, reach)) sets.unite(a, b);
  }
}

// Finds the runs of the pixels that satisfy is_of.
template <class IsOf>
ZoneRuns find_kind(std::uint32_t width, std::uint32_t height, const IsOf& is_of) {
  ZoneRuns zones{width, height};
  zones.first.push_back(0);
  for (std::uint32_t y = 0; y < height; ++y) {
    const std::size_t row = std::size_t{y} * width;
    for_runs(
        width, [&](std::size_t x) { return is_of(row + x) ^ is_of(row + x - 1); },
        [&](std::uint32_t from, std::uint32_t to) {
          if (is_of(row + from) != 0) zones.runs.push_back({from, to});
        });
    zones.first.push_back(static_cast<std::uint32_t>(zones.runs.size()));
  }
  return zones;
}

// Joins runs of two rows that touch into one region.
void join_flagged(const ZoneRuns& runs, std::uint32_t y, std::uint32_t reach, UnionFind& sets) {
  std::uint32_t b = runs.first[y - 1];
  for (std::uint32_t a = runs.first[y]; a < runs.first[y + 1]; ++a) {
    const PixelRun run = runs.runs[a];
    while (b < runs.first[y] && runs.runs[b].to + reach <= run.from) ++b;
    for (std::uint32_t c = b; c < runs.first[y] && runs.runs[c].from < run.to + reach; ++c) sets.unite(a, c);
  }
}

// A root is the first run of its set. So numbers rise with first pixels, and a parent is numbered before its child.
std::uint32_t number_zones(std::span<std::uint32_t> zone) {
  std::uint32_t count = 0;
  for (std::uint32_t r = 0; r < zone.size(); ++r) zone[r] = zone[r] == r ? ++count : zone[zone[r]];
  return count;
}

// Joins the runs that touch into regions.
ZoneRuns joined(ZoneRuns zones, Adjacency adjacency) {
  zones.zone.resize(zones.runs.size());
  UnionFind sets(zones.zone);
  const std::uint32_t reach = adjacency == Adjacency::eight ? 1 : 0;
  for (std::uint32_t y = 1; y < zones.height; ++y) join_flagged(zones, y, reach, sets);
  zones.count = number_zones(zones.zone);
  return zones;
}

}  // namespace

ZoneRuns zone_runs(const Image& image, Height lambda, Adjacency adjacency) {
  assert(lambda >= 0);
  ZoneRuns zones = find_runs(image, lambda);
  zones.zone.resize(zones.runs.size());
  UnionFind sets(zones.zone);
  const std::uint32_t reach = adjacency == Adjacency::eight ? 1 : 0;
  for (std::uint32_t y = 1; y < image.height; ++y) join_rows(image, zones, y, lambda, reach, sets);
  zones.count = number_zones(zones.zone);
  return zones;
}

ZoneRuns flagged_runs(std::uint32_t width, std::uint32_t height, std::span<const std::uint8_t> flags,
                      Adjacency adjacency) {
  assert(flags.size() == std::size_t{width} * height);
  return joined(find_kind(width, height, [&](std::size_t i) { return static_cast<int>(flags[i] != 0); }), adjacency);
}

ZoneRuns missing_runs(const Image& image, Adjacency adjacency) {
  const Height* values = image.values.data();
  return joined(find_kind(image.width, image.height,
                          [values](std::size_t i) { return static_cast<int>(values[i] == kNoHeight); }),
                adjacency);
}

std::vector<std::uint8_t> zones_on_border(const ZoneRuns& zones) {
  std::vector<std::uint8_t> on_border(std::size_t{zones.count} + 1, 0);
  for_each_run(zones, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    if (y == 0 || y + 1 == zones.height || run.from == 0 || run.to == zones.width) on_border[zone] = 1;
  });
  return on_border;
}

PixelLabels painted(const ZoneRuns& zones) {
  const std::size_t width = zones.width;
  PixelLabels labels{zones.width, zones.height, zones.count, std::vector<std::uint32_t>(width * zones.height, 0)};
  for_each_run(zones, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    std::uint32_t* row = labels.of.data() + y * width;
    std::fill(row + run.from, row + run.to, zone);
  });
  return labels;
}

PixelLabels flat_zones(const Image& image, Height lambda, Adjacency adjacency) {
  return painted(zone_runs(image, lambda, adjacency));
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
