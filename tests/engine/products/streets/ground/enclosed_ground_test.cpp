// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/enclosed_ground.h"

#include <gtest/gtest.h>

#include "tests/support/flooded_zones.h"
#include "tests/support/memory_layers.h"

namespace ilot {
namespace {

// The mask that the tiles find when the zone of `at` is the ground.
Image enclosed(const Image& image, const TileGrid& grid, std::size_t at) {
  test::MemoryLayers memory(grid);
  memory.put("filled", image);
  TileZones zones(memory.layers, "zones");
  for (std::size_t t = 0; t < grid.count(); ++t)
    zones.find(t, layer_tile(memory.layers, "filled", t), 0, OutwardDrops::left_out);
  zones.join(0);
  const std::size_t tile =
      grid.tile_with(static_cast<std::int64_t>(at % grid.width), static_cast<std::int64_t>(at / grid.width));
  const auto label = static_cast<std::size_t>(memory.whole("zones").values[at]);
  const TileGroups groups{1, std::vector<std::uint32_t>(grid.count(), 1)};
  find_enclosed_ground(memory.layers, "zones", zones, {{0, zones.numbers_of(tile)[label]}, {}, {}}, groups);
  return memory.whole("mask");
}

// Oracle: all of the image but what is joined, across sides and outside of the zone, to where the image ends.
Image enclosed_in_whole(const Image& image, const TileGrid& grid, std::size_t at) {
  const PixelLabels zones = test::flooded_zones(image, 0, Adjacency::eight);
  const auto contains = [&](std::size_t p) {
    return grid.contains(static_cast<std::int64_t>(p % grid.width), static_cast<std::int64_t>(p / grid.width));
  };
  const PixelLabels parts = test::flooded(
      image.width, image.height, Adjacency::four,
      [&](std::size_t p) { return contains(p) && zones.of[p] != zones.of[at]; },
      [](std::size_t, std::size_t) { return true; });
  std::vector<std::uint8_t> open(parts.count + 1, 0);
  for (std::size_t p = 0; p < image.size(); ++p)
    if (parts.of[p] != 0 &&
        grid.ends_at(static_cast<std::int64_t>(p % grid.width), static_cast<std::int64_t>(p / grid.width)))
      open[parts.of[p]] = 1;
  Image mask = filled_image(image.width, image.height, 0);
  for (std::size_t p = 0; p < image.size(); ++p)
    mask.values[p] = contains(p) && image.values[p] != kNoHeight && open[parts.of[p]] == 0;
  return mask;
}

TEST(EnclosedGround, ALampAndAHoleByHand) {
  // Ground of height 1 with a lamp (5) and a pixel without height inside; the 8s reach the end of the image.
  const Height o = kNoHeight;
  const Image image{6, 5, {1, 1, 1, 1, 8, 8,  //
                           1, 5, 1, 1, 8, 8,  //
                           1, 1, 1, o, 1, 8,  //
                           1, 1, 1, 1, 1, 1,  //
                           1, 1, 1, 1, 1, 1}};
  const std::vector<Height> want{1, 1, 1, 1, 0, 0,  //
                                 1, 1, 1, 1, 0, 0,  //
                                 1, 1, 1, 0, 1, 0,  //
                                 1, 1, 1, 1, 1, 1,  //
                                 1, 1, 1, 1, 1, 1};
  for (const std::uint32_t side : {1u, 2u, 4u, 8u}) EXPECT_EQ(enclosed(image, {6, 5, side}, 0).values, want) << side;
}

TEST(EnclosedGround, EqualsTheFloodOfTheWhole) {
  std::size_t lamps = 0;
  for (std::uint64_t seed = 0; seed < 8; ++seed) {
    // Mostly ground, with things of two heights and holes: some of them reach the end of the image, some do not.
    Image image = test::random_image(29, 22, 3, seed, 11);
    for (Height& v : image.values) v = v == 1 ? 0 : v;
    std::size_t at = 0;
    while (image.values[at] != 0) ++at;
    for (const std::uint32_t side : {2u, 5u, 32u}) {
      const TileGrid grid{29, 22, side};
      const Image want = enclosed_in_whole(image, grid, at);
      EXPECT_EQ(enclosed(image, grid, at).values, want.values) << seed << " side " << side;
      for (std::size_t p = 0; p < image.size(); ++p) lamps += want.values[p] == 1 && image.values[p] == 2;
    }
  }
  EXPECT_GT(lamps, 100u);
}

TEST(EnclosedGround, TheImageEndsAtAbsentTiles) {
  Image image = filled_image(24, 24, 0);
  for (const std::size_t p : {5u * 24 + 5, 10u * 24 + 10, 10u * 24 + 11, 17u * 24 + 18}) image.values[p] = 7;
  std::vector<std::uint8_t> present(16, 1);
  present[10] = 0;  // columns and rows 12 to 17: two of the things stand at its border
  const TileGrid grid = test::with_tiles({24, 24, 6}, present);
  for (std::size_t p = 0; p < image.size(); ++p)
    if (!grid.contains(static_cast<std::int64_t>(p % 24), static_cast<std::int64_t>(p / 24)))
      image.values[p] = kNoHeight;
  image.values[11 * 24 + 11] = 7;
  const Image want = enclosed_in_whole(image, grid, 0);
  EXPECT_EQ(enclosed(image, grid, 0).values, want.values);
  EXPECT_EQ(want.values[5 * 24 + 5], 1);
  EXPECT_EQ(want.values[10 * 24 + 10], 0);
}

}  // namespace
}  // namespace ilot
