// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/link_regions_tiled.h"

#include <gtest/gtest.h>

#include "kernels/rasters/flat_zones.h"
#include "tests/support/image_tiles.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

ReadAround around(const Image& image, const TileGrid& grid) {
  return [&image, grid](std::size_t tile, std::uint32_t halo) {
    const TileFrame f = tile_frame(grid, tile);
    Image out = filled_image(f.width + 2 * halo, f.height + 2 * halo, kNoHeight);
    for (std::uint32_t y = 0; y < out.height; ++y)
      for (std::uint32_t x = 0; x < out.width; ++x) {
        const std::int64_t u = std::int64_t{f.x} + x - halo, v = std::int64_t{f.y} + y - halo;
        if (u >= 0 && v >= 0 && u < image.width && v < image.height)
          out.values[std::size_t{y} * out.width + x] = image.values[static_cast<std::size_t>(v * image.width + u)];
      }
    return out;
  };
}

Image linked_in_tiles(const Image& image, std::uint32_t side, const LinkRegionsParams& params) {
  const TileGrid grid{image.width, image.height, side};
  const PixelLabels labels = flat_zones(image, params.step, Adjacency::eight);
  Image zones{image.width, image.height, {}};
  for (const std::uint32_t label : labels.of) zones.values.push_back(static_cast<Height>(label));
  Image out = filled_image(image.width, image.height, 0);
  link_regions_tiled(grid, params, test::tiles_of(image, grid), around(image, grid), around(zones, grid),
                     test::into(out, grid));
  return out;
}

TEST(LinkRegionsTiled, TheLinksOfTheWholeForEveryTiling) {
  std::size_t drawn = 0;
  for (const auto& [name, image] : test::small_images()) {
    for (const LinkRegionsParams params : {LinkRegionsParams{0, 3}, {2, 6}, {1000, 40}}) {
      const Image want = link_regions(image, params);
      for (std::size_t i = 0; i < want.size(); ++i) drawn += want.values[i] != image.values[i];
      for (const std::uint32_t side : {1u, 3u, 7u, 16u, 50u})
        ASSERT_EQ(linked_in_tiles(image, side, params).values, want.values) << name << " side " << side;
    }
  }
  EXPECT_GT(drawn, 100u);
}

// Islands in a wide empty sea, so that links are long and cross several tiles.
TEST(LinkRegionsTiled, LongLinks) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Image image = filled_image(70, 60, kNoHeight);
    Rng rng(seed, 7);
    for (int i = 0; i < 40; ++i) image.values[rng.below(70 * 60)] = static_cast<Height>(rng.below(30));
    const LinkRegionsParams params{12, 25};
    const Image want = link_regions(image, params);
    for (const std::uint32_t side : {4u, 9u, 31u})
      ASSERT_EQ(linked_in_tiles(image, side, params).values, want.values) << seed << " side " << side;
  }
}

}  // namespace
}  // namespace ilot
