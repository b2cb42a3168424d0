// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/packed_layers.h"

#include <gtest/gtest.h>
#include <malloc.h>

#include <cstdint>
#include <vector>

#include "kernels/core/rng.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

Image noise(std::uint32_t side, std::uint64_t key) {
  Rng rng(key);
  Image image = filled_image(side, side, 0);
  for (Height& v : image.values) v = static_cast<Height>(rng.below(1000));
  return image;
}

Image read_back(const PackedLayers& layers, const char* layer, std::size_t tile, std::uint32_t side) {
  Image image = filled_image(side, side, -1);
  layers.read(layer, tile, {0, 0, side, side}, {image.values.data(), side});
  return image;
}

TEST(PackedLayers, GiveBackWhatWasWrittenWithinTheBudgetAndBeyondIt) {
  constexpr std::uint32_t kSide = 64;
  for (const std::uint64_t budget : {std::uint64_t{0}, std::uint64_t{20000}, std::uint64_t{1} << 30}) {
    const TemporaryFolder folder;
    PackedLayers layers(folder.path() / "layers", budget);
    for (std::size_t t = 0; t < 5; ++t) layers.write("a", t, noise(kSide, t));
    layers.write("a", 3, noise(kSide, 99));  // written anew
    layers.write("b", 0, noise(kSide, 7));
    for (std::size_t t = 0; t < 5; ++t)
      EXPECT_EQ(read_back(layers, "a", t, kSide).values, noise(kSide, t == 3 ? 99 : t).values) << budget << ", " << t;
    layers.drop("a");
    EXPECT_EQ(read_back(layers, "b", 0, kSide).values, noise(kSide, 7).values) << budget;
  }
}

// What memory is wanted for something else, images go to their files.
TEST(PackedLayers, SpillToTheirFiles) {
  constexpr std::uint32_t kSide = 64;
  const TemporaryFolder folder;
  PackedLayers layers(folder.path() / "layers", 1 << 20);
  for (std::size_t t = 0; t < 8; ++t) layers.write(t % 2 == 0 ? "a" : "b", t, noise(kSide, t));
  const std::uint64_t held = (1 << 20) - layers.unused();
  layers.spill(layers.unused() + held / 2);
  EXPECT_EQ(layers.unused(), 0u);
  layers.spill(held);
  layers.write("a", 9, noise(kSide, 9));
  EXPECT_EQ(layers.unused(), 0u);
  for (std::size_t t = 0; t < 8; ++t)
    EXPECT_EQ(read_back(layers, t % 2 == 0 ? "a" : "b", t, kSide).values, noise(kSide, t).values) << t;
  EXPECT_EQ(read_back(layers, "a", 9, kSide).values, noise(kSide, 9).values);
}

// What goes to disk must leave the memory: an assignment of {} keeps a vector's storage.
TEST(PackedLayers, HoldNoMoreThanTheirBudget) {
  constexpr std::uint32_t kSide = 256;
  constexpr std::size_t kTiles = 64, kBytesOfAll = kTiles * kSide * kSide * sizeof(std::uint16_t);
  const TemporaryFolder folder;
  PackedLayers layers(folder.path() / "layers", 0);
  const std::size_t before = mallinfo2().uordblks;
  for (std::size_t t = 0; t < kTiles; ++t) layers.write("a", t, noise(kSide, t));
  EXPECT_LT(mallinfo2().uordblks, before + kBytesOfAll / 10);
}

}  // namespace
}  // namespace ilot
