// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/ransac.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "kernels/core/parallel.h"
#include "tests/support/oriented_sets.h"

namespace ilot {
namespace {

using test::OrientedSet;
using test::OrientedSetBuilder;
using test::Patch;

using test::kX, test::kY, test::kZ;
constexpr double kCos25 = 0.9063077870366499;

RansacParams params_of(double epsilon, std::int64_t connectivity, std::uint32_t min_points = 30,
                       std::uint64_t key = 1) {
  return {epsilon, kCos25, connectivity, min_points, 0.99, key};
}

std::vector<std::size_t> sizes(const RansacPlanes& found) {
  std::vector<std::size_t> count(found.planes.size() + 1, 0);
  for (const std::uint32_t label : found.label) ++count[label];
  return count;
}

// What holds for any input: labels refer to planes, each plane has enough points, all within epsilon and the angle.
void expect_sound(const OrientedSet& set, const RansacParams& params, const RansacPlanes& found) {
  ASSERT_EQ(found.label.size(), set.size);
  ASSERT_LE(*std::max_element(found.label.begin(), found.label.end()), found.planes.size());
  const auto count = sizes(found);
  for (std::size_t p = 1; p < count.size(); ++p) EXPECT_GE(count[p], params.min_points);
  for (std::size_t i = 0; i < set.size; ++i) {
    if (found.label[i] == 0) continue;
    const Plane& plane = found.planes[found.label[i] - 1];
    ASSERT_NEAR(norm(plane.n), 1, 1e-12);
    ASSERT_LE(std::abs(signed_distance(plane, set.position(i))), params.epsilon) << i;
    ASSERT_GE(std::abs(dot(plane.n, set.normal(i))), params.min_cos) << i;
  }
}

// Three faces of a box and points without meaning around them.
OrientedSet corner(std::uint64_t key) {
  OrientedSetBuilder b(key);
  const Vec3 o{2000, 2000, 2000};
  b.add(Patch{o, kX, kY, 60, 50, 20, 3}, 0.2);
  b.add(Patch{o, kY, kZ, 50, 40, 20, 3}, 0.2);
  b.add(Patch{o, kZ, kX, 40, 60, 20, 3}, 0.2);
  Rng rng(key + 1);
  for (int i = 0; i < 500; ++i) {
    const Vec3 n{rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5};
    b.add(o + Vec3{1200 * rng.uniform(), 1000 * rng.uniform(), 800 * rng.uniform()}, (1 / norm(n)) * n);
  }
  return b.build();
}

TEST(Ransac, ThreeNoisyFacesAreFoundAndNothingElse) {
  for (const std::uint64_t key : {1, 2, 3, 4}) {
    const OrientedSet set = corner(key);
    const RansacParams params = params_of(12, 60, 30, key);
    const RansacPlanes found = ransac_planes(set.view(), params);
    expect_sound(set, params, found);
    ASSERT_EQ(found.planes.size(), 3u) << "key " << key;
    const Vec3 wanted[3]{kZ, kY, kX};  // the largest first: 3,000, 2,400, 2,000 points
    for (std::size_t p = 0; p < 3; ++p) {
      EXPECT_GT(std::abs(dot(found.planes[p].n, wanted[p])), 0.99999) << p;  // 0.26 degrees
      EXPECT_NEAR(std::abs(signed_distance(found.planes[p], {2300, 2300, 2300})), 300, 3);
    }
    EXPECT_LT(sizes(found)[0], 700u);  // the 500 without meaning, and a few along the edges
  }
}

TEST(Ransac, TheKeyAndThePointsAreAllThatMatters) {
  const OrientedSet set = corner(9);
  const RansacPlanes once = ransac_planes(set.view(), params_of(12, 60));
  for (const int threads : {1, 2, 8}) {
    with_threads(threads, [&] {
      const RansacPlanes again = ransac_planes(set.view(), params_of(12, 60));
      EXPECT_EQ(again.label, once.label);
      for (std::size_t p = 0; p < once.planes.size(); ++p) EXPECT_EQ(again.planes[p].d, once.planes[p].d);
    });
  }
  const RansacPlanes other = ransac_planes(set.view(), params_of(12, 60, 30, 77));
  std::size_t moved = 0;
  for (std::size_t i = 0; i < set.size; ++i) moved += other.label[i] != once.label[i];
  EXPECT_LT(moved, set.size / 50);
}

TEST(Ransac, AnyOrderOfPointsGivesThePlanes) {
  const OrientedSet sorted = corner(5);
  OrientedSet shuffled = sorted;
  Rng rng(6);
  for (std::size_t i = sorted.size; i > 1; --i) {
    const std::size_t j = rng.below(i);
    for (auto* v : {&shuffled.x, &shuffled.y, &shuffled.z, &shuffled.nx, &shuffled.ny, &shuffled.nz})
      std::swap((*v)[i - 1], (*v)[j]);
  }
  const RansacPlanes a = ransac_planes(sorted.view(), params_of(12, 60));
  const RansacPlanes b = ransac_planes(shuffled.view(), params_of(12, 60));
  expect_sound(shuffled, params_of(12, 60), b);
  ASSERT_EQ(a.planes.size(), b.planes.size());
  for (std::size_t p = 0; p < a.planes.size(); ++p) EXPECT_GT(dot(a.planes[p].n, b.planes[p].n), 0.99999);
}

// A beam from above meets rows of spots on a wall that are farther apart than those on the ground.
TEST(Ransac, UprightPlanesConnectOverWiderGapsOnlyWhereBeamsComeFromAbove) {
  OrientedSetBuilder b(5);
  b.add(Patch{{0, 0, 0}, kX, kZ, 10, 10, 70, 0});     // upright
  b.add(Patch{{0, 5000, 0}, kX, kY, 10, 10, 70, 0});  // level
  const OrientedSet set = b.build();
  RansacParams params = params_of(5, 40);
  EXPECT_TRUE(ransac_planes(set.view(), params).planes.empty());
  params.most_stretch = 2;
  const RansacPlanes found = ransac_planes(set.view(), params);
  expect_sound(set, params, found);
  EXPECT_EQ(sizes(found), (std::vector<std::size_t>{100, 100}));
  EXPECT_NEAR(found.planes.at(0).n.z, 0, 1e-9);
}

TEST(Ransac, ParallelPlanesPartByEpsilon) {
  const auto two = [](double apart) {
    OrientedSetBuilder b(3);
    b.add(Patch{{100, 100, 500}, kX, kY, 40, 40, 10, 0});
    b.add(Patch{{105, 105, 500 + apart}, kX, kY, 40, 40, 10, 0});
    return b.build();
  };
  const OrientedSet far = two(30), near = two(8);
  const RansacPlanes apart = ransac_planes(far.view(), params_of(10, 40));
  expect_sound(far, params_of(10, 40), apart);
  EXPECT_EQ(sizes(apart), (std::vector<std::size_t>{0, 1600, 1600}));
  const RansacPlanes together = ransac_planes(near.view(), params_of(10, 40));
  expect_sound(near, params_of(10, 40), together);
  EXPECT_EQ(sizes(together), (std::vector<std::size_t>{0, 3200}));
}

TEST(Ransac, OnePlaneInTwoPlacesIsTwoPlanes) {
  OrientedSetBuilder b(4);
  b.add(Patch{{100, 100, 100}, kX, kY, 40, 40, 10, 0});
  b.add(Patch{{100 + 390 + 31, 100, 100}, kX, kY, 30, 40, 10, 0});
  const OrientedSet set = b.build();
  EXPECT_EQ(sizes(ransac_planes(set.view(), params_of(5, 30))), (std::vector<std::size_t>{0, 1600, 1200}));
  EXPECT_EQ(sizes(ransac_planes(set.view(), params_of(5, 31))), (std::vector<std::size_t>{0, 2800}));
}

// Stones of one facade: parts of one plane whose boxes come nearer than the connectivity, since it tilts against the
// axes, while their points do not.
TEST(Ransac, PartsOfOnePlaneAreNoEdgeStrips) {
  const Vec3 u{0.8, 0.6, 0}, v{-0.6, 0.8, 0};
  OrientedSetBuilder b(4);
  b.add(Patch{{1000, 1000, 100}, u, v, 40, 40, 10, 0});
  b.add(Patch{Vec3{1000, 1000, 100} + 430.0 * u, u, v, 30, 40, 10, 0});
  const OrientedSet set = b.build();
  const auto found = sizes(ransac_planes(set.view(), params_of(5, 35)));
  EXPECT_EQ(found, (std::vector<std::size_t>{0, 1600, 1200}));
}

TEST(Ransac, MinPointsIsClosed) {
  OrientedSetBuilder b(5);
  b.add(Patch{{100, 100, 100}, kX, kY, 6, 5, 10, 0});
  const OrientedSet set = b.build();
  EXPECT_EQ(ransac_planes(set.view(), params_of(2, 30, 30)).planes.size(), 1u);
  EXPECT_EQ(ransac_planes(set.view(), params_of(2, 30, 31)).planes.size(), 0u);
}

TEST(Ransac, AnEdgeStripIsNoPlane) {
  const Vec3 mixed = (1 / std::sqrt(2.0)) * Vec3{1, 0, 1};
  OrientedSetBuilder b(6);
  std::size_t strip = 0;
  for (int i = 0; i < 100; ++i)
    for (int j = 0; j < 100; ++j) {
      const double far = 20.0 * i, along = 20.0 * j;
      b.add({far + 100, along, 100}, far <= 60 ? mixed : kZ);
      b.add({100, along, far + 120}, far <= 40 ? mixed : kX);
      strip += (far <= 60) + (far <= 40);
    }
  const OrientedSet set = b.build();
  const RansacPlanes found = ransac_planes(set.view(), params_of(40, 60));
  expect_sound(set, params_of(40, 60), found);
  EXPECT_EQ(found.planes.size(), 2u);
  EXPECT_EQ(sizes(found)[0], strip);
}

TEST(Ransac, DegenerateInputHasNoPlanes) {
  EXPECT_TRUE(ransac_planes({}, params_of(10, 40, 3)).planes.empty());
  for (const int n : {1, 2, 500}) {
    OrientedSetBuilder line(7), place(8);
    for (int i = 0; i < n; ++i) {
      line.add({100 + 9.0 * i, 100 + 3.0 * i, 5}, kZ);
      place.add({100, 100, 5}, kZ);
    }
    for (const OrientedSet& set : {line.build(), place.build()}) {
      const RansacPlanes found = ransac_planes(set.view(), params_of(10, 40, 3));
      EXPECT_TRUE(found.planes.empty()) << n;
      EXPECT_EQ(found.label, std::vector<std::uint32_t>(static_cast<std::size_t>(n), 0));
    }
  }
}

TEST(Ransac, PointsWithoutNormalAreLeftOut) {
  OrientedSetBuilder b(9);
  b.add(Patch{{100, 100, 100}, kX, kY, 40, 40, 10, 0});
  OrientedSet set = b.build();
  for (std::size_t i = 0; i < set.size; i += 2) set.nx[i] = set.ny[i] = set.nz[i] = 0;
  const RansacPlanes half = ransac_planes(set.view(), params_of(5, 40));
  EXPECT_EQ(sizes(half), (std::vector<std::size_t>{800, 800}));
  for (std::size_t i = 0; i < set.size; i += 2) ASSERT_EQ(half.label[i], 0u);
  const RansacPlanes none = ransac_planes({set.view().points}, params_of(5, 40));  // null arrays: no normals at all
  EXPECT_TRUE(none.planes.empty());
  EXPECT_EQ(none.label.size(), set.size);
}

}  // namespace
}  // namespace ilot
