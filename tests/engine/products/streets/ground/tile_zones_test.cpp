// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/ground/tile_zones.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/flooded_zones.h"
#include "tests/support/memory_layers.h"

namespace ilot {
namespace {

constexpr Height kLambda = 2;

TileZones found_zones(const test::MemoryLayers& memory, const Image& image) {
  TileZones zones(memory.layers, "zones");
  const TileGrid& grid = memory.layers.grid;
  for (std::size_t t = 0; t < grid.count(); ++t) zones.find(t, test::tiles_of(image, grid)(t), kLambda);
  zones.join(kLambda);
  return zones;
}

// The number of every pixel's zone, from the labels of the tiles.
std::vector<std::uint32_t> numbers(const test::MemoryLayers& memory, const TileZones& zones) {
  const TileGrid& grid = memory.layers.grid;
  const Image labels = memory.whole("zones");
  std::vector<std::uint32_t> of(labels.size());
  for (std::size_t p = 0; p < of.size(); ++p)
    of[p] = zones.numbers_of(p / grid.width / grid.side * grid.columns() +
                             p % grid.width / grid.side)[static_cast<std::size_t>(labels.values[p])];
  return of;
}

TEST(TileZones, AreTheZonesOfTheWhole) {
  for (const auto& [name, image] : test::small_images()) {
    if (image.size() == 0) continue;
    const PixelLabels whole = test::flooded_zones(image, kLambda, Adjacency::eight);
    for (const std::uint32_t side : {3u, 8u, 64u}) {
      const std::string message = name + " side " + std::to_string(side);
      test::MemoryLayers memory({image.width, image.height, side});
      const TileZones zones = found_zones(memory, image);
      const std::vector<std::uint32_t> got = numbers(memory, zones);
      std::map<std::uint32_t, std::uint32_t> number_of, zone_of;
      for (std::size_t p = 0; p < image.size(); ++p) {
        EXPECT_EQ(got[p] == 0, whole.of[p] == 0) << message;
        EXPECT_EQ(number_of.try_emplace(whole.of[p], got[p]).first->second, got[p]) << message;
        EXPECT_EQ(zone_of.try_emplace(got[p], whole.of[p]).first->second, whole.of[p]) << message;
      }
    }
  }
}

TEST(TileZones, AroundATileAreTheNumbersOfTheWhole) {
  const Image image = test::random_image(26, 19, 9, 5, 6);
  test::MemoryLayers memory({26, 19, 7});
  const TileZones zones = found_zones(memory, image);
  const std::vector<std::uint32_t> whole = numbers(memory, zones);
  constexpr std::uint32_t kHalo = 3;
  for (std::size_t t = 0; t < memory.layers.grid.count(); ++t) {
    const TileFrame frame = tile_frame(memory.layers.grid, t);
    const Image around = zones.around(t, kHalo);
    ASSERT_EQ(around.width, frame.width + 2 * kHalo);
    for (std::uint32_t v = 0; v < around.height; ++v)
      for (std::uint32_t u = 0; u < around.width; ++u) {
        const std::int64_t x = std::int64_t{frame.x} + u - kHalo, y = std::int64_t{frame.y} + v - kHalo;
        const Height want = memory.layers.grid.contains(x, y)
                                ? static_cast<Height>(whole[static_cast<std::size_t>(y * 26 + x)])
                                : kNoHeight;
        ASSERT_EQ(around.values[std::size_t{v} * around.width + u], want) << t << " " << u << " " << v;
      }
  }
}

TEST(TileZones, AroundATileOfOneZoneIsEmpty) {
  test::MemoryLayers memory({20, 20, 7});
  const TileZones zones = found_zones(memory, filled_image(20, 20, 4));
  EXPECT_EQ(zones.around(4, 3).size(), 0u);
}

}  // namespace
}  // namespace ilot
