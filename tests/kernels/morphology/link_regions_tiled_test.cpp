// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/link_regions_tiled.h"

#include <gtest/gtest.h>

#include "kernels/morphology/flat_zones.h"
#include "tests/oracles/whole_links.h"
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
  Image out = image;
  for (const auto& pixels : links_tiled(grid, params, around(image, grid), around(zones, grid)))
    for (const LinkPixel& p : pixels)
      if (out.values[p.pixel] == kNoHeight) out.values[p.pixel] = p.height;
  return out;
}

TEST(LinkRegionsTiled, TheLinksOfTheWholeForEveryTiling) {
  std::size_t drawn = 0;
  for (const auto& [name, image] : test::small_images()) {
    for (const LinkRegionsParams params : {LinkRegionsParams{0, 3}, {2, 6}, {1000, 40}}) {
      const Image want = test::link_regions(image, params);
      for (std::size_t i = 0; i < want.size(); ++i) drawn += want.values[i] != image.values[i];
      for (const std::uint32_t side : {1u, 3u, 7u, 16u, 50u})
        ASSERT_EQ(linked_in_tiles(image, side, params).values, want.values) << name << " side " << side;
    }
  }
  EXPECT_GT(drawn, 100u);
}

// Where tiles are absent, ways go around them; around two tiles that touch with their corners alone they do not go.
TEST(LinkRegionsTiled, WaysGoAroundAbsentTiles) {
  const LinkRegionsParams params{12, 9};
  for (int present = 1; present < 512; ++present) {
    std::vector<std::uint8_t> flags;
    for (int t = 0; t < 9; ++t) flags.push_back((present >> t & 1) != 0);
    const TileGrid grid = test::with_tiles({33, 33, 11}, flags);
    Image image = filled_image(33, 33, kNoHeight);
    Rng rng(static_cast<std::uint64_t>(present), 3);
    for (int i = 0; i < 60; ++i) image.values[rng.below(33 * 33)] = static_cast<Height>(rng.below(30));
    LinkWindow whole{image, {}, {}};
    for (std::uint32_t i = 0; i < image.size(); ++i) {
      const bool inside = grid.contains(i % 33, i / 33);
      if (!inside) image.values[i] = kNoHeight;
      whole.inside.push_back(inside);
    }
    const PixelLabels zones = flat_zones(image, params.step, Adjacency::eight);
    whole.heights = image;
    whole.zones = zones.of;
    whole.whole_width = 33;
    whole.straight = false;
    Image want = image, got = image, numbers = image;
    for (const RegionLink& link : links_in(whole, params))
      for (const LinkPixel& p : link.way)
        if (want.values[p.pixel] == kNoHeight) want.values[p.pixel] = p.height;
    for (std::size_t i = 0; i < image.size(); ++i) numbers.values[i] = static_cast<Height>(zones.of[i]);
    for (const auto& pixels : links_tiled(grid, params, around(image, grid), around(numbers, grid)))
      for (const LinkPixel& p : pixels)
        if (got.values[p.pixel] == kNoHeight) got.values[p.pixel] = p.height;
    ASSERT_EQ(got.values, want.values) << present;
  }
}

// Islands in a wide empty sea, so that links are long and cross several tiles.
TEST(LinkRegionsTiled, LongLinks) {
  for (std::uint64_t seed = 0; seed < 6; ++seed) {
    Image image = filled_image(70, 60, kNoHeight);
    Rng rng(seed, 7);
    for (int i = 0; i < 40; ++i) image.values[rng.below(70 * 60)] = static_cast<Height>(rng.below(30));
    const LinkRegionsParams params{12, 25};
    const Image want = test::link_regions(image, params);
    for (const std::uint32_t side : {4u, 9u, 31u})
      ASSERT_EQ(linked_in_tiles(image, side, params).values, want.values) << seed << " side " << side;
  }
}

}  // namespace
}  // namespace ilot
