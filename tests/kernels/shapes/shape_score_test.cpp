// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_score.h"

#include <numeric>

#include "kernels/shapes/shape_score_body.h"
#include "tests/support/segment_sets.h"
#include "tests/support/shape_sets.h"

namespace ilot {
namespace {

test::OrientedSet scene(std::size_t n) {
  test::OrientedSetBuilder b(3);
  Rng rng(4);
  test::add_shape(b, rng, test::sphere({3000, 3000, 3000}, 700), static_cast<int>(n / 2), 1, -1, 1, 20);
  test::add_shape(b, rng, test::cone({3000, 3000, 5000}, {0, 0, -1}, 0.5), static_cast<int>(n - n / 2), 1, 100, 3000,
                  20);
  return b.build();
}

std::vector<Shape> shapes() {
  return {{ShapeKind::kPlane, {3000, 3000, 3100}, {0.6, 0, 0.8}},
          test::sphere({3010, 2990, 3000}, 705),
          test::sphere({3000, 3000, -90000}, 93000),
          test::cylinder({3000, 3000, 9000}, {0, 0.1, 1}, 690),
          test::cone({3000, 3010, 5010}, {0, 0, -1}, 0.51)};
}

bool is_hit(const test::OrientedSet& set, std::size_t i, const Shape& s, double epsilon, double min_cos) {
  const ShapeView v = view_of(s, set.position(i));
  return std::abs(v.distance) <= epsilon && std::abs(dot(v.normal, set.normal(i))) >= min_cos;
}

TEST(ShapeScore, PointsOnAShapeAreThoseOfTheNaiveLoop) {
  for (const std::size_t n : {1u, 7u, 63u, 64u, 65u, 512u, 513u, 5000u}) {
    const auto set = scene(n);
    const auto index = build_shape_index(set.view(), test::all_of(set.size));
    for (const Shape& s : shapes()) {
      std::vector<std::uint32_t> got;
      for (const std::uint32_t i : points_on_shape(index, s, {25, 0.9})) got.push_back(index.index[i]);
      std::sort(got.begin(), got.end());
      std::vector<std::uint32_t> wanted;
      for (std::uint32_t i = 0; i < set.size; ++i)
        if (is_hit(set, i, s, 25, 0.9)) wanted.push_back(i);
      EXPECT_EQ(got, wanted) << n << " kind " << static_cast<int>(s.kind);
    }
  }
}

// float32 may judge points within its rounding of a bound otherwise: a share of a thousandth at these sizes.
TEST(ShapeScore, CountsAreTheNaiveLoopsUpToRoundingAndBoundsHold) {
  const auto set = scene(20000);
  const auto index = build_shape_index(set.view(), test::all_of(set.size));
  for (const Shape& s : shapes()) {
    std::uint32_t wanted = 0, counted = score_shape(index, s, {25, 0.9});
    for (std::size_t i = 0; i < set.size; ++i) wanted += is_hit(set, i, s, 25, 0.9);
    EXPECT_NEAR(counted, wanted, 20) << static_cast<int>(s.kind);
    EXPECT_GE(bound_shape(index, s, {25, 0.9}), counted);
  }
  EXPECT_GT(score_shape(index, shapes()[1], {25, 0.9}), 5000u);
  EXPECT_LT(bound_shape(index, shapes()[1], {25, 0.9}), 20000u);  // the bound is worth something
}

// Passing balls over changes nothing: the same count with every leaf looked at. And for every instruction set.
TEST(ShapeScore, CullingAndInstructionSetsDoNotShow) {
  const auto set = scene(10007);
  auto index = build_shape_index(set.view(), test::all_of(set.size));
  std::vector<std::uint32_t> holes;
  for (std::uint32_t i = 0; i < index.size; i += 3) holes.push_back(i);
  take_out(index, holes);
  std::vector<const float*> balls;
  for (const auto& level : index.balls) balls.push_back(level.data());
  std::vector<std::uint32_t> every(index.in_leaf.size() + 8), culled(every.size());
  std::iota(every.begin(), every.end(), 0u);
  for (const Shape& s : shapes()) {
    const std::uint32_t counted = score_shape(index, s, {25, 0.9});
    Vec3 origin = s.origin;
    const double along = dot(index.centre - origin, s.axis);
    if (s.kind == ShapeKind::kPlane) origin = index.centre - along * s.axis;
    if (s.kind == ShapeKind::kCylinder) origin = origin + along * s.axis;
    const auto f = [](double v) { return static_cast<float>(v); };
    const float shape[9]{f(origin.x), f(origin.y), f(origin.z), f(s.axis.x), f(s.axis.y),
                         f(s.axis.z), f(s.radius), f(s.sine),   f(s.cosine)};
    for (const simd::Isa isa : simd::kIsas) {
      if (!simd::has_isa(isa)) continue;
      simd::ShapeArgs args{};
      args.x = index.x.data();
      args.y = index.y.data();
      args.z = index.z.data();
      args.nx = index.nx.data();
      args.ny = index.ny.data();
      args.nz = index.nz.data();
      args.balls = balls.data();
      args.levels = static_cast<int>(balls.size());
      args.cones = index.cones.data();
      args.shape = shape;
      args.kind = static_cast<int>(s.kind);
      args.max_distance = 25;
      args.min_cos = 0.9f;
      args.slack = 1;
      args.angle_cosine = 0.89f;
      args.angle_sine = 0.46f;
      args.cosine_rounding = 0.001f;
      args.leaves = culled.data();
      args.leaf_count = simd::kShapeScore.of(isa).shape_leaves(args);
      EXPECT_EQ(simd::kShapeScore.of(isa).shape_hits(args), counted) << simd::name_of(isa);
      args.leaves = every.data();
      args.leaf_count = static_cast<std::uint32_t>(index.in_leaf.size());
      EXPECT_EQ(simd::kShapeScore.of(isa).shape_hits(args), counted) << simd::name_of(isa);
    }
  }
}

TEST(ShapeScore, HolesAreNeverFound) {
  const auto set = scene(1000);
  auto index = build_shape_index(set.view(), test::all_of(set.size));
  const Shape s = shapes()[1];
  const auto before = points_on_shape(index, s, {25, 0.9});
  ASSERT_FALSE(before.empty());
  take_out(index, before);
  EXPECT_EQ(index.left, 1000 - before.size());
  EXPECT_TRUE(points_on_shape(index, s, {25, 0.9}).empty());
  EXPECT_EQ(score_shape(index, s, {25, 0.9}), 0u);
}

// Points are taken out place by place, whole leaves too: a count brought up to date is one made anew, also in an index
// that never held the points that are gone.
TEST(ShapeScore, RecountingIsCounting) {
  const auto set = scene(20000);
  auto index = build_shape_index(set.view(), test::all_of(set.size));
  const ShapeScoreParams params{25, 0.9};
  std::vector<ShapeCount> known(shapes().size());
  std::size_t kept = 0, changed = 0;
  for (const Vec3 middle : {Vec3{3000, 3000, 3700}, Vec3{2400, 3000, 3000}, Vec3{3000, 3000, 4200}}) {
    for (std::size_t s = 0; s < known.size(); ++s) {
      const std::uint32_t counted = recount_shape(index, shapes()[s], params, known[s], 0);
      EXPECT_EQ(counted, score_shape(index, shapes()[s], params));
      ++(counted == known[s].points ? kept : changed);
      EXPECT_LT(recount_shape(index, shapes()[s], params, {}, 1u << 30), 1u << 30);
      known[s] = {counted, index.epoch};
    }
    std::vector<std::uint32_t> gone;
    for (std::uint32_t i = 0; i < index.size; ++i)
      if (!index.is_hole(i) && norm(index.position(i) - middle) < 450) gone.push_back(i);
    ASSERT_FALSE(gone.empty());
    take_out(index, gone);
    EXPECT_GT(std::count(index.in_leaf.begin(), index.in_leaf.end(), 0u), 0);
  }
  EXPECT_GT(kept, 0u);
  EXPECT_GT(changed, 0u);
}

TEST(ShapeScore, EmptyLeavesAreNeverMet) {
  const auto set = scene(20000);
  auto index = build_shape_index(set.view(), test::all_of(set.size));
  std::vector<std::uint32_t> all(index.size);
  std::iota(all.begin(), all.end(), 0u);
  take_out(index, std::span(all).first(all.size() / 2));
  for (const Shape& s : shapes()) EXPECT_GT(bound_shape(index, s, {1e6, 0}), 0u);
  take_out(index, std::span(all).subspan(all.size() / 2));
  for (const auto& level : index.balls)
    for (std::size_t ball = 0; ball < level.size() / 4; ++ball) {
      const float radius = level[ball / 8 * 32 + 24 + ball % 8];
      EXPECT_NE(radius, radius);
    }
}

TEST(ShapeScore, ABoxCutsOutItsPoints) {
  const auto set = scene(20000);
  const auto index = build_shape_index(set.view(), test::all_of(set.size));
  const Box3<Vec3> box{{2500, 2400, 2900}, {3400, 3600, 3800}};
  for (const Shape& s : shapes()) {
    std::vector<std::uint32_t> wanted = points_on_shape(index, s, {25, 0.9});
    std::erase_if(wanted, [&](std::uint32_t i) {
      const Vec3 p = index.position(i);
      return p.x < 2500 || p.x > 3400 || p.y < 2400 || p.y > 3600 || p.z < 2900 || p.z > 3800;
    });
    EXPECT_EQ(points_on_shape(index, s, {25, 0.9}, box), wanted);
  }
}

// Leaves whose normals all lean away from a plane's are passed over; the naive loop does not know of leaves. Normals of
// either sign, some of no unit length.
TEST(ShapeScore, LeavesOfOtherNormalsAreLeftOutOnly) {
  Rng rng(7);
  auto set = scene(20000);
  const auto scale = [&](std::size_t i, double by) {
    const auto f = static_cast<float>(by);
    set.nx[i] *= f, set.ny[i] *= f, set.nz[i] *= f;
  };
  for (std::size_t i = 0; i < set.size; ++i)
    if (rng.below(2) == 0) scale(i, -1);
  for (const bool unit : {true, false}) {
    if (!unit)
      for (std::size_t i = 0; i < set.size; i += 97) scale(i, 1.3);
    const auto index = build_shape_index(set.view(), test::all_of(set.size));
    for (int k = 0; k < 40; ++k) {
      const Vec3 about{rng.uniform() - 0.5, rng.uniform() - 0.5, rng.uniform() - 0.5};
      const auto at = static_cast<std::size_t>(rng.below(set.size));
      const Shape s{ShapeKind::kPlane, set.position(at), (1 / norm(about)) * about};
      for (const double min_cos : {0.0, 0.7, 0.95}) {
        std::size_t wanted = 0;
        for (std::size_t i = 0; i < set.size; ++i) wanted += is_hit(set, i, s, 25, min_cos);
        EXPECT_EQ(points_on_shape(index, s, {25, min_cos}).size(), wanted);
        EXPECT_GE(bound_shape(index, s, {25, min_cos}), wanted);
      }
    }
  }
  const auto unit = scene(20000);
  const auto index = build_shape_index(unit.view(), test::all_of(unit.size));
  const Shape s{ShapeKind::kPlane, {3000, 3000, 3000}, {0, 0, 1}};
  EXPECT_LT(bound_shape(index, s, {25, 0.95}), bound_shape(index, s, {25, 0}) / 2);
}

TEST(ShapeScore, AnEmptyIndexHasNoPoints) {
  const auto index = build_shape_index({}, {});
  EXPECT_EQ(score_shape(index, shapes()[0], {25, 0.9}), 0u);
  EXPECT_EQ(bound_shape(index, shapes()[0], {25, 0.9}), 0u);
}

}  // namespace
}  // namespace ilot
