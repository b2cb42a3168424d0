// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/reconstruct_tiled.h"

#include <gtest/gtest.h>

#include "kernels/core/parallel.h"
#include "kernels/rasters/fill.h"
#include "kernels/rasters/reconstruct.h"
#include "tests/support/image_tiles.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

using test::kAdjacencies;

Image random_marker(const Image& mask, std::uint64_t seed) {
  Image marker = mask;
  Rng rng(seed, mask.size());
  for (Height& v : marker.values) v = rng.below(20) == 0 ? static_cast<Height>(rng.below(900)) : kAboveAll;
  return marker;
}

TileGrid grid_of(const Image& image, std::uint32_t side) {
  return {image.width, image.height, side};
}

TEST(ReconstructTiled, FillsAsTheWholeForEveryTiling) {
  for (const auto& [name, image] : test::small_images()) {
    for (const Adjacency adjacency : kAdjacencies) {
      const Image want = fill_holes(image, adjacency);
      for (std::uint32_t side = 1; side <= 26; ++side) {
        Image got = image;
        fill_holes_tiled(grid_of(image, side), adjacency, test::tiles_of(image, grid_of(image, side)),
                         test::into(got, grid_of(image, side)));
        ASSERT_EQ(got.values, want.values) << name << " side " << side;
      }
    }
  }
}

TEST(ReconstructTiled, ReconstructsAsTheWholeForEveryTiling) {
  for (const auto& [name, mask] : test::small_images()) {
    const Image marker = random_marker(mask, 2);
    for (const Adjacency adjacency : kAdjacencies) {
      const Image eroded = reconstruct_by_erosion(marker, mask, adjacency);
      Image low_marker = marker;
      for (Height& v : low_marker.values) v = v == kAboveAll ? kNoHeight : v;
      const Image dilated = reconstruct_by_dilation(low_marker, mask, adjacency);
      for (const std::uint32_t side : {1u, 2u, 3u, 5u, 8u, 13u, 40u}) {
        const TileGrid grid = grid_of(mask, side);
        Image got = mask;
        reconstruct_by_erosion_tiled(grid, adjacency, test::tiles_of(marker, grid), test::tiles_of(mask, grid),
                                     test::into(got, grid));
        ASSERT_EQ(got.values, eroded.values) << name << " side " << side;
        reconstruct_by_dilation_tiled(grid, adjacency, test::tiles_of(low_marker, grid), test::tiles_of(mask, grid),
                                      test::into(got, grid));
        ASSERT_EQ(got.values, dilated.values) << name << " side " << side;
      }
    }
  }
}

TEST(ReconstructTiled, LargerImagesAndThreads) {
  for (const std::uint32_t bound : {2u, 30u, 100000u}) {
    const Image image = test::random_image(301, 173, bound, 9, 7);
    const Image want = fill_holes(image, Adjacency::eight);
    for (const std::uint32_t side : {16u, 64u, 100u}) {
      for (const int threads : {1, 3}) {
        Image got = image;
        const TileGrid grid = grid_of(image, side);
        with_threads(threads, [&] {
          fill_holes_tiled(grid, Adjacency::eight, test::tiles_of(image, grid), test::into(got, grid));
        });
        ASSERT_EQ(got.values, want.values) << side;
      }
    }
  }
}

}  // namespace
}  // namespace ilot
