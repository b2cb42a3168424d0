// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/region_growing.h"

#include <functional>

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

using test::kX, test::kY, test::kZ;

TEST(RegionGrowing, AStepPartsRegionsByOffsetAnAngleByNormal) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{0, 0, 100}, kX, kY, 10, 10, 10, 0});
  b.add(test::Patch{{100, 0, 106}, kX, kY, 10, 10, 10, 0});  // a step of 6
  b.add(test::Patch{{200, 0, 106}, kZ, kY, 10, 10, 10, 0});  // upright
  const auto set = b.build();
  const auto normals = test::packed_normals(set);
  const auto near = test::neighbours_of(set.view().points, 8);
  // Local planes of the ten points on either side of the step hang between the two levels: regions of their own.
  const auto apart = grow_by_pairs(set.view().points, normals, near.lists(), {0.996, 0.5, 20, 11});
  EXPECT_EQ(apart.count, 3u);
  const auto joined = grow_by_pairs(set.view().points, normals, near.lists(), {0.996, 6, 20, 10});
  EXPECT_EQ(joined.count, 2u);
  const auto smooth = grow_smooth(set.view().points, normals, near.lists(), {0.9994, 1, 20, 10});
  EXPECT_EQ(smooth.count, 2u);
  EXPECT_EQ(grow_smooth(set.view().points, normals, near.lists(), {0.9994, 1, 9, 10}).count, 0u);  // gap below the step
}

// Oracle: components by flooding over all pairs that fulfil the criterion in either list.
std::vector<std::uint32_t> flooded(std::size_t n, const NeighbourLists& near, std::uint32_t min_points,
                                   const std::function<bool(std::uint32_t, std::uint32_t)>& joined) {
  std::vector<std::vector<std::uint32_t>> edges(n);
  for (std::uint32_t i = 0; i < n; ++i)
    for (const std::uint32_t j : near.of(i))
      if (j != kNoNeighbour && j != i && joined(i, j)) {
        edges[i].push_back(j);
        edges[j].push_back(i);
      }
  std::vector<std::uint32_t> id(n, 0);
  std::uint32_t next = 1;
  for (std::uint32_t i = 0; i < n; ++i) {
    if (id[i] != 0) continue;
    std::vector<std::uint32_t> reached{i};
    id[i] = next;
    for (std::size_t at = 0; at < reached.size(); ++at)
      for (const std::uint32_t j : edges[reached[at]])
        if (id[j] == 0) {
          id[j] = next;
          reached.push_back(j);
        }
    if (reached.size() < min_points)
      for (const std::uint32_t j : reached) id[j] = 0xffffffff;
    ++next;
  }
  for (std::uint32_t& v : id) v = v == 0xffffffff ? 0 : v;
  return id;
}

Vec3 unit(PackedNormal n) {
  const Vec3 v{static_cast<double>(n.x), static_cast<double>(n.y), static_cast<double>(n.z)};
  return dot(v, v) > 0 ? (1 / norm(v)) * v : v;
}

TEST(RegionGrowing, SmoothRegionsEqualAFlood) {
  for (const auto& points : test::point_sets(700)) {
    const auto normals = test::estimated_normals(points.view(), 10);
    const auto near = test::neighbours_of(points.view(), 10);
    const SmoothGrowthParams params{0.98, 0.02, 300, 4};
    const auto got = grow_smooth(points.view(), normals, near.lists(), params);
    const auto wanted = flooded(points.size, near.lists(), params.min_points, [&](std::uint32_t i, std::uint32_t j) {
      const Vec3 d{points.x[i] - points.x[j], points.y[i] - points.y[j], points.z[i] - points.z[j]};
      return std::abs(dot(unit(normals[i]), unit(normals[j]))) >= params.min_cos && norm(d) <= 300 &&
             normals[i].curvature <= 0.02 * 3 * 65535 && normals[j].curvature <= 0.02 * 3 * 65535;
    });
    EXPECT_EQ(test::canonical(got.id), test::canonical(wanted)) << points.name;
  }
}

