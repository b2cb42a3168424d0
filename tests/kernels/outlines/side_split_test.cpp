// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/side_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Ring = std::vector<FlatPoint>;
constexpr double kStep = 1, kSigma = 0.29;
const Ring kSquare{{1, 0}, {0, 1}};

FlatPoint turned(FlatPoint p, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  return {p.x * c - p.y * s, p.x * s + p.y * c};
}

Ring turned(Ring ring, double radians) {
  for (FlatPoint& p : ring) p = turned(p, radians);
  return ring;
}

// Vertices about every step along the corners' edges, each up to a step inside of its edge. Within `cut` of a corner
// there is none, as where an alpha shape cuts across corners.
Ring scanned(const Ring& corners, double cut, Rng& rng) {
  Ring ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const FlatPoint a = corners[i], d = corners[(i + 1) % corners.size()] - a, u = (1 / norm(d)) * d;
    for (double t = cut + kStep * rng.uniform(); t < norm(d) - cut; t += kStep * (0.5 + rng.uniform()))
      ring.push_back(a + t * u + kStep * rng.uniform() * FlatPoint{-u.y, u.x});
  }
  return ring;
}

const Ring kRectangle{{0, 0}, {24, 0}, {24, 15}, {0, 15}};
const Ring kLShape{{0, 0}, {30, 0}, {30, 12}, {14, 12}, {14, 25}, {0, 25}};
const Ring kCutCorner{{0, 0}, {30, 0}, {30, 10}, {18, 22}, {0, 22}};

std::vector<std::int32_t> axes_of(const std::vector<SideSpan>& sides) {
  std::vector<std::int32_t> axes;
  for (const SideSpan& s : sides) axes.push_back(s.axis);
  return axes;
}

// The sides with vertex numbers of the ring before it was begun `shift` vertices later.
std::vector<std::pair<std::uint32_t, std::uint32_t>> places(const std::vector<SideSpan>& sides, std::size_t shift,
                                                            std::size_t n) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const SideSpan& s : sides) result.emplace_back((s.first + shift) % n, s.count);
  std::sort(result.begin(), result.end());
  return result;
}

TEST(SideSplit, EveryVertexIsOnOneSide) {
  Rng rng(3);
  for (int n = 0; n < 200; ++n) {
    Ring ring;
    for (std::uint64_t i = 0; i < 1 + rng.below(40); ++i) ring.push_back({9 * rng.uniform(), 9 * rng.uniform()});
    const auto sides = split_sides(ring, kSquare, kSigma);
    std::vector<int> times(ring.size(), 0);
    for (const SideSpan& s : sides)
      for (std::uint32_t i = 0; i < s.count; ++i) ++times[(s.first + i) % ring.size()];
    EXPECT_EQ(std::count(times.begin(), times.end(), 1), static_cast<std::ptrdiff_t>(ring.size()));
    EXPECT_TRUE(std::is_sorted(sides.begin(), sides.end(),
                               [](const SideSpan& a, const SideSpan& b) { return a.first < b.first; }));
  }
}

TEST(SideSplit, NoisyHousesHaveTheSidesThatTheyWereMadeWith) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    EXPECT_EQ(split_sides(scanned(kRectangle, 0, rng), kSquare, kSigma).size(), 4u) << seed;
    EXPECT_EQ(split_sides(scanned(kLShape, 0, rng), kSquare, kSigma).size(), 6u) << seed;
  }
}

TEST(SideSplit, ABoundaryThatCutsAcrossCornersHasNoSideThere) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    EXPECT_EQ(split_sides(scanned(kLShape, 1.5, rng), kSquare, kSigma).size(), 6u) << seed;
  }
}

TEST(SideSplit, AnObliqueWallHasADirectionOfItsOwn) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    const auto axes = axes_of(split_sides(scanned(kCutCorner, 0, rng), kSquare, kSigma));
    EXPECT_EQ(axes.size(), 5u) << seed;
    EXPECT_EQ(std::count(axes.begin(), axes.end(), kOwnDirection), 1) << seed;
  }
}

TEST(SideSplit, AStepOfSixSigmaIsKeptAndOneOfASigmaIsNot) {
  const auto sides_with_step = [](double step) {
    Rng rng(11);
    return split_sides(scanned({{0, 0}, {20, 0}, {20, step}, {40, step}, {40, 20}, {0, 20}}, 0, rng), kSquare, kSigma)
        .size();
  };
  EXPECT_GT(sides_with_step(6 * kSigma), 4u);
  EXPECT_EQ(sides_with_step(kSigma), 4u);
}

TEST(SideSplit, TheResultDoesNotDependOnWhereTheRingBegins) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    const Ring ring = scanned(seed % 2 == 0 ? kLShape : kCutCorner, 0.5, rng);
    const auto wanted = places(split_sides(ring, kSquare, kSigma), 0, ring.size());
    for (std::size_t shift = 1; shift < ring.size(); shift += 7) {
      Ring later = ring;
      std::rotate(later.begin(), later.begin() + static_cast<std::ptrdiff_t>(shift), later.end());
      EXPECT_EQ(places(split_sides(later, kSquare, kSigma), shift, ring.size()), wanted) << seed << " " << shift;
    }
  }
}

TEST(SideSplit, TurnsWithTheRingAndItsAxes) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Rng rng(seed);
    const Ring ring = scanned(kLShape, 1, rng);
    const auto wanted = places(split_sides(ring, kSquare, kSigma), 0, ring.size());
    for (const double radians : {0.3, 1.1, 2.5})
      EXPECT_EQ(places(split_sides(turned(ring, radians), turned(kSquare, radians), kSigma), 0, ring.size()), wanted);
  }
}

TEST(SideSplit, WithoutAxesEverySideHasItsOwnDirection) {
  Rng rng(4);
  const auto sides = split_sides(scanned(kRectangle, 0, rng), {}, kSigma);
  EXPECT_EQ(sides.size(), 4u);
  for (const SideSpan& s : sides) EXPECT_EQ(s.axis, kOwnDirection);
  EXPECT_TRUE(split_sides({}, kSquare, kSigma).empty());
}

}  // namespace
}  // namespace ilot
