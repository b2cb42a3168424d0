// SPDX-License-Identifier: Apache-2.0
#include "engine/store/strays.h"

#include <gtest/gtest.h>

#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

constexpr int kStrayBits = 19;
constexpr std::int64_t kStrayEdge = std::int64_t{1} << kStrayBits, kTile = std::int64_t{1} << kTileBits;
constexpr Index3 kLambert{651000000, 6861000000, 50000};

std::vector<Index3> stray_points(const std::vector<Index3>& points) {
  CoarseCells cells(kStrayBits);
  for (const Index3& p : points) cells.add(p);
  const Strays found = find_strays(cells);
  std::vector<Index3> alone;
  for (const Index3& p : points)
    if (found.contains(p)) alone.push_back(p);
  return alone;
}

// n points within `reach` of a place on each axis.
std::vector<Index3> cluster(Index3 at, std::int64_t reach, std::size_t n, std::uint64_t key) {
  Rng rng(key);
  const auto near = [&](std::int64_t v) {
    return v + static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(2 * reach))) - reach;
  };
  std::vector<Index3> points;
  for (std::size_t i = 0; i < n; ++i) points.push_back({near(at.x), near(at.y), near(at.z)});
  return points;
}

std::vector<Index3> joined(std::vector<Index3> a, const std::vector<Index3>& b) {
  a.insert(a.end(), b.begin(), b.end());
  return a;
}

const std::vector<Index3>& town() {
  static const auto points = cluster(kLambert, 200000, 5000, 1);
  return points;
}

TEST(Strays, WhatStandsAloneFarFromEverything) {
  EXPECT_TRUE(stray_points(town()).empty());
  for (const Index3 p :
       {Index3{0, 0, 0}, Index3{kLambert.x + 200000000, kLambert.y, 0}, Index3{0, 0, 1000000000000},
        Index3{kLambert.x, kLambert.y, kLambert.z - 1250000}, Index3{kLambert.x, kLambert.y, kLambert.z + 1250000}})
    for (const std::size_t rows : {1u, 10000u}) {
      const std::vector<Index3> alone(rows, p);
      EXPECT_EQ(stray_points(joined(town(), alone)), alone);
      EXPECT_EQ(stray_points(joined(alone, town())), alone);
    }
}

TEST(Strays, AreManySmallGroupsToo) {
  std::vector<Index3> birds;
  for (int i = 0; i < 20; ++i)
    birds = joined(birds,
                   cluster({kLambert.x + i * 10 * kStrayEdge, kLambert.y, kLambert.z + 8 * kStrayEdge}, 1000, 15, 9));
  EXPECT_EQ(stray_points(joined(town(), birds)).size(), birds.size());
}

TEST(Strays, NearPointsAreNone) {
  // At a gap of one edge from the cells of the town all still belongs to it.
  for (const std::int64_t by : {kStrayEdge / 2, kStrayEdge - 200001}) {
    EXPECT_TRUE(stray_points(joined(town(), {{kLambert.x, kLambert.y, kLambert.z + 200000 + by}})).empty());
    EXPECT_TRUE(stray_points(joined(town(), {{kLambert.x - 200000 - by, kLambert.y, kLambert.z}})).empty());
  }
  // A chain of single points leads to one that is far.
  std::vector<Index3> chain;
  for (int i = 0; i < 20; ++i) chain.push_back({kLambert.x + i * kStrayEdge, kLambert.y, kLambert.z});
  EXPECT_TRUE(stray_points(joined(town(), chain)).empty());
}

TEST(Strays, TwoRealPartsBothStay) {
  const auto other = cluster({kLambert.x + 50000000, kLambert.y, kLambert.z}, 100000, 3000, 2);
  EXPECT_TRUE(stray_points(joined(town(), other)).empty());
  const auto small = cluster({kLambert.x + 50000000, kLambert.y, kLambert.z}, 100000, kFewPlaces, 3);
  EXPECT_TRUE(stray_points(joined(town(), small)).empty());
  const auto few = cluster({kLambert.x + 50000000, kLambert.y, kLambert.z}, 100000, kFewPlaces - 1, 3);
  EXPECT_EQ(stray_points(joined(town(), few)), few);
}