TEST(RegionGrowing, PairRegionsEqualAFlood) {
  for (const auto& points : test::point_sets(700)) {
    const auto normals = test::estimated_normals(points.view(), 10);
    const auto near = test::neighbours_of(points.view(), 10);
    const PairGrowthParams params{0.95, 12, 500, 4};
    const auto position = [&](std::uint32_t i) { return Vec3{points.x[i], points.y[i], points.z[i]}; };
    const auto projected = [&](std::uint32_t i) {
      Vec3 centre;
      for (const std::uint32_t j : near.lists().of(i)) centre = centre + 0.1 * position(j);
      const Vec3 n = unit(normals[i]);
      return position(i) - dot(n, position(i) - centre) * n;
    };
    const auto got = grow_by_pairs(points.view(), normals, near.lists(), params);
    const auto wanted = flooded(points.size, near.lists(), params.min_points, [&](std::uint32_t i, std::uint32_t j) {
      const Vec3 ni = unit(normals[i]), nj = unit(normals[j]), r = projected(j) - projected(i);
      return std::abs(dot(ni, nj)) >= params.min_cos && norm(position(i) - position(j)) <= 500 &&
             std::max(std::abs(dot(r, ni)), std::abs(dot(r, nj))) <= params.max_offset;
    });
    EXPECT_EQ(test::canonical(got.id), test::canonical(wanted)) << points.name;
  }
}

TEST(RegionGrowing, AnyOrderOfPointsGivesTheRegions) {
  const auto set = test::box_corner(3);
  const auto mixed = test::shuffled(set, 5);
  const auto regions = [](const test::OrientedSet& s) {
    const auto near = test::neighbours_of(s.view().points, 12);
    return grow_by_pairs(s.view().points, test::packed_normals(s), near.lists(), {0.99, 8, 60, 30});
  };
  const auto a = regions(set), b = regions(mixed.set);
  // Ties at the k-th neighbour go by index: sparse noise has none here, so the lists are the same sets.
  EXPECT_EQ(test::canonical(a.id), test::canonical(test::in_original_order(mixed, b.id)));
  EXPECT_GE(a.count, 3u);
}

TEST(RegionGrowing, SeedsAreTheFlattestPointsAndNumberTheRegions) {
  const auto set = test::box_corner(7);
  const auto normals = test::estimated_normals(set.view().points, 12);
  const auto near = test::neighbours_of(set.view().points, 12);
  const auto r = grow_smooth(set.view().points, normals, near.lists(), {0.97, 1, 100, 20});
  ASSERT_EQ(r.seed.size(), r.count);
  for (std::uint32_t i = 0; i < set.size; ++i) {
    if (r.id[i] == 0) continue;
    EXPECT_GE(normals[i].curvature, normals[r.seed[r.id[i] - 1]].curvature);
  }
  for (std::uint32_t s = 1; s < r.count; ++s) EXPECT_GE(normals[r.seed[s]].curvature, normals[r.seed[s - 1]].curvature);
}

TEST(RegionGrowing, DegenerateInputHasNoRegions) {
  EXPECT_EQ(grow_smooth({}, {}, {{}, 8}, {}).count, 0u);
  EXPECT_EQ(grow_by_pairs({}, {}, {{}, 8}, {}).count, 0u);
  const auto line = test::point_sets(50)[3];
  const auto near = test::neighbours_of(line.view(), 8);
  const auto r = grow_smooth(line.view(), test::estimated_normals(line.view(), 8), near.lists(), {0, 1, 1000, 1});
  EXPECT_EQ(r.count, 0u);  // points on a line have no normals
  EXPECT_EQ(r.id, std::vector<std::uint32_t>(50, 0));
}

}  // namespace
}  // namespace ilot
