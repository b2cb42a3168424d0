// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/component_features.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>

#include "kernels/morphology/flat_zones.h"
#include "tests/support/small_images.h"

namespace ilot {
namespace {

double at(const ComponentFeatures& f, ComponentFeature which) {
  return f[static_cast<std::size_t>(which)];
}

TEST(ComponentFeatures, TwoObjectsByHand) {
  const PixelLabels labels{4, 2, 2, {1, 1, 0, 2, 1, 1, 0, 2}};
  const Image heights{4, 2, {1000, 1010, 5, 400, 1990, 1000, 5, 600}};
  const std::vector<std::uint32_t> accumulation{1, 3, 50, 7, 3, 1, 50, 7};
  const auto got = component_features(labels, heights, accumulation, {.mode_bin = 1});
  ASSERT_EQ(got.size(), 2u);
  EXPECT_DOUBLE_EQ(at(got[0], ComponentFeature::mean_height), 1.25);
  EXPECT_NEAR(at(got[0], ComponentFeature::sd_height), std::sqrt((2 * 250.0 * 250 + 240 * 240 + 740 * 740) / 4) / 1000,
              1e-12);
  EXPECT_DOUBLE_EQ(at(got[0], ComponentFeature::max_height), 1.99);
  EXPECT_DOUBLE_EQ(at(got[0], ComponentFeature::min_height), 1.0);
  EXPECT_DOUBLE_EQ(at(got[0], ComponentFeature::mode_height), 1.0);
  EXPECT_DOUBLE_EQ(at(got[0], ComponentFeature::mode_accumulation), 1);  // two of each: the lower
  EXPECT_DOUBLE_EQ(at(got[0], ComponentFeature::area), 0.01);
  EXPECT_DOUBLE_EQ(at(got[1], ComponentFeature::sd_height), 0.1);
  EXPECT_DOUBLE_EQ(at(got[1], ComponentFeature::sd_accumulation), 0);
  EXPECT_STREQ(feature_name(ComponentFeature::area), "area");
  EXPECT_STREQ(feature_name(ComponentFeature::max_accumulation), "max accumulation");
}

// Oracle: two passes and a map for each label.
TEST(ComponentFeatures, EqualTwoPasses) {
  for (const auto& [name, image] : test::small_images()) {
    const PixelLabels labels = flat_zones(image, 3, Adjacency::eight);
    std::vector<std::uint32_t> accumulation;
    Rng rng(image.size());
    for (std::size_t i = 0; i < image.size(); ++i) accumulation.push_back(1 + static_cast<std::uint32_t>(rng.below(5)));
    const auto got = component_features(labels, image, accumulation, {.unit = 1, .pixel = 2, .mode_bin = 4});
    ASSERT_EQ(got.size(), labels.count);
    for (std::uint32_t label = 1; label <= labels.count; ++label) {
      double n = 0, sum = 0, squares = 0;
      std::map<long, int> bins;
      for (std::size_t i = 0; i < image.size(); ++i) {
        if (labels.of[i] != label) continue;
        ++n;
        sum += image.values[i];
        ++bins[static_cast<long>(std::floor(image.values[i] / 4.0))];
      }
      for (std::size_t i = 0; i < image.size(); ++i)
        if (labels.of[i] == label) squares += std::pow(image.values[i] - sum / n, 2);
      const auto mode =
          std::max_element(bins.begin(), bins.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
      const ComponentFeatures& f = got[label - 1];
      ASSERT_DOUBLE_EQ(at(f, ComponentFeature::mean_height), sum / n) << name;
      ASSERT_NEAR(at(f, ComponentFeature::sd_height), std::sqrt(squares / n), 1e-6) << name;
      ASSERT_DOUBLE_EQ(at(f, ComponentFeature::mode_height), static_cast<double>(mode->first) * 4 + 1.5) << name;
      ASSERT_DOUBLE_EQ(at(f, ComponentFeature::area), 4 * n) << name;
    }
  }
}

TEST(ComponentFeatures, ALabelWithoutPixelsHasZeros) {
  const auto got = component_features({2, 1, 2, {2, 2}}, {2, 1, {5, 5}}, std::vector<std::uint32_t>{1, 1});
  EXPECT_EQ(got[0], ComponentFeatures{});
}

}  // namespace
}  // namespace ilot
