// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/tiled_filling.h"

#include <gtest/gtest.h>

#include "kernels/core/parallel.h"
#include "kernels/morphology/reconstruct.h"
#include "tests/oracles/whole_fill.h"
#include "tests/support/image_tiles.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

using test::kAdjacencies;

TileGrid grid_of(const Image& image, std::uint32_t side) {
  return {image.width, image.height, side};
}

// An image in tiles, filled, and then drained at the pixels where `marker` is lower than the filling; what the whole is
// filled and drained to.
class InTiles {
 public:
  InTiles(const Image& image, const TileGrid& grid, Adjacency adjacency)
      : image_(image), grid_(grid), adjacency_(adjacency), filling_(grid, adjacency) {
    std::vector<Image> tiles(grid.count());
    for_each_tile(grid, [&](std::size_t t) { tiles[t] = filling_.fill(t, tile_of(image_, t)); });
    filling_.join();
    filled = image;
    for_each_tile(grid, [&](std::size_t t) {
      filling_.raise(t, tiles[t]);
      test::into(filled, grid_)(t, tiles[t]);
    });
  }

  Image drained(const Image& marker) {
    Image out = filled;
    for_each_tile(grid_, [&](std::size_t t) {
      const Image mark = tile_of(marker, t);
      if (mark.values == tile_of(filled, t).values) return;
      const Image tile = reconstruct_by_erosion(mark, tile_of(image_, t), adjacency_);
      filling_.record_drained(t, tile);
      test::into(out, grid_)(t, tile);
    });
    filling_.join_drained();
    for_each_tile(grid_, [&](std::size_t t) {
      Image tile = tile_of(out, t);
      filling_.lower(t, tile_of(image_, t), tile);
      test::into(out, grid_)(t, tile);
    });
    return out;
  }

  Image filled;

 private:
  Image tile_of(const Image& image, std::size_t t) const { return test::tiles_of(image, grid_)(t); }

  const Image& image_;
  TileGrid grid_;
  Adjacency adjacency_;
  TiledFilling filling_;
};

// Lower than the filling at one pixel in twenty, there at any height down to below the image.
Image random_marker(const Image& filled, std::uint64_t seed) {
  Image marker = filled;
  Rng rng(seed, filled.size());
  for (Height& v : marker.values)
    if (v != kNoHeight && rng.below(20) == 0) v -= static_cast<Height>(rng.below(900));
  return marker;
}

void expect_as_whole(const Image& image, std::uint32_t side, Adjacency adjacency, const std::string& name) {
  InTiles tiles(image, grid_of(image, side), adjacency);
  const Image want = test::fill_holes(image, adjacency);
  ASSERT_EQ(tiles.filled.values, want.values) << name << " side " << side;
  const Image marker = random_marker(want, side);
  ASSERT_EQ(tiles.drained(marker).values, reconstruct_by_erosion(marker, image, adjacency).values)
      << name << " side " << side;
}

TEST(TiledFilling, FillsAndDrainsAsTheWholeForEveryTiling) {
  for (const auto& [name, image] : test::small_images())
    for (const Adjacency adjacency : kAdjacencies)
      for (std::uint32_t side = 1; side <= 26; ++side) expect_as_whole(image, side, adjacency, name);
}

TEST(TiledFilling, OnePixelDrainsWhatLiesTilesAway) {
  Image image = filled_image(60, 60, 9);
  for (std::uint32_t x = 5; x < 55; ++x)
    for (std::uint32_t y = 5; y < 55; ++y) image.values[y * 60 + x] = 2;
  InTiles tiles(image, grid_of(image, 8), Adjacency::eight);
  Image marker = tiles.filled;
  EXPECT_EQ(marker.values[50 * 60 + 50], 9);
  marker.values[10 * 60 + 10] = 3;
  const Image drained = tiles.drained(marker);
  EXPECT_EQ(drained.values[50 * 60 + 50], 3);
  EXPECT_EQ(drained.values, reconstruct_by_erosion(marker, image, Adjacency::eight).values);
}

// Spills that the caller keeps are those that are kept in memory.
TEST(TiledFilling, SpillsMayBeKeptElsewhere) {
  const Image image = test::random_image(90, 61, 40, 3, 7);
  const TileGrid grid = grid_of(image, 16);
  std::vector<std::vector<SpillEdge>> kept(grid.count());
  TiledFilling filling(grid, Adjacency::eight,
                       {[&](std::size_t t, std::vector<SpillEdge> spills) { kept[t] = std::move(spills); },
                        [&](std::size_t t) { return kept[t]; }});
  Image out = image;
  std::vector<Image> tiles(grid.count());
  for (std::size_t t = 0; t < grid.count(); ++t) tiles[t] = filling.fill(t, test::tiles_of(image, grid)(t));
  filling.join();
  for (std::size_t t = 0; t < grid.count(); ++t) {
    filling.raise(t, tiles[t]);
    test::into(out, grid)(t, tiles[t]);
  }
  EXPECT_EQ(out.values, test::fill_holes(image, Adjacency::eight).values);
}

TEST(TiledFilling, LargerImagesAndThreads) {
  for (const std::uint32_t bound : {2u, 30u, 100000u}) {
    const Image image = test::random_image(301, 173, bound, 9, 7);
    for (const std::uint32_t side : {16u, 64u, 100u})
      for (const int threads : {1, 3})
        with_threads(threads, [&] { expect_as_whole(image, side, Adjacency::eight, "random"); });
  }
}

}  // namespace
}  // namespace ilot
