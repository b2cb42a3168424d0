// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/material.h"

#include <gtest/gtest.h>

#include <cmath>
#include <string>

namespace ilot::scan {
namespace {

double brightness(Rgb16 c) {
  return (c[0] + c[1] + c[2]) / 3.0;
}

TEST(Material, EveryMaterialGivesBackSomeLight) {
  ASSERT_EQ(kMaterials, static_cast<std::size_t>(Material::dusty_glass) + 1);
  for (int m = 0; m < static_cast<int>(kMaterials); ++m) {
    EXPECT_FALSE(std::string(name_of(static_cast<Material>(m))).empty());
    EXPECT_GT(reflectance(static_cast<Material>(m)), 0) << m;
    EXPECT_LE(reflectance(static_cast<Material>(m)), 1) << m;
    EXPECT_GT(brightness(colour(static_cast<Material>(m), {1, 2, 3})), 0) << m;
  }
}

TEST(Material, TextureVariesFromPlaceToPlaceWithoutJumps) {
  double low = 1e9, high = 0, jump = 0, last = brightness(colour(Material::limestone, {0, 0, 0}));
  for (int i = 1; i < 40000; ++i) {  // 4 m by tenths of a millimetre
    const double now = brightness(colour(Material::limestone, {1e-4 * i, 0, 0}));
    low = std::min(low, now);
    high = std::max(high, now);
    jump = std::max(jump, std::abs(now - last));
    last = now;
  }
  EXPECT_GT(high, 1.1 * low);
  EXPECT_LT(jump, 0.01 * high);
}

TEST(Material, BricksHaveMortarBetweenThem) {
  const auto red = [](double z) {
    const Rgb16 c = colour(Material::brick, {0.3, 0, z});
    return static_cast<double>(c[0]) / c[2];
  };
  EXPECT_GT(red(0.04), 1.5);   // within the first course
  EXPECT_LT(red(0.006), 1.5);  // its bed joint
}

}  // namespace
}  // namespace ilot::scan
