// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_score.h"

#include <array>
#include <cmath>
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

// The arguments of the bodies for a shape that is prepared as score_shape does.
struct BodyArgs {
  std::vector<const float*> balls;
  std::array<float, 9> shape{};
  simd::ShapeArgs args{};

  BodyArgs(const ShapeIndex& index, const Shape& s) {
    for (const auto& level : index.balls) balls.push_back(level.data());
    Vec3 origin = s.origin;
    const double along = dot(index.centre - origin, s.axis);
    if (s.kind == ShapeKind::kPlane) origin = index.centre - along * s.axis;
    if (s.kind == ShapeKind::kCylinder) origin = origin + along * s.axis;
    const auto f = [](double v) { return static_cast<float>(v); };
    shape = {f(origin.x), f(origin.y), f(origin.z), f(s.axis.x), f(s.axis.y),
             f(s.axis.z), f(s.radius), f(s.sine),   f(s.cosine)};
    args.x = index.x.data(), args.y = index.y.data(), args.z = index.z.data();
    args.nx = index.nx.data(), args.ny = index.ny.data(), args.nz = index.nz.data();
    args.balls = balls.data();
    args.levels = static_cast<int>(balls.size());
    args.groups = static_cast<std::uint32_t>((index.in_leaf.size() + 7) / 8);
    args.cones = index.cones.data();
    args.shape = shape.data();
    args.kind = static_cast<int>(s.kind);
    args.max_distance = 25, args.min_cos = 0.9f, args.slack = 1;
    const double cosine = 0.9 - 0.001;
    args.angle_cosine = f(cosine), args.angle_sine = f(std::sqrt(1 - cosine * cosine));
    args.cosine_rounding = 0.001f;
  }
  BodyArgs(const BodyArgs&) = delete;
};

