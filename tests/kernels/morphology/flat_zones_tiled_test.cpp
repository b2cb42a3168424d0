// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/flat_zones_tiled.h"

#include <gtest/gtest.h>

#include "kernels/core/parallel.h"
#include "kernels/morphology/flat_zones.h"
#include "tests/support/image_tiles.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

struct Tiled {
  std::vector<std::uint32_t> of;
  std::vector<std::uint64_t> sizes;
};

Tiled zones_in_tiles(const Image& image, std::uint32_t side, Height lambda, Adjacency adjacency) {
  const TileGrid grid{image.width, image.height, side};
  Tiled out{std::vector<std::uint32_t>(image.size()), {}};
  const auto write = [&](std::size_t tile, const PixelLabels& labels) {
    const TileFrame frame = tile_frame(grid, tile);
    for (std::uint32_t y = 0; y < frame.height; ++y)
      for (std::uint32_t x = 0; x < frame.width; ++x)
        out.of[std::size_t{frame.y + y} * image.width + frame.x + x] = labels.of[std::size_t{y} * frame.width + x];
  };
  out.sizes = flat_zones_tiled(grid, lambda, adjacency, test::tiles_of(image, grid), write).pixels;
  return out;
}

TEST(FlatZonesTiled, LabelsAndSizesOfTheWholeForEveryTiling) {
  for (const auto& [name, image] : test::small_images()) {
    for (const Adjacency adjacency : test::kAdjacencies) {
      for (const Height lambda : {0, 1, 40}) {
        const PixelLabels want = flat_zones(image, lambda, adjacency);
        const auto sizes = zone_sizes(want);
        for (const std::uint32_t side : {1u, 2u, 3u, 5u, 8u, 13u, 40u}) {
          const Tiled got = zones_in_tiles(image, side, lambda, adjacency);
          ASSERT_EQ(got.of, want.of) << name << " side " << side;
          ASSERT_EQ(got.sizes, (std::vector<std::uint64_t>(sizes.begin(), sizes.end()))) << name << " side " << side;
        }
      }
    }
  }
}

TEST(FlatZonesTiled, ThreadsDoNotShow) {
  const Image image = test::random_image(211, 97, 6, 3, 5);
  const PixelLabels want = flat_zones(image, 1, Adjacency::four);
  for (const int threads : {1, 3})
    with_threads(threads, [&] { EXPECT_EQ(zones_in_tiles(image, 16, 1, Adjacency::four).of, want.of); });
}

}  // namespace
}  // namespace ilot
