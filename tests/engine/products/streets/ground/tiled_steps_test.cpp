// SPDX-License-Identifier: Apache-2.0
// The tiled steps of streets against those that hold the whole.
#include <gtest/gtest.h>

#include "engine/products/streets/ground/tiled_artefacts.h"
#include "engine/products/streets/ground/tiled_ground.h"
#include "engine/products/streets/objects/object_candidates.h"
#include "engine/products/streets/objects/separation.h"
#include "kernels/morphology/fill_missing_tiled.h"
#include "kernels/morphology/flat_zones.h"
#include "kernels/rasters/box_minimum.h"
#include "tests/oracles/whole_fill.h"
#include "tests/oracles/whole_street.h"
#include "tests/support/memory_layers.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

using test::MemoryLayers;
using test::put;

// A sloping street with a pavement, things on it, some that touch, one at the facade, shadows and scan lines.
Image busy_street() {
  Image range = test::sloping_street(330, 150, 4);
  put(range, {20, test::kFacade, 250, 40}, 150);
  put(range, {60, 80, 80, 36}, 900);
  put(range, {140, 85, 4, 30}, 400);
  put(range, {144, 85, 46, 30}, 1100);
  put(range, {100, 30, 14, 14}, 800);
  put(range, {200, test::kFacade, 20, 20}, 800);
  put(range, {250, 70, 6, 6}, 3500);
  put(range, {229, test::kFacade, 3, 120}, kNoHeight);
  put(range, {64, 118, 60, 9}, kNoHeight);
  for (std::uint32_t x = 0; x < 330; x += 5) put(range, {x, 0, 2, 150}, kNoHeight);
  Rng rng(4, 4);
  for (int i = 0; i < 4000; ++i) range.values[rng.below(range.size())] = kNoHeight;
  return range;
}

TEST(TileRuns, TilesRunAsTheGridSays) {
  std::vector<std::uint8_t> present(12, 1);
  present[5] = 0;
  TileGrid grid = test::with_tiles({100, 70, 32}, present);
  std::vector<std::uint64_t> asked;
  grid.run = [&](std::span<const std::uint64_t> bytes, const std::function<void(std::size_t)>& body) {
    asked.assign(bytes.begin(), bytes.end());
    for (std::size_t i = bytes.size(); i-- > 0;) body(i);
  };
  std::vector<std::size_t> seen;
  for_each_tile(grid, [&](std::size_t tile) { seen.push_back(tile); }, {10, 4});
  EXPECT_EQ(seen, (std::vector<std::size_t>{10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0}));
  EXPECT_EQ(asked, std::vector<std::uint64_t>(11, 10 * 40 * 40));
}

class TiledSteps : public testing::TestWithParam<std::uint32_t> {};

