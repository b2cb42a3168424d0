// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/object_candidates.h"

#include <gtest/gtest.h>

#include "tests/support/memory_layers.h"
#include "tests/support/street_images.h"

namespace ilot {
namespace {

using test::MemoryLayers;

void fill_box(Image& image, const test::PixelBox& box, Height value) {
  for (std::uint32_t y = box.y; y < box.y + box.height; ++y)
    for (std::uint32_t x = box.x; x < box.x + box.width; ++x) image.values[std::size_t{y} * image.width + x] = value;
}

std::vector<ObjectCandidate> candidates_of(const Image& height, const Image& points, std::uint32_t side,
                                           const RasterScale& scale = {}, const ObjectCandidateParams& params = {}) {
  MemoryLayers memory({height.width, height.height, side});
  memory.put("height", height);
  memory.put("range", filled_image(height.width, height.height, 1));
  for (const char* layer : {"accumulation", "above", "low"}) memory.put(layer, points);
  for (const char* layer : {"occupancy", "beside"}) memory.put(layer, filled_image(height.width, height.height, 0));
  return find_object_candidates(memory.layers, scale, params);
}

// Two posts and a link over a shadow that climbs to them: no point was seen on it.
TEST(ObjectCandidates, LinksOverShadowsJoinNothing) {
  Image height = filled_image(120, 60, kNoHeight), points = filled_image(120, 60, 0);
  for (const std::uint32_t x : {20u, 90u}) {
    fill_box(height, {x, 20, 5, 5}, 2000);
    fill_box(points, {x, 20, 5, 5}, 9);
  }
  fill_box(height, {25, 22, 65, 1}, 900);
  for (const std::uint32_t side : {32u, 120u}) {
    const std::vector<ObjectCandidate> candidates = candidates_of(height, points, side);
    ASSERT_EQ(candidates.size(), 2u) << side;
    for (const ObjectCandidate& t : candidates) {
      EXPECT_LE(t.pixels, 25u + 5u);  // with what is a quarter of a metre from its points
      EXPECT_EQ(t.points, 25u * 9u);
    }
    EXPECT_GT(candidates_of(height, filled_image(120, 60, 1), side).size(), 2u);  // seen all along, it joins them
  }
}

// Two pieces of a fence in pixels of 15 cm, three pixels apart: a surface that lacks one point.
TEST(ObjectCandidates, PiecesWithinTwoSamplingStepsAreJoined) {
  Image height = filled_image(60, 30, kNoHeight), points = filled_image(60, 30, 0);
  for (const std::uint32_t x : {10u, 17u}) {
    fill_box(height, {x, 10, 4, 2}, 1200);
    fill_box(points, {x, 10, 4, 2}, 5);
  }
  ObjectCandidateParams params;
  params.pixels_apart = 4;
  for (const std::uint32_t side : {16u, 60u}) {
    EXPECT_EQ(candidates_of(height, points, side, {0.001, 0.15}).size(), 2u) << side;
    const std::vector<ObjectCandidate> joined = candidates_of(height, points, side, {0.001, 0.15}, params);
    ASSERT_EQ(joined.size(), 3u) << side;
    EXPECT_EQ(joined[2].points, 2u * 8u * 5u);
  }
}

}  // namespace
}  // namespace ilot