TEST(Strays, AreNeverMoreThanATenthOfTheRest) {
  const auto eighty = cluster(kLambert, 1000, 80, 4);
  EXPECT_TRUE(stray_points(joined(eighty, cluster({0, 0, 0}, 1000, 9, 5))).empty());
  EXPECT_EQ(stray_points(joined(eighty, cluster({0, 0, 0}, 1000, 8, 5))).size(), 8u);
  const std::vector<Index3> zeros(10000, Index3{0, 0, 0});
  EXPECT_EQ(stray_points(joined(eighty, zeros)), zeros);
}

TEST(Strays, AreNotWhereAllIsSparse) {
  EXPECT_TRUE(stray_points({}).empty());
  EXPECT_TRUE(stray_points(std::vector<Index3>(100, Index3{7, 7, 7})).empty());
  EXPECT_TRUE(stray_points(cluster({0, 0, 0}, std::int64_t{1} << 40, 50000, 6)).empty());
  EXPECT_TRUE(stray_points(cluster({0, 0, 0}, std::int64_t{1} << 40, 60, 6)).empty());
}

TEST(Strays, ACloudAroundTheOriginLosesNothing) {
  EXPECT_TRUE(
      stray_points(joined(cluster({0, 0, 0}, 100000, 2000, 7), std::vector<Index3>(10000, Index3{0, 0, 0}))).empty());
}

// The order of the points is nothing, and a shift by whole tiles moves the answer along.
TEST(Strays, FollowThePoints) {
  Rng rng(11);
  for (int round = 0; round < 20; ++round) {
    std::vector<Index3> points =
        cluster(kLambert, 100 * static_cast<std::int64_t>(1 + rng.below(10000)), 3000, rng.next());
    for (int group = 0; group < 6; ++group) {
      const auto far = [&] { return static_cast<std::int64_t>(rng.below(8000000)) - 4000000; };
      points = joined(points, cluster({kLambert.x + far(), kLambert.y + far(), kLambert.z + far()}, 1000,
                                      1 + rng.below(120), rng.next()));
    }
    auto wanted = stray_points(points);
    std::vector<Index3> moved;
    for (auto p = points.rbegin(); p != points.rend(); ++p)
      moved.push_back({p->x - 300 * kTile, p->y + 7 * kTile, p->z + kTile});
    auto found = stray_points(moved);
    std::reverse(found.begin(), found.end());
    for (Index3& p : found) p = {p.x + 300 * kTile, p.y - 7 * kTile, p.z - kTile};
    EXPECT_EQ(found, wanted) << round;
  }
}

// The ranges of codes say the same as the cells.
TEST(Strays, AreRangesOfCodesInTheirTiles) {
  auto points = joined(town(), cluster({kLambert.x, kLambert.y, kLambert.z + 3 * kStrayEdge}, 100, 5, 12));
  points.push_back({0, 0, 0});
  CoarseCells cells(kStrayBits);
  for (const Index3& p : points) cells.add(p);
  const Strays found = find_strays(cells);
  std::size_t inside = 0;
  for (const Index3& p : points) {
    const PointKey key = key_of(p);
    const auto ranges = found.in_tile(key.tile);
    const bool in = std::any_of(ranges.begin(), ranges.end(),
                                [&](CodeRange r) { return r.first <= key.code && key.code <= r.last; });
    EXPECT_EQ(in, found.contains(p));
    inside += in;
  }
  EXPECT_EQ(inside, 6u);
  const Strays wide(kTileBits + 3, {CoarseCell{0, 0, 0}});
  EXPECT_EQ(wide.in_tile({7, 0, 7}).size(), 1u);
  EXPECT_TRUE(wide.in_tile({8, 0, 0}).empty());
  EXPECT_TRUE(wide.in_tile({-1, 0, 0}).empty());
}

}  // namespace
}  // namespace ilot
