// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/side_split.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Vertices = std::vector<FlatPoint>;
constexpr double kApart = 1, kBeside = 0.29;
const Vertices kRightAngles{{1, 0}, {0, 1}};

FlatPoint rotated(FlatPoint p, double radians) {
  const double c = std::cos(radians), s = std::sin(radians);
  return {p.x * c - p.y * s, p.x * s + p.y * c};
}

Vertices rotated(Vertices ring, double radians) {
  for (FlatPoint& p : ring) p = rotated(p, radians);
  return ring;
}

// Vertices about every step along the corners' edges, each up to a step inside of its edge. Within `cut` of a corner
// there is none, as where an alpha shape cuts across corners.
Vertices sampled(const Vertices& corners, double cut, Rng& rng) {
  Vertices ring;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const FlatPoint a = corners[i], d = corners[(i + 1) % corners.size()] - a, u = (1 / norm(d)) * d;
    for (double t = cut + kApart * rng.uniform(); t < norm(d) - cut; t += kApart * (0.5 + rng.uniform()))
      ring.push_back(a + t * u + kApart * rng.uniform() * FlatPoint{-u.y, u.x});
  }
  return ring;
}

const Vertices kBlock{{0, 0}, {24, 0}, {24, 15}, {0, 15}};
const Vertices kAngled{{0, 0}, {30, 0}, {30, 12}, {14, 12}, {14, 25}, {0, 25}};
const Vertices kBevelled{{0, 0}, {30, 0}, {30, 10}, {18, 22}, {0, 22}};

std::vector<std::int32_t> choices_of(const std::vector<SideSpan>& sides) {
  std::vector<std::int32_t> axes;
  for (const SideSpan& s : sides) axes.push_back(s.axis);
  return axes;
}

// The sides with vertex numbers of the ring before it was begun `shift` vertices later.
std::vector<std::pair<std::uint32_t, std::uint32_t>> sorted_places(const std::vector<SideSpan>& sides,
                                                                   std::size_t shift, std::size_t n) {
  std::vector<std::pair<std::uint32_t, std::uint32_t>> result;
  for (const SideSpan& s : sides) result.emplace_back((s.first + shift) % n, s.count);
  std::sort(result.begin(), result.end());
  return result;
}

TEST(SideSplit, EveryVertexIsOnOneSide) {
  Rng rng(3);
  for (int n = 0; n < 200; ++n) {
    Vertices ring;
    for (std::uint64_t i = 0; i < 1 + rng.below(40); ++i) ring.push_back({9 * rng.uniform(), 9 * rng.uniform()});
    const auto sides = split_sides(ring, kRightAngles, kBeside);
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
    EXPECT_EQ(split_sides(sampled(kBlock, 0, rng), kRightAngles, kBeside).size(), 4u) << seed;
    EXPECT_EQ(split_sides(sampled(kAngled, 0, rng), kRightAngles, kBeside).size(), 6u) << seed;
  }
}

TEST(SideSplit, ABoundaryThatCutsAcrossCornersHasNoSideThere) {
  for (std::uint64_t seed = 0; seed < 40; ++seed) {
    Rng rng(seed);
    EXPECT_EQ(split_sides(sampled(kAngled, 1.5, rng), kRightAngles, kBeside).size(), 6u) << seed;
  }
}

TEST(SideSplit, AnObliqueWallHasADirectionOfItsOwn) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    const auto axes = choices_of(split_sides(sampled(kBevelled, 0, rng), kRightAngles, kBeside));
    EXPECT_EQ(axes.size(), 5u) << seed;
    EXPECT_EQ(std::count(axes.begin(), axes.end(), kOwnDirection), 1) << seed;
  }
}

TEST(SideSplit, AStepOfSixSigmaIsKeptAndOneOfASigmaIsNot) {
  const auto sides_with_step = [](double step) {
    Rng rng(11);
    return split_sides(sampled({{0, 0}, {20, 0}, {20, step}, {40, step}, {40, 20}, {0, 20}}, 0, rng), kRightAngles,
                       kBeside)
        .size();
  };
  EXPECT_GT(sides_with_step(6 * kBeside), 4u);
  EXPECT_EQ(sides_with_step(kBeside), 4u);
}

TEST(SideSplit, TheResultDoesNotDependOnWhereTheRingBegins) {
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    Rng rng(seed);
    const Vertices ring = sampled(seed % 2 == 0 ? kAngled : kBevelled, 0.5, rng);
    const auto wanted = sorted_places(split_sides(ring, kRightAngles, kBeside), 0, ring.size());
    for (std::size_t shift = 1; shift < ring.size(); shift += 7) {
      Vertices later = ring;
      std::rotate(later.begin(), later.begin() + static_cast<std::ptrdiff_t>(shift), later.end());
      EXPECT_EQ(sorted_places(split_sides(later, kRightAngles, kBeside), shift, ring.size()), wanted)
          << seed << " " << shift;
    }
  }
}

TEST(SideSplit, TurnsWithTheRingAndItsAxes) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    Rng rng(seed);
    const Vertices ring = sampled(kAngled, 1, rng);
    const auto wanted = sorted_places(split_sides(ring, kRightAngles, kBeside), 0, ring.size());
    for (const double radians : {0.3, 1.1, 2.5})
      EXPECT_EQ(
          sorted_places(split_sides(rotated(ring, radians), rotated(kRightAngles, radians), kBeside), 0, ring.size()),
          wanted);
  }
}

TEST(SideSplit, WithoutAxesEverySideHasItsOwnDirection) {
  Rng rng(4);
  const auto sides = split_sides(sampled(kBlock, 0, rng), {}, kBeside);
  EXPECT_EQ(sides.size(), 4u);
  for (const SideSpan& s : sides) EXPECT_EQ(s.axis, kOwnDirection);
  EXPECT_TRUE(split_sides({}, kRightAngles, kBeside).empty());
}

}  // namespace
}  // namespace ilot
