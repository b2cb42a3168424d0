// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/colour_classes.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

struct Painted {
  std::vector<std::uint8_t> r, g, b;
  std::vector<std::uint16_t> intensity;
  PointColours view() const { return {r, g, b, intensity}; }
  void add(int x, int y, int z, std::uint16_t i = 0) {
    r.push_back(static_cast<std::uint8_t>(x));
    g.push_back(static_cast<std::uint8_t>(y));
    b.push_back(static_cast<std::uint8_t>(z));
    intensity.push_back(i);
  }
};

Painted six_materials(int each, std::uint64_t key) {
  constexpr int kColours[6][3]{{200, 190, 170}, {90, 60, 40}, {40, 90, 40}, {60, 70, 120}, {180, 60, 50}, {30, 30, 35}};
  Painted p;
  Rng rng(key);
  for (int i = 0; i < each; ++i)
    for (const auto& c : kColours) {
      const auto shade = [&](int v) { return v + static_cast<int>(rng.below(21)) - 10; };
      p.add(shade(c[0]), shade(c[1]), shade(c[2]), static_cast<std::uint16_t>(rng.below(65536)));
    }
  return p;
}

TEST(ColourClasses, LabOfKnownColours) {
  EXPECT_EQ(lab_of(0, 0, 0), (Lab{0, 0, 0}));
  const Lab white = lab_of(255, 255, 255);
  EXPECT_NEAR(white[0], 10000, 1);
  EXPECT_NEAR(white[1], 0, 2);
  EXPECT_NEAR(white[2], 0, 2);
  // Red: 53.24, 80.09, 67.20; blue: 32.30, 79.19, -107.86 (CIE, D65).
  const Lab red = lab_of(255, 0, 0), blue = lab_of(0, 0, 255);
  EXPECT_NEAR(red[0], 5324, 2);
  EXPECT_NEAR(red[1], 8009, 3);
  EXPECT_NEAR(red[2], 6720, 3);
  EXPECT_NEAR(blue[0], 3230, 2);
  EXPECT_NEAR(blue[1], 7919, 3);
  EXPECT_NEAR(blue[2], -10786, 3);
}

TEST(ColourClasses, LabIsTheFormulaOfTheMathsLibrary) {
  const auto linear = [](double v) { return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4); };
  const auto f = [](double t) { return t > 216.0 / 24389 ? std::cbrt(t) : (24389.0 / 27 * t + 16) / 116; };
  Rng rng(1);
  for (int i = 0; i < 20000; ++i) {
    const auto r = static_cast<std::uint8_t>(rng.below(256)), g = static_cast<std::uint8_t>(rng.below(256)),
               b = static_cast<std::uint8_t>(rng.below(256));
    const double x = linear(r / 255.0), y = linear(g / 255.0), z = linear(b / 255.0);
    const double fx = f((0.4124564 * x + 0.3575761 * y + 0.1804375 * z) / 0.95047);
    const double fy = f(0.2126729 * x + 0.7151522 * y + 0.0721750 * z);
    const double fz = f((0.0193339 * x + 0.1191920 * y + 0.9503041 * z) / 1.08883);
    const Lab lab = lab_of(r, g, b);
    EXPECT_NEAR(lab[0], 100 * (116 * fy - 16), 1.5);
    EXPECT_NEAR(lab[1], 100 * 500 * (fx - fy), 1.5);
    EXPECT_NEAR(lab[2], 100 * 200 * (fy - fz), 1.5);
  }
}

TEST(ColourClasses, SixMaterialsAreSixClasses) {
  for (const std::uint64_t key : {1, 2, 3}) {
    const Painted p = six_materials(300, key);
    for (const ColourSpace space : {ColourSpace::kLab, ColourSpace::kRgb}) {
      const ColourClasses c = colour_classes(p.view(), {6, space, 4, 50, key});
      ASSERT_EQ(c.centre.size(), 6u);
      for (std::size_t i = 6; i < c.label.size(); ++i) ASSERT_EQ(c.label[i], c.label[i - 6]) << i;
      EXPECT_LT(c.intra / c.total(), 0.05);
    }
    EXPECT_EQ(colour_classes(p.view(), {6, ColourSpace::kLabIntensity, 4, 50, key}).label.size(), p.r.size());
  }
}

// Huygens: the inertia about the mean is that within classes plus that between them.
TEST(ColourClasses, InertiasAddUp) {
  const Painted p = six_materials(100, 4);
  const ColourClasses c = colour_classes(p.view(), {3, ColourSpace::kRgb, 2, 50, 1});
  double mean[3]{}, total = 0;
  const auto n = static_cast<double>(p.r.size());
  for (std::size_t i = 0; i < p.r.size(); ++i) {
    mean[0] += p.r[i] / n;
    mean[1] += p.g[i] / n;
    mean[2] += p.b[i] / n;
  }
  for (std::size_t i = 0; i < p.r.size(); ++i)
    total += std::pow(p.r[i] - mean[0], 2) + std::pow(p.g[i] - mean[1], 2) + std::pow(p.b[i] - mean[2], 2);
  EXPECT_NEAR(c.total(), total, 1e-9 * total);
  // Lloyd's fixed point: each point is in the class of its nearest centre.
  for (std::size_t i = 0; i < p.r.size(); ++i) {
    const auto d = [&](std::size_t j) {
      return std::pow(p.r[i] - c.centre[j][0], 2) + std::pow(p.g[i] - c.centre[j][1], 2) +
             std::pow(p.b[i] - c.centre[j][2], 2);
    };
    for (std::size_t j = 0; j < 3; ++j) EXPECT_LE(d(c.label[i] - 1), d(j) + 1e-6);
  }
}

TEST(ColourClasses, OrderOfPointsDoesNotMatter) {
  const Painted p = six_materials(200, 5);
  Painted back;
  for (std::size_t i = p.r.size(); i-- > 0;) back.add(p.r[i], p.g[i], p.b[i], p.intensity[i]);
  for (const ColourSpace space : {ColourSpace::kLab, ColourSpace::kRgb, ColourSpace::kLabIntensity}) {
    const auto a = colour_classes(p.view(), {6, space}), b = colour_classes(back.view(), {6, space});
    EXPECT_EQ(a.intra, b.intra);
    for (std::size_t i = 0; i < p.r.size(); ++i) ASSERT_EQ(a.label[i], b.label[p.r.size() - 1 - i]);
  }
}

TEST(ColourClasses, FewColoursOrNone) {
  EXPECT_TRUE(colour_classes({}).label.empty());
  Painted p;
  for (int i = 0; i < 10; ++i) p.add(i % 2 * 200, 10, 10);
  const auto c = colour_classes(p.view());
  EXPECT_EQ(c.centre.size(), 2u);
  EXPECT_EQ(c.intra, 0);
  EXPECT_EQ(c.size, (std::vector<std::uint64_t>{5, 5}));
}

}  // namespace
}  // namespace ilot
