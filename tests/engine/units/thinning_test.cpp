// SPDX-License-Identifier: Apache-2.0
#include "engine/units/thinning.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <map>
#include <set>
#include <tuple>

#include "kernels/core/rng.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

using Coordinates = std::array<std::int64_t, 3>;

Coordinates coordinates(Index3 p) {
  return {p.x, p.y, p.z};
}

// A roof beside a wall, dense at one end, millimetres.
std::vector<Index3> house(std::uint64_t seed, std::size_t count) {
  Rng rng(seed);
  std::vector<Index3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const auto x = static_cast<std::int64_t>(10000 * rng.uniform() * rng.uniform());
    const auto across = static_cast<std::int64_t>(rng.below(8000));
    points.push_back(i % 3 == 0 ? Index3{x, 0, across} : Index3{x, across, 8000 + across / 2});
  }
  return points;
}

struct Thinned {
  std::set<Coordinates> positions;
  std::int64_t edge = 0;
  friend bool operator==(const Thinned&, const Thinned&) = default;
};

Thinned thinned(const std::vector<Index3>& points, Index3 corner, std::size_t most) {
  Thinning thinning(corner, most);
  for (std::uint32_t i = 0; i < points.size(); ++i) thinning.add(points[i], {0, i});
  Thinned result;
  result.edge = thinning.edge();
  const auto kept = thinning.take();
  EXPECT_LE(kept.size(), most);
  for (const KeptPoint& k : kept) {
    EXPECT_EQ(coordinates(k.position), coordinates(points[k.place.point]));
    EXPECT_TRUE(result.positions.insert(coordinates(k.position)).second);
  }
  return result;
}

std::set<Coordinates> cubes(const std::vector<Index3>& points, std::int64_t edge) {
  std::set<Coordinates> occupied;
  for (const Index3 p : points) occupied.insert({p.x / edge, p.y / edge, p.z / edge});
  return occupied;
}

TEST(Thinning, KeepsAllThereIsRoomFor) {
  const std::vector<Index3> points = house(1, 500);
  const Thinned all = thinned(points, {}, 500);
  EXPECT_EQ(all.edge, 1);
  EXPECT_EQ(all.positions.size(), cubes(points, 1).size());
}

TEST(Thinning, OneOfEachCubeOfTheFinestLattice) {
  const std::vector<Index3> points = house(2, 20000);
  for (const std::size_t most : {1, 7, 300, 3000}) {
    const Thinned t = thinned(points, {}, most);
    const auto occupied = cubes(points, t.edge);
    EXPECT_LE(occupied.size(), most);
    EXPECT_GT(cubes(points, t.edge / 2).size(), most) << "a finer lattice has as few";
    EXPECT_EQ(t.positions.size(), occupied.size());
    std::set<Coordinates> of_kept;
    for (const Coordinates& p : t.positions) of_kept.insert({p[0] / t.edge, p[1] / t.edge, p[2] / t.edge});
    EXPECT_EQ(of_kept, occupied);
  }
}

TEST(Thinning, OrderDoesNotMatter) {
  std::vector<Index3> points = house(3, 10000);
  const Thinned before = thinned(points, {}, 1000);
  for (std::uint64_t seed = 0; seed < 5; ++seed) {
    Rng rng(seed);
    for (std::size_t i = points.size(); i > 1; --i) std::swap(points[i - 1], points[rng.below(i)]);
    EXPECT_EQ(thinned(points, {}, 1000), before);
  }
}

TEST(Thinning, MovesWithTheUnit) {
  const std::vector<Index3> points = house(4, 10000);
  const Thinned before = thinned(points, {}, 1000);
  const Index3 by{651009193, -6861081665, 77};
  std::vector<Index3> moved;
  for (const Index3 p : points) moved.push_back({p.x + by.x, p.y + by.y, p.z + by.z});
  const Thinned after = thinned(moved, by, 1000);
  EXPECT_EQ(after.edge, before.edge);
  std::set<Coordinates> back;
  for (const Coordinates& p : after.positions) back.insert({p[0] - by.x, p[1] - by.y, p[2] - by.z});
  EXPECT_EQ(back, before.positions);
}

TEST(Thinning, AsManyWhenTheUnitIsTurned) {
  const std::vector<Index3> points = house(5, 10000);
  std::vector<Index3> turned;  // a third of a turn about the diagonal
  for (const Index3 p : points) turned.push_back({p.y, p.z, p.x});
  const Thinned before = thinned(points, {}, 1000), after = thinned(turned, {}, 1000);
  EXPECT_EQ(after.edge, before.edge);
  EXPECT_EQ(after.positions.size(), before.positions.size());
}

TEST(Thinning, PointsThatCoincideAreOne) {
  Thinning thinning({}, 2);
  for (std::uint32_t i = 0; i < 100; ++i) thinning.add({5, 5, 5}, {i / 10, 99 - i});
  const auto kept = thinning.take();
  ASSERT_EQ(kept.size(), 1u);
  EXPECT_EQ(kept[0].place, (StorePlace{0, 90}));
  EXPECT_EQ(thinning.edge(), 1);
}

// The same points in blocks of another size: the same are kept, in the same order.
TEST(Thinning, BlocksDoNotShow) {
  const std::vector<Index3> points = house(6, 6000);
  const auto kept_of = [&](std::uint64_t block_points) {
    const test::CloudStore cloud(points, {block_points, 1u << 20, 2});
    const IndexBox box{{100, 0, 0}, {9000, 7000, 11000}};
    Thinning thinning(box.min, 500);
    std::size_t count = 0;
    for_each_stretch_in(cloud.store(), box, [&](const Stretch& s, std::span<const StretchPoint> inside) {
      for (const StretchPoint& p : inside) thinning.add(p.position, place_of(s, p));
      count += inside.size();
    });
    EXPECT_EQ(count, std::count_if(points.begin(), points.end(), [&](Index3 p) { return box.contains(p); }));
    std::vector<Coordinates> positions;
    for (const KeptPoint& k : thinning.take()) positions.push_back(coordinates(k.position));
    return positions;
  };
  const auto whole = kept_of(1u << 20);
  EXPECT_GT(whole.size(), 125u);
  EXPECT_EQ(kept_of(700), whole);
  EXPECT_EQ(kept_of(64), whole);
}

}  // namespace
}  // namespace ilot
