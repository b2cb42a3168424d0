// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/colour_ransac.h"

#include <numeric>

#include "tests/support/segment_sets.h"

namespace ilot {
namespace {

struct ColourScene {
  test::OrientedSet set;
  std::vector<std::uint32_t> colour;  // 1 to 4: mostly that of the surface, a tenth is another
};

// Four walls of a court, each with a colour that mostly tells it from the others, and clutter of all colours.
ColourScene court(std::uint64_t key) {
  test::OrientedSetBuilder b(key);
  const Vec3 x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1}, o{3000, 3000, 1000};
  b.add(test::Patch{o, x, z, 60, 40, 20, 2}, 0.1);
  b.add(test::Patch{o, y, z, 50, 40, 20, 2}, 0.1);
  b.add(test::Patch{o + 1300.0 * y, x, z, 45, 40, 20, 2}, 0.1);
  b.add(test::Patch{o + 1400.0 * x, y, z, 40, 40, 20, 2}, 0.1);
  Rng rng(key + 1);
  for (int i = 0; i < 4000; ++i) {
    const Vec3 n{rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5};
    b.add(o + Vec3{1400 * rng.uniform(), 1300 * rng.uniform(), 800 * rng.uniform()}, (1 / norm(n)) * n);
  }
  ColourScene s{b.build(), {}};
  for (std::size_t i = 0; i < s.set.size; ++i) {
    const Vec3 p = s.set.position(i) - o;
    const auto other = static_cast<std::uint32_t>(1 + rng.below(4));
    const std::uint32_t own = std::abs(p.y) < 12          ? 1
                              : std::abs(p.x) < 12        ? 2
                              : std::abs(p.y - 1300) < 12 ? 3
                              : std::abs(p.x - 1400) < 12 ? 4
                                                          : other;
    s.colour.push_back(rng.below(10) == 0 ? other : own);
  }
  return s;
}

ColourRansacParams colour_params(std::uint64_t key) {
  ColourRansacParams p;
  p.epsilon = 8;
  p.min_points = 1000;
  p.max_planes = 4;
  p.key = key;
  return p;
}

TEST(ColourRansac, FindsTheWallsWithFewerDraws) {
  std::uint64_t classical = 0, guided = 0;
  for (std::uint64_t key = 1; key <= 5; ++key) {
    const ColourScene s = court(key);
    const auto plain = colour_ransac(s.set.view(), {}, colour_params(key));
    const auto coloured = colour_ransac(s.set.view(), s.colour, colour_params(key));
    for (const auto* r : {&plain, &coloured}) {
      test::expect_sound(s.set, r->segments, 8, 1000);
      EXPECT_EQ(r->segments.planes.size(), 4u);
      EXPECT_EQ(r->draws.size(), r->segments.planes.size());
      for (std::size_t p = 0; p < r->draws.size(); ++p) {
        ASSERT_FALSE(r->progress[p].empty());
        EXPECT_LE(r->progress[p].back().draw, r->draws[p]);
        for (std::size_t i = 1; i < r->progress[p].size(); ++i)
          EXPECT_GT(r->progress[p][i].support, r->progress[p][i - 1].support);
      }
    }
    classical += std::accumulate(plain.draws.begin(), plain.draws.end(), std::uint64_t{0});
    guided += std::accumulate(coloured.draws.begin(), coloured.draws.end(), std::uint64_t{0});
  }
  EXPECT_LT(static_cast<double>(guided), 0.6 * static_cast<double>(classical));
}

TEST(ColourRansac, OneColourIsTheClassicalSearch) {
  const ColourScene s = court(3);
  const auto plain = colour_ransac(s.set.view(), {}, colour_params(3));
  const auto one = colour_ransac(s.set.view(), std::vector<std::uint32_t>(s.set.size, 1), colour_params(3));
  EXPECT_EQ(plain.segments.label, one.segments.label);
  EXPECT_EQ(plain.draws, one.draws);
}

TEST(ColourRansac, KeyAndPointsAreAllThatMatters) {
  const ColourScene s = court(4);
  const auto a = colour_ransac(s.set.view(), s.colour, colour_params(5)),
             b = colour_ransac(s.set.view(), s.colour, colour_params(5));
  EXPECT_EQ(a.segments.label, b.segments.label);
  EXPECT_EQ(a.draws, b.draws);
}

TEST(ColourRansac, DrawsAreCappedAndNothingIsNothing) {
  EXPECT_TRUE(colour_ransac({}, {}, colour_params(1)).segments.planes.empty());
  const ColourScene s = court(6);
  ColourRansacParams params = colour_params(1);
  params.max_draws = 16;
  params.min_points = 3;
  params.max_planes = 2;
  const auto r = colour_ransac(s.set.view(), s.colour, params);
  EXPECT_LE(r.draws.size(), 2u);
  for (const std::uint64_t d : r.draws) EXPECT_LE(d, 16u);
  const auto line = test::point_sets(2000)[3];
  std::vector<float> up(line.size + 16, 1.0f), flat(line.size + 16, 0.0f);
  const OrientedPoints points{line.view(), flat.data(), flat.data(), up.data()};
  params.max_draws = 200;
  const auto none = colour_ransac(points, {}, params);  // three points of a line make no plane
  EXPECT_TRUE(none.segments.planes.empty());
}

}  // namespace
}  // namespace ilot
