// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/region_links.h"

#include <gtest/gtest.h>

#include <map>

#include "kernels/core/union_find.h"
#include "kernels/morphology/flat_zones.h"
#include "tests/oracles/whole_links.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

constexpr Height kNo = kNoHeight;

TEST(LinkRegions, TwoIslandsByHand) {
  const Image image{6,
                    3,
                    {10, kNo, kNo, kNo, kNo, 16,  //
                     10, 10, kNo, kNo, 14, 16,    //
                     10, kNo, kNo, kNo, kNo, kNo}};
  EXPECT_EQ(test::link_regions(image, {.step = 4}).values, (std::vector<Height>{10, kNo, kNo, kNo, kNo, 16,  //
                                                                                10, 10, 11, 12, 14, 16,      //
                                                                                10, kNo, kNo, kNo, kNo, kNo}));
  EXPECT_EQ(test::link_regions(image, {.step = 4, .max_length = 1}).values, image.values);
  EXPECT_EQ(test::link_regions(image, {.step = 3}).values, image.values);  // 10 and 14 are not neighbours in height
}

// Oracle: finds the distance of each region from each other over pixels without a height, with one flood per region,
// and the regions that chains of sufficiently short links join.
std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> gaps(const Image& image, const PixelLabels& zones) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> list;
  for (std::uint32_t zone = 1; zone <= zones.count; ++zone) {
    std::vector<std::uint32_t> distance(image.size(), 0xffffffffu);
    std::vector<std::size_t> open;
    for (std::size_t i = 0; i < image.size(); ++i)
      if (zones.of[i] == zone) {
        distance[i] = 0;
        open.push_back(i);
      }
    for (std::size_t i = 0; i < open.size(); ++i)
      for (const std::size_t q : test::neighbours_of(image.width, image.height, open[i], Adjacency::four)) {
        if (zones.of[q] == zone || distance[q] != 0xffffffffu) continue;
        if (zones.of[q] != 0) {
          auto& gap = list.try_emplace({zone, zones.of[q]}, 0xffffffffu).first->second;
          gap = std::min(gap, distance[open[i]]);
          continue;
        }
        distance[q] = distance[open[i]] + 1;
        open.push_back(q);
      }
  }
  return list;
}

TEST(LinkRegions, JoinsAllThatCanBeAndChangesNothingElse) {
  for (const auto& [name, image] : test::small_images()) {
    if (name.starts_with("wide")) continue;
    for (const std::uint32_t max_length : {0u, 1u, 2u, 5u, 100u}) {
      constexpr Height kAny = 1 << 20;  // all heights are accepted: regions are connected components
      const PixelLabels zones = flat_zones(image, kAny, Adjacency::eight);
      std::vector<std::uint32_t> parents(zones.count + 1);
      UnionFind joined(parents);
      std::size_t want = zones.count, shortest = 0;
      const auto between = gaps(image, zones);
      for (std::uint32_t length = 0; length <= max_length; ++length)  // Kruskal
        for (const auto& [pair, gap] : between)
          if (gap == length && joined.unite(pair.first, pair.second)) {
            --want;
            shortest += length;
          }
      const Image got = test::link_regions(image, {kAny, max_length});
      EXPECT_EQ(flat_zones(got, kAny, Adjacency::eight).count, want) << name << " " << max_length;
      std::size_t added = 0;
      for (std::size_t i = 0; i < image.size(); ++i) {
        if (image.values[i] != kNoHeight) {
          ASSERT_EQ(got.values[i], image.values[i]) << name;
        } else {
          added += got.values[i] != kNoHeight;
        }
      }
      EXPECT_LE(added, shortest) << name << " " << max_length;  // it is less where links share pixels
    }
  }
}

}  // namespace
}  // namespace ilot