TEST_P(TiledSteps, AreThoseOfTheWhole) {
  const Image range = busy_street();
  const test::Ground ground = test::find_ground(range, {});
  const test::Artefacts artefacts = test::find_artefacts(ground, {});
  const PixelLabels apart = separate_artefacts(artefacts.height, {});
  ASSERT_GT(apart.count, 3u);

  MemoryLayers memory({range.width, range.height, GetParam()});
  memory.put("range", range);
  fill_ground_tiled(memory.layers, {});
  EXPECT_EQ(memory.whole("filled").values, ground.filled.values);
  Image inside = ground.filled;
  for (std::size_t i = 0; i < inside.size(); ++i)
    if (ground.mask[i] == 0) inside.values[i] = kNoHeight;
  memory.put("mask", {range.width, range.height, {ground.mask.begin(), ground.mask.end()}});
  memory.put("foot", box_minimum(inside, RasterScale{}.pixels(ArtefactParams{}.ring_reach)));
  find_artefacts_tiled(memory.layers, {});
  EXPECT_EQ(memory.whole("height").values, artefacts.height.values);

  const Image one = filled_image(range.width, range.height, 1);
  for (const char* layer : {"accumulation", "above", "low", "occupancy", "beside"}) memory.put(layer, one);
  const std::vector<ObjectCandidate> candidates = find_object_candidates(memory.layers, {});
  const Image found = memory.whole("candidates");
  // The same parts, however they are numbered: each label of the one is one label of the other.
  const auto parts = static_cast<std::size_t>(
      std::count_if(candidates.begin(), candidates.end(), [](const ObjectCandidate& t) { return t.parts[0] == 0; }));
  ASSERT_EQ(parts, apart.count);
  std::map<std::uint32_t, Height> partner;
  std::vector<std::uint32_t> pixels(candidates.size() + 1, 0);
  for (std::size_t i = 0; i < found.size(); ++i) {
    ++pixels[static_cast<std::size_t>(found.values[i])];
    ASSERT_EQ(partner.emplace(apart.of[i], found.values[i]).first->second, found.values[i]) << i;
  }
  EXPECT_EQ(partner.size(), apart.count + 1u);
  for (std::size_t t = 0; t < candidates.size(); ++t) {
    for (const std::uint32_t part : candidates[t].parts) pixels[t + 1] += part == 0 ? 0 : pixels[part];
    EXPECT_EQ(candidates[t].pixels, pixels[t + 1]);
    for (const std::uint32_t part : candidates[t].parts) EXPECT_LE(part, t);
  }
  EXPECT_GT(candidates.size(), parts);
}

INSTANTIATE_TEST_SUITE_P(Sides, TiledSteps, testing::Values(32u, 50u, 101u, 330u));

TEST(FillMissingTiled, TheValuesOfTheWholeForEveryTiling) {
  for (const auto& [name, image] : test::small_images()) {
    const Image want = test::fill_missing(image);
    for (const std::uint32_t side : {1u, 2u, 5u, 8u, 40u}) {
      MemoryLayers memory({image.width, image.height, side});
      memory.put("image", image);
      const TileLayers& layers = memory.layers;
      TiledMissing missing(layers.grid);
      for_each_tile(layers.grid, [&](std::size_t tile) {
        layers.write("filled", tile, missing.fill(tile, layer_around(layers, "image", tile, 1)));
      });
      missing.join();
      for_each_tile(layers.grid, [&](std::size_t tile) {
        Image filled = layer_tile(layers, "filled", tile);
        missing.finish(tile, filled);
        layers.write("filled", tile, filled);
      });
      ASSERT_EQ(memory.whole("filled").values, want.values) << name << " side " << side;
    }
  }
}

// Where a row of tiles is absent, the streets on both sides of it are as if each were alone.
TEST(TiledSteps, AbsentTilesEndTheImage) {
  const Image range = busy_street();
  constexpr std::uint32_t kSide = 165;
  const TileGrid grid = test::with_tiles({range.width, 3 * kSide, kSide}, {1, 1, 0, 0, 1, 1});
  Image both = filled_image(grid.width, grid.height, kNoHeight);
  for (std::uint32_t y = 0; y < range.height; ++y)
    for (std::uint32_t x = 0; x < range.width; ++x)
      for (const std::uint32_t up : {0u, 2 * kSide})
        both.values[std::size_t{y + up} * grid.width + x] = range.values[std::size_t{y} * range.width + x];
  MemoryLayers memory(grid);
  memory.put("range", both);
  fill_ground_tiled(memory.layers, {});
  const Image filled = memory.whole("filled");
  std::size_t known = 0;
  for (std::uint32_t y = 0; y < range.height; ++y)
    for (std::uint32_t x = 0; x < range.width; ++x) {
      const Height first = filled.values[std::size_t{y} * grid.width + x];
      ASSERT_EQ(first, filled.values[std::size_t{y + 2 * kSide} * grid.width + x]);
      known += first != kNoHeight;
    }
  EXPECT_GT(known, range.size() * 9 / 10);
}

}  // namespace
}  // namespace ilot
