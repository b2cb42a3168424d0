// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/kerbs/kerb_lines.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// Places on the edge y = 0.1 x, the upper surface north of it, where `keep` holds.
template <class Keep>
std::vector<StepPoint> step_places(double noise, const Keep& keep) {
  Rng rng(5);
  const double n = std::hypot(1, 0.1);
  std::vector<StepPoint> places;
  for (double x = 0; x < 30; x += 0.2)
    if (keep(x)) {
      const double off = noise * (rng.uniform() - 0.5);
      places.push_back({x, 0.1 * x + off, 0.02 * x, -0.1 / n, 1 / n, 0.1 + noise * (rng.uniform() - 0.5)});
    }
  return places;
}

KerbLineParams kerb_params() {
  KerbLineParams p;
  p.spacing = 0.2;
  return p;
}

double kerb_length(const KerbLine& line) {
  double length = 0;
  for (std::size_t i = 1; i < line.vertices.size(); ++i)
    length += std::hypot(line.vertices[i].x - line.vertices[i - 1].x, line.vertices[i].y - line.vertices[i - 1].y);
  return length;
}

TEST(KerbLines, OneStraightKerbIsOneLineWithTheUpperSideOnItsLeft) {
  const std::vector<KerbLine> lines = link_kerbs(step_places(0.04, [](double) { return true; }), kerb_params());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_TRUE(lines[0].seen);
  EXPECT_NEAR(kerb_length(lines[0]), 29.8 * std::hypot(1, 0.1), 0.3);
  EXPECT_GT(lines[0].vertices.back().x, lines[0].vertices.front().x);
  for (const KerbVertex& v : lines[0].vertices) {
    EXPECT_NEAR(v.y, 0.1 * v.x, 0.02);
    EXPECT_NEAR(v.height, 0.1, 0.02);
    EXPECT_NEAR(v.z, 0.02 * v.x, 0.01);
  }
}

TEST(KerbLines, TheGapOfACarIsBridgedAndToldApart) {
  const std::vector<KerbLine> lines =
      link_kerbs(step_places(0.02, [](double x) { return x < 10 || x > 15; }), kerb_params());
  ASSERT_EQ(lines.size(), 3u);
  EXPECT_TRUE(lines[0].seen && lines[1].seen);
  EXPECT_FALSE(lines[2].seen);
  EXPECT_NEAR(kerb_length(lines[2]), 5.2, 0.3);
  const std::vector<KerbLine> wide =
      link_kerbs(step_places(0.02, [](double x) { return x < 7 || x > 22; }), kerb_params());
  EXPECT_EQ(wide.size(), 2u);
}

// Places whose steps differ by 8 cm are not linked, but the lines of both continue each other.
TEST(KerbLines, AKerbThatDropsIsOneLine) {
  std::vector<StepPoint> places = step_places(0, [](double) { return true; });
  for (StepPoint& p : places)
    if (p.x > 10) p.height += 0.08;
  const std::vector<KerbLine> lines = link_kerbs(places, kerb_params());
  ASSERT_EQ(lines.size(), 1u);
  EXPECT_NEAR(kerb_length(lines[0]), 29.8 * std::hypot(1, 0.1), 0.3);
  EXPECT_NEAR(lines[0].vertices.front().height, 0.1, 1e-6);
  EXPECT_NEAR(lines[0].vertices.back().height, 0.18, 1e-6);
}

TEST(KerbLines, ShortStepsAndSinglePlacesAreNone) {
  EXPECT_TRUE(link_kerbs(step_places(0, [](double x) { return x < 1.5; }), kerb_params()).empty());
  EXPECT_TRUE(link_kerbs(step_places(0, [](double x) { return std::fmod(x, 2) < 0.15; }), kerb_params()).empty());
  EXPECT_TRUE(link_kerbs({}, kerb_params()).empty());
}

TEST(KerbLines, TheOrderOfThePlacesDoesNotMatter) {
  std::vector<StepPoint> places = step_places(0.02, [](double x) { return x < 10 || x > 15; });
  const std::vector<KerbLine> lines = link_kerbs(places, kerb_params());
  std::reverse(places.begin(), places.end());
  const std::vector<KerbLine> again = link_kerbs(places, kerb_params());
  ASSERT_EQ(lines.size(), again.size());
  double all = 0, all_again = 0;
  for (const KerbLine& line : lines) all += kerb_length(line);
  for (const KerbLine& line : again) all_again += kerb_length(line);
  EXPECT_DOUBLE_EQ(all, all_again);
}

}  // namespace
}  // namespace ilot
