// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/cleaning.h"

#include "kernels/core/radix_sort.h"
#include "kernels/geometry/padded_points.h"
#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

using test::kX, test::kY, test::kZ;

std::vector<std::int64_t> reaches(Points p, int k) {
  std::vector<std::uint32_t> list(p.size * static_cast<std::size_t>(k));
  std::vector<std::int64_t> reach2(p.size);
  knn(build_neighbour_index(p), test::all_of(p.size), {k, kMaxSquaredReach}, list, reach2);
  return reach2;
}

std::size_t dropped(const Kept& kept) {
  return static_cast<std::size_t>(std::count(kept.begin(), kept.end(), 0));
}

TEST(Cleaning, DensityDropsLonePointsOnly) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{1000, 1000, 100}, kX, kY, 50, 50, 10, 1});
  for (int i = 0; i < 5; ++i) b.add({100.0 + 150 * i, 100, 1000.0 + 90 * i}, kZ);
  const auto set = b.build();
  const auto kept = density_filter(reaches(set.view().points, 8));
  EXPECT_EQ(dropped(kept), 5u);
  for (std::size_t i = 0; i < set.size; ++i) EXPECT_EQ(kept[i] != 0, set.z[i] < 500);
  EXPECT_TRUE(density_filter({}).empty());
  EXPECT_EQ(density_filter(std::vector<std::int64_t>{-1, -1}), (Kept{0, 0}));
}

TEST(Cleaning, SmallFarCloudsAreDroppedTheBoundIsClosed) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 100}, kX, kY, 10, 10, 10, 0});
  b.add(test::Patch{{120, 0, 100}, kX, kY, 3, 3, 10, 0});  // 30 from the first
  const auto set = b.build();
  EXPECT_EQ(dropped(distance_split(set.view().points, 30, 10)), 0u);
  EXPECT_EQ(dropped(distance_split(set.view().points, 29, 10)), 9u);
  EXPECT_EQ(dropped(distance_split(set.view().points, 29, 9)), 0u);
  EXPECT_TRUE(distance_split({}, 5, 5).empty());
}

TEST(Cleaning, SlabIsClosedOnBothSides) {
  const auto set = test::make_set("column", {{0, 0, 1}, {0, 0, 2}, {0, 0, 3}, {0, 0, 4}, {0, 0, 5}});
  EXPECT_EQ(slab_split(set.view(), {kZ, -3}, -1, 1), (Kept{0, 1, 1, 1, 0}));
}

// A wall 4 m away, a pillar before it, a floor that slants away, and points hanging behind the pillar's edges.
struct Scan {
  std::vector<Vec3> points;
  std::vector<bool> mixed;
};

Scan scan(std::uint64_t key) {
  Scan s;
  Rng rng(key);
  constexpr double kAngle = 0.004;
  for (int i = -150; i <= 150; ++i)
    for (int j = -100; j <= 100; ++j) {
      const Vec3 d{kAngle * i, 1, kAngle * j};
      double range = 4000;  // along y
      const bool edge = std::abs(i) == 30;
      if (std::abs(i) <= 30) range = 2500;
      if (d.z < 0 && -1200 / d.z < range) range = -1200 / d.z;
      const bool is_mixed = edge && range == 2500 && (i + j) % 3 != 0;
      if (is_mixed) range = 2700 + 1100 * rng.uniform();
      s.points.push_back((range + test::bell(rng)) * d);
      s.mixed.push_back(is_mixed);
    }
  return s;
}

struct Lattice : PaddedPoints {
  std::vector<bool> mixed;
};

Lattice lattice(const Scan& s) {
  Lattice l;
  std::vector<std::uint64_t> codes;
  const auto whole = [](double v) { return static_cast<std::uint32_t>(std::nearbyint(v) + 100000); };
  for (const Vec3& p : s.points) codes.push_back(morton_code({whole(p.x), whole(p.y), whole(p.z)}));
  for (const std::uint32_t i : sorted_order(codes)) {
    const Vec3 p = s.points[i];
    l.add(static_cast<float>(std::nearbyint(p.x)), static_cast<float>(std::nearbyint(p.y)),
          static_cast<float>(std::nearbyint(p.z)));
    l.mixed.push_back(s.mixed[i]);
  }
  l.pad();
  return l;
}

TEST(Cleaning, MixedPixelsAreDroppedSlantingFloorsAreNot) {
  const Lattice l = lattice(scan(1));
  MixedPixelParams params;
  params.jump = 60;
  const Kept kept = mixed_pixel_filter(l.points(), {0, 0, 0}, params);
  std::size_t mixed = 0, found = 0, wrong = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    mixed += l.mixed[i];
    found += l.mixed[i] && kept[i] == 0;
    wrong += !l.mixed[i] && kept[i] == 0;
  }
  EXPECT_GT(mixed, 200u);
  EXPECT_GT(static_cast<double>(found), 0.9 * static_cast<double>(mixed));
  EXPECT_LT(static_cast<double>(wrong), 0.001 * static_cast<double>(kept.size()));
}

TEST(Cleaning, IsolationDropsMixedPixels) {
  const Lattice l = lattice(scan(2));
  const auto near = test::neighbours_of(l.points(), 8);
  const Kept kept = isolation_filter(near.lists(), reaches(l.points(), 8));
  std::size_t mixed = 0, found = 0, wrong = 0;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    mixed += l.mixed[i];
    found += l.mixed[i] && kept[i] == 0;
    wrong += !l.mixed[i] && kept[i] == 0;
  }
  // Without rays a sheet of hanging points looks like a sparse surface: only those near a dense one can be told.
  EXPECT_GT(static_cast<double>(found), 0.1 * static_cast<double>(mixed));
  EXPECT_LT(static_cast<double>(wrong), 0.001 * static_cast<double>(kept.size()));
}

TEST(Cleaning, MixedPixelsOfDegenerateScans) {
  EXPECT_TRUE(mixed_pixel_filter({}, {}, {}).empty());
  const auto place = test::make_set("place", std::vector<Cell3>(20, {5, 5, 5}));
  EXPECT_EQ(dropped(mixed_pixel_filter(place.view(), {5, 5, 5}, {})), 0u);  // at the station itself
  EXPECT_EQ(dropped(mixed_pixel_filter(place.view(), {0, 0, 0}, {})), 0u);  // all on one ray, at one range
}

}  // namespace
}  // namespace ilot