// Passing balls over changes nothing: the same count with every leaf looked at, and with one level of balls. And for
// every instruction set, down to the list of leaves.
TEST(ShapeScore, CullingAndInstructionSetsDoNotShow) {
  const auto set = scene(10007);
  auto index = build_shape_index(set.view(), test::all_of(set.size));
  std::vector<std::uint32_t> holes;
  for (std::uint32_t i = 0; i < index.size; i += 3) holes.push_back(i);
  take_out(index, holes);
  ASSERT_GT(index.balls.size(), 1u);
  std::vector<std::uint32_t> every(index.in_leaf.size());
  std::iota(every.begin(), every.end(), 0u);
  for (const Shape& s : shapes()) {
    const std::uint32_t counted = score_shape(index, s, {25, 0.9});
    BodyArgs body(index, s);
    simd::ShapeArgs& args = body.args;
    std::vector<std::uint32_t> first;  // leaves that were listed first
    for (const simd::Isa isa : simd::kIsas) {
      if (!simd::has_isa(isa)) continue;
      const simd::ShapeScoreBody& bodies = simd::kShapeScore.of(isa);
      for (const int levels : {static_cast<int>(index.balls.size()), 1}) {
        std::vector<std::uint32_t> leaves(every.size() + 8);
        args.levels = levels;
        args.leaves = leaves.data();
        args.leaf_count = bodies.shape_leaves(args);
        EXPECT_EQ(bodies.shape_hits(args), counted) << simd::name_of(isa) << " levels " << levels;
        leaves.resize(args.leaf_count);
        if (first.empty()) first = leaves;
        EXPECT_EQ(leaves, first) << simd::name_of(isa) << " levels " << levels;
      }
      args.leaves = every.data();
      args.leaf_count = static_cast<std::uint32_t>(every.size());
      EXPECT_EQ(bodies.shape_hits(args), counted) << simd::name_of(isa);
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

// All points of every second leaf go, those of the others stay.
TEST(ShapeScore, RecountingIsCountingWhereWholeLeavesGo) {
  const auto set = scene(20000);
  auto index = build_shape_index(set.view(), test::all_of(set.size));
  const ShapeScoreParams params{25, 0.9};
  std::vector<ShapeCount> known;
  for (const Shape& s : shapes()) known.push_back({score_shape(index, s, params), index.epoch});
  std::vector<std::uint32_t> gone;
  for (std::uint32_t i = 0; i < index.size; ++i)
    if (i / ShapeIndex::kLeaf % 2 == 0) gone.push_back(i);
  take_out(index, gone);
  for (std::size_t leaf = 0; leaf + 1 < index.in_leaf.size(); ++leaf)
    ASSERT_EQ(index.in_leaf[leaf], leaf % 2 == 0 ? 0u : ShapeIndex::kLeaf);
  for (std::size_t s = 0; s < known.size(); ++s) {
    const std::uint32_t counted = score_shape(index, shapes()[s], params);
    const bool fewer = counted<known[s].points, any = known[s].points> 0;
    EXPECT_EQ(fewer, any);
    EXPECT_EQ(recount_shape(index, shapes()[s], params, known[s], 0), counted);
  }
}

// Removals of a few points fill a leaf each. The list begins anew before it has more leaves than the index, and where
// points are not listed; counts from before are made anew then.
TEST(ShapeScore, RecountingIsCountingWhereTheListOfRemovedPointsBeganAnew) {
  const auto set = scene(5000);
  auto index = build_shape_index(set.view(), test::all_of(set.size));
  const ShapeScoreParams params{25, 0.9};
  const Shape s = shapes()[1];
  std::vector<ShapeCount> known;
  std::size_t anew = 0, subtracted = 0;
  for (std::uint32_t at = 0; at + 3 <= index.size; at += 12) {
    known.push_back({score_shape(index, s, params), index.epoch});
    const std::array<std::uint32_t, 3> gone{at, at + 1, at + 2};
    take_out(index, gone, at % 1200 != 600);
    ASSERT_LE(index.removed.epoch.size(), index.in_leaf.size());
    const std::uint32_t counted = score_shape(index, s, params);
    for (std::size_t k = 0; k < known.size(); k += 29) {
      EXPECT_EQ(recount_shape(index, s, params, known[k], 0), counted);
      ++(known[k].epoch < index.built ? anew : subtracted);
    }
  }
  EXPECT_GT(anew, 0u);
  EXPECT_GT(subtracted, 0u);
  EXPECT_LT(score_shape(index, s, params), known.front().points);
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

// A thin oblique sheet and a plane along it, beyond epsilon but within the balls of all leaves.
TEST(ShapeScore, LeavesBesideAPlaneAreLeftOut) {
  Rng rng(8);
  test::OrientedSetBuilder b(5);
  const Vec3 normal{0.6, 0, 0.8}, along{0.8, 0, -0.6}, across{0, 1, 0}, middle{3000, 3000, 3000};
  for (int i = 0; i < 5000; ++i)
    b.add(middle + (2000 * rng.uniform()) * along + (2000 * rng.uniform()) * across, normal);
  const auto set = b.build();
  const auto index = build_shape_index(set.view(), test::all_of(set.size));
  constexpr double kEpsilon = 3, kBeside = 10;
  const auto leaves = static_cast<std::uint32_t>(index.in_leaf.size());
  for (const double side : {-1.0, 1.0}) {
    const Shape beside{ShapeKind::kPlane, middle + side * kBeside * normal, normal};
    for (std::uint32_t leaf = 0; leaf < leaves; ++leaf) {
      const float* ball = index.balls[0].data() + leaf / 8 * 32 + leaf % 8;
      EXPECT_LT(std::abs(view_of(beside, {ball[0], ball[8], ball[16]}).distance), double{ball[24]} + kEpsilon);
    }
    EXPECT_EQ(bound_shape(index, beside, {kEpsilon, 0.9}), 0u);
    EXPECT_EQ(bound_shape(index, {ShapeKind::kPlane, middle + side * normal, normal}, {kEpsilon, 0.9}), index.size);
  }
}

TEST(ShapeScore, AnEmptyIndexHasNoPoints) {
  const auto index = build_shape_index({}, {});
  EXPECT_EQ(score_shape(index, shapes()[0], {25, 0.9}), 0u);
  EXPECT_EQ(bound_shape(index, shapes()[0], {25, 0.9}), 0u);
}

}  // namespace
}  // namespace ilot
