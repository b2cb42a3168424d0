// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/fill_missing_tiled.h"

#include <algorithm>

namespace ilot {
namespace {

Image inner(const Image& around) {
  Image out{around.width - 2, around.height - 2, {}};
  out.values.reserve(std::size_t{out.width} * out.height);
  for (std::uint32_t y = 0; y < out.height; ++y) {
    const auto row = around.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{y + 1} * around.width + 1);
    out.values.insert(out.values.end(), row, row + out.width);
  }
  return out;
}

Height or_highest(Height v) {
  return v == kNoHeight ? kAboveAll : v;
}

// Computes for each column the lowest height in the three rows.
void least_of_rows(const Height* __restrict a, const Height* __restrict b, const Height* __restrict c,
                   Height* __restrict out, std::size_t width) {
  for (std::size_t x = 0; x < width; ++x) out[x] = std::min({or_highest(a[x]), or_highest(b[x]), or_highest(c[x])});
}

// Returns for each region the lowest height around it, corners included, or kAboveAll where there is none.
std::vector<Height> levels_around(const ZoneRuns& missing, const Image& around) {
  std::vector<Height> levels(std::size_t{missing.count} + 1, kAboveAll), least(around.width);
  for (std::uint32_t y = 0; y < missing.height; ++y) {
    if (missing.first[y] == missing.first[y + 1]) continue;
    const Height* above = around.values.data() + std::size_t{y} * around.width;
    least_of_rows(above, above + around.width, above + 2 * std::size_t{around.width}, least.data(), around.width);
    for (std::uint32_t r = missing.first[y]; r < missing.first[y + 1]; ++r) {
      const PixelRun run = missing.runs[r];
      Height& level = levels[missing.zone[r]];
      for (std::size_t x = run.from; x < run.to + 2; ++x) level = std::min(level, least[x]);  // around is one wider
    }
  }
  return levels;
}

void fill_run(Image& image, std::uint32_t y, PixelRun run, Height level) {
  const auto row = image.values.begin() + static_cast<std::ptrdiff_t>(std::size_t{y} * image.width);
  std::fill(row + run.from, row + run.to, level);
}

}  // namespace

TiledMissing::TiledMissing(const TileGrid& grid)
    : grid_(grid), pixels_(grid), borders_(grid), recorded_(grid.count()) {}

// Regions that are joined to the end of the image stay without a height.
void TiledMissing::open_at_ends(std::size_t tile, const ZoneRuns& missing, std::vector<Height>& levels) const {
  const TileFrame frame = tile_frame(grid_, tile);
  const auto open_at = [&](std::uint32_t zone, std::uint32_t x, std::uint32_t y) {
    if (levels[zone] != kNoHeight && grid_.ends_at(std::int64_t{frame.x} + x, std::int64_t{frame.y} + y))
      levels[zone] = kNoHeight;
  };
  for_each_run(missing, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    if (y == 0 || y + 1 == missing.height)
      for (std::uint32_t x = run.from; x < run.to; ++x) open_at(zone, x, y);
    if (run.from == 0) open_at(zone, 0, y);
    if (run.to == missing.width) open_at(zone, missing.width - 1, y);
  });
}

Image TiledMissing::fill(std::size_t tile, const Image& around) {
  Image image = inner(around);
  const ZoneRuns missing = missing_runs(image, Adjacency::eight);
  std::vector<Height> levels = levels_around(missing, around);
  open_at_ends(tile, missing, levels);
  const std::vector<std::uint32_t> on_border = borders_.record(tile, missing);
  std::vector<Height>& recorded = recorded_[tile];
  for (std::size_t z = 1; z < on_border.size(); ++z)
    if (on_border[z] != 0) recorded.push_back(levels[z]);
  for_each_run(missing, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    if (on_border[zone] == 0) fill_run(image, y, run, levels[zone]);
  });
  return image;
}

void TiledMissing::join() {
  borders_.join(0, Adjacency::eight);
  levels_.assign(borders_.count(), kAboveAll);
  for (std::size_t t = 0; t < recorded_.size(); ++t)
    for (std::uint32_t z = 1; z <= recorded_[t].size(); ++z) {
      Height& level = levels_[borders_.number(t, z)];
      level = std::min(level, recorded_[t][z - 1]);
    }
}

// The regions that are left are those on the border, in the order in which they were recorded.
bool TiledMissing::finish(std::size_t tile, Image& image) const {
  bool any = false;
  for (std::uint32_t z = 1; z <= recorded_[tile].size(); ++z) any |= levels_[borders_.number(tile, z)] != kNoHeight;
  if (!any) return false;
  const ZoneRuns missing = missing_runs(image, Adjacency::eight);
  assert(missing.count == recorded_[tile].size());
  for_each_run(missing, [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
    fill_run(image, y, run, levels_[borders_.number(tile, zone)]);
  });
  return true;
}

}  // namespace ilot
