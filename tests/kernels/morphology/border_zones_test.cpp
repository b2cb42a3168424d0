// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/border_zones.h"

#include <gtest/gtest.h>

#include <map>

#include "kernels/morphology/outward_drops.h"
#include "tests/support/flooded_zones.h"
#include "tests/support/image_tiles.h"

namespace ilot {
namespace {

using test::kAdjacencies;

// An image without what lies in tiles that are absent.
Image only_present(Image image, const TileGrid& grid) {
  for (std::size_t p = 0; p < image.size(); ++p)
    if (!grid.contains(static_cast<std::int64_t>(p % image.width), static_cast<std::int64_t>(p / image.width)))
      image.values[p] = kNoHeight;
  return image;
}

// Of every pixel, its zone's number among the joined ones plus 1; 0 = of no zone on a border.
struct JoinedZones {
  std::vector<std::uint32_t> of;
  std::vector<std::int32_t> drops;
  std::uint32_t count = 0;
};

JoinedZones joined_zones(const Image& image, const TileGrid& grid, Height lambda, Adjacency adjacency) {
  BorderZones borders(grid);
  std::vector<ZoneRuns> runs(grid.count());
  std::vector<std::vector<std::uint32_t>> on_border(grid.count());
  for (std::size_t t = grid.count(); t-- > 0;) {  // the order in which tiles are told must not show
    const Image tile = test::tiles_of(image, grid)(t);
    runs[t] = zone_runs(tile, lambda, adjacency);
    on_border[t] = borders.record(t, runs[t], tile);
  }
  borders.join(lambda, adjacency);
  JoinedZones out{std::vector<std::uint32_t>(image.size(), 0), {}, borders.count()};
  for (std::uint32_t n = 0; n < out.count; ++n) out.drops.push_back(borders.drops(n));
  for (std::size_t t = 0; t < grid.count(); ++t) {
    const TileFrame frame = tile_frame(grid, t);
    for_each_run(runs[t], [&](std::uint32_t zone, std::uint32_t y, PixelRun run) {
      if (on_border[t][zone] == 0) return;
      for (std::uint32_t x = run.from; x < run.to; ++x)
        out.of[std::size_t{frame.y + y} * image.width + frame.x + x] = borders.number(t, on_border[t][zone]) + 1;
    });
  }
  return out;
}

std::size_t tile_at(const TileGrid& grid, std::size_t pixel) {
  return grid.tile_with(static_cast<std::int64_t>(pixel % grid.width), static_cast<std::int64_t>(pixel / grid.width));
}

// One number for one zone of the whole, for each that has a pixel on the border of a tile.
void expect_joined(const Image& image, const TileGrid& grid, Height lambda, Adjacency adjacency,
                   const std::string& name) {
  const PixelLabels whole = test::flooded_zones(image, lambda, adjacency);
  const JoinedZones got = joined_zones(image, grid, lambda, adjacency);
  std::map<std::uint32_t, std::uint32_t> number_of, zone_of;
  std::vector<std::int32_t> drops(got.count, 0);
  for (std::size_t p = 0; p < image.size(); ++p) {
    if (tile_at(grid, p) == kNoTile) continue;
    const TileFrame frame = tile_frame(grid, tile_at(grid, p));
    const auto x = static_cast<std::uint32_t>(p % grid.width), y = static_cast<std::uint32_t>(p / grid.width);
    const bool at_border =
        x == frame.x || y == frame.y || x + 1 == frame.x + frame.width || y + 1 == frame.y + frame.height;
    if (at_border) {
      EXPECT_EQ(got.of[p] == 0, whole.of[p] == 0) << name;
    }
    if (got.of[p] == 0) continue;
    EXPECT_EQ(number_of.try_emplace(whole.of[p], got.of[p]).first->second, got.of[p]) << name;
    EXPECT_EQ(zone_of.try_emplace(got.of[p], whole.of[p]).first->second, whole.of[p]) << name;
    for (const std::size_t q : test::neighbours_of(image.width, image.height, p, adjacency))
      if (tile_at(grid, q) != tile_at(grid, p))
        drops[got.of[p] - 1] += outward_drop(image.values[p], image.values[q], lambda);
  }
  EXPECT_EQ(zone_of.size(), got.count) << name;
  EXPECT_EQ(got.drops, drops) << name;
}

TEST(BorderZones, TwoTilesByHand) {
  // Tiles of 2 x 2. Of height 1: one zone over the border. The 7 is alone in its tile and falls to the 1 beside it.
  const Image image{4,
                    2,
                    {1, 1, 1, 5,  //
                     9, 7, 1, 5}};
  TileGrid grid{4, 2, 2};
  const JoinedZones got = joined_zones(image, grid, 1, Adjacency::four);
  EXPECT_EQ(got.of, (std::vector<std::uint32_t>{1, 1, 1, 4, 2, 3, 1, 4}));
  EXPECT_EQ(got.drops, (std::vector<std::int32_t>{-1, 0, 1, 0}));
}

TEST(BorderZones, EqualTheFloodOfTheWhole) {
  for (const auto& [name, image] : test::small_images())
    for (const Adjacency adjacency : kAdjacencies)
      for (const std::uint32_t side : {1, 3, 8, 64})
        for (const Height lambda : {0, 3})
          expect_joined(image, {image.width, image.height, side}, lambda, adjacency,
                        name + " side " + std::to_string(side));
}

TEST(BorderZones, AbsentTilesAreNoPartOfTheImage) {
  for (std::uint64_t seed = 0; seed < 6; ++seed)
    for (const Adjacency adjacency : kAdjacencies) {
      Rng rng(seed, 9);
      std::vector<std::uint8_t> present(30);
      for (std::uint8_t& p : present) p = rng.below(3) != 0;
      const TileGrid grid = test::with_tiles({23, 17, 4}, present);
      expect_joined(only_present(test::random_image(23, 17, 3, seed, 7), grid), grid, 0, adjacency,
                    "seed " + std::to_string(seed));
    }
}

}  // namespace
}  // namespace ilot
