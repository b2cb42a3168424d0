// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_ransac.h"

#include "kernels/core/parallel.h"
#include "tests/support/segment_sets.h"
#include "tests/support/shape_sets.h"

namespace ilot {
namespace {

using test::kX, test::kY, test::kZ;
constexpr double kCos20 = 0.9396926207859084;

struct Truth {
  Shape shape;
  std::size_t points;
};

// A room in millimetres: floor and wall, columns, balls, funnels; noise of 2 mm; normals estimated from 16 neighbours.
struct Scene {
  test::OrientedSet set;
  std::vector<Truth> truth;
};

Scene make_scene(std::uint64_t key) {
  test::OrientedSetBuilder b(key);
  Rng rng(key, 1);
  Scene scene;
  const auto add = [&](const Shape& s, int n, double arc, double from, double to) {
    test::add_shape(b, rng, s, n, arc, from, to, 2);
    scene.truth.push_back({s, static_cast<std::size_t>(n)});
  };
  const double step = 25;
  b.add(test::Patch{{1000, 1000, 1000}, kX, kY, 160, 120, step, 2});  // 4 m x 3 m
  scene.truth.push_back({{ShapeKind::kPlane, {1000, 1000, 1000}, kZ}, 160 * 120});
  b.add(test::Patch{{1000, 4100, 1200}, kX, kZ, 160, 60, step, 2});
  scene.truth.push_back({{ShapeKind::kPlane, {1000, 4100, 1000}, kY}, 160 * 60});
  add(test::cylinder({1600, 1600, 1100}, kZ, 200), 5000, 1, 0, 1800);
  add(test::cylinder({3000, 1800, 1500}, {1, 0.3, 0.2}, 120), 2500, 0.6, 0, 1200);
  add(test::sphere({2400, 3000, 1700}, 400), 4000, 1, -1, 1);
  add(test::sphere({4200, 3300, 1400}, 150), 1200, 1, -0.4, 1);
  add(test::cone({3600, 1500, 2600}, {0, 0.1, -1}, 0.35), 3500, 1, 300, 1400);
  add(test::cone({1800, 3300, 2800}, {0.2, 0, -1}, 0.6), 2500, 0.7, 150, 700);
  scene.set = test::with_estimated_normals(b.build(), 16);
  return scene;
}

ShapeRansacParams scene_params(std::uint64_t key) {
  ShapeRansacParams p;
  p.epsilon = 8;
  p.min_cos = kCos20;
  p.connectivity = 120;
  p.min_points = 500;
  p.key = key;
  return p;
}

// Within 1% or 5 mm: radius, and where the axis or the centre lies; angles within half a degree.
bool same_shape(const Shape& got, const Shape& wanted, double at) {
  if (got.kind != wanted.kind) return false;
  const auto close = [](double a, double b) { return std::abs(a - b) <= std::max(5.0, 0.01 * std::abs(b)); };
  constexpr double kCosHalf = 0.99996;
  const double agree = std::abs(dot(got.axis, wanted.axis));
  switch (got.kind) {
    case ShapeKind::kPlane:
      return agree > kCosHalf && std::abs(view_of(got, wanted.origin).distance) <= 5;
    case ShapeKind::kSphere:
      return norm(got.origin - wanted.origin) <= 5 && close(got.radius, wanted.radius);
    case ShapeKind::kCylinder: {
      const Vec3 v = wanted.origin + at * wanted.axis - got.origin;
      return agree > kCosHalf && norm(v - dot(v, got.axis) * got.axis) <= 5 && close(got.radius, wanted.radius);
    }
    default:
      return agree > kCosHalf && std::abs(got.sine - wanted.sine) <= 0.01 &&
             norm(got.origin - wanted.origin) <= std::max(5.0, 0.01 * at);
  }
}

void expect_sound_shapes(const test::OrientedSet& set, const ShapeRansacParams& params, const ShapeSegments& found) {
  ASSERT_EQ(found.label.size(), set.size);
  std::vector<std::size_t> count(found.shapes.size() + 1, 0);
  for (std::size_t i = 0; i < set.size; ++i) {
    ASSERT_LE(found.label[i], found.shapes.size());
    ++count[found.label[i]];
    if (found.label[i] == 0) continue;
    const ShapeView v = view_of(found.shapes[found.label[i] - 1].shape, set.position(i));
    ASSERT_LE(std::abs(v.distance), params.epsilon);
    ASSERT_GE(std::abs(dot(v.normal, set.normal(i))), params.min_cos);
  }
  for (std::size_t s = 1; s < count.size(); ++s) {
    EXPECT_GE(count[s], params.min_points);
    EXPECT_EQ(count[s], found.shapes[s - 1].points);
    EXPECT_LE(found.shapes[s - 1].rms, params.epsilon);
  }
}

TEST(ShapeRansac, EveryShapeOfARoomIsFoundWithItsParameters) {
  for (const std::uint64_t key : {1, 2, 3}) {
    const Scene scene = make_scene(key);
    const auto found = ransac_shapes(scene.set.view(), scene_params(key));
    expect_sound_shapes(scene.set, scene_params(key), found);
    EXPECT_EQ(found.shapes.size(), scene.truth.size()) << "key " << key;
    for (std::size_t t = 0; t < scene.truth.size(); ++t) {
      const auto hit = std::find_if(found.shapes.begin(), found.shapes.end(), [&](const FoundShape& f) {
        return same_shape(f.shape, scene.truth[t].shape, 800) &&
               f.points > 0.9 * static_cast<double>(scene.truth[t].points);
      });
      EXPECT_NE(hit, found.shapes.end()) << "key " << key << ", shape " << t;
    }
    if (::testing::Test::HasFailure()) {
      for (const FoundShape& f : found.shapes)
        std::printf("kind %d at %.1f %.1f %.1f axis %.4f %.4f %.4f r %.1f sine %.3f: %u points, rms %.2f\n",
                    static_cast<int>(f.shape.kind), f.shape.origin.x, f.shape.origin.y, f.shape.origin.z,
                    f.shape.axis.x, f.shape.axis.y, f.shape.axis.z, f.shape.radius, f.shape.sine, f.points, f.rms);
    }
  }
}

// Four metres in steps of a quarter of a micrometre are more than a Morton code can tell.
TEST(ShapeRansac, FineUnitsHaveTheSameShapes) {
  constexpr float kFiner = 4096;
  Scene scene = make_scene(7);
  ShapeRansacParams params = scene_params(7);
  const auto coarse = ransac_shapes(scene.set.view(), params);
  for (auto* axis : {&scene.set.x, &scene.set.y, &scene.set.z})
    for (float& value : *axis) value *= kFiner;
  params.epsilon *= kFiner;
  params.connectivity *= kFiner;
  const auto fine = ransac_shapes(scene.set.view(), params);
  expect_sound_shapes(scene.set, params, fine);
  EXPECT_EQ(fine.shapes.size(), coarse.shapes.size());
  EXPECT_EQ(fine.shapes.size(), scene.truth.size());
}

TEST(ShapeRansac, OrderAndThreadsDoNotMatter) {
  const Scene scene = make_scene(4);
  const auto once = ransac_shapes(scene.set.view(), scene_params(4));
  for (const int threads : {1, 3}) {
    with_threads(threads, [&] {
      const auto again = ransac_shapes(scene.set.view(), scene_params(4));
      EXPECT_EQ(again.label, once.label);
    });
  }
  const auto mixed = test::shuffled(scene.set, 9);
  const auto other = ransac_shapes(mixed.set.view(), scene_params(4));
  ASSERT_EQ(other.shapes.size(), once.shapes.size());
  EXPECT_EQ(test::in_original_order(mixed, other.label), once.label);  // no two points coincide in this scene
}

TEST(ShapeRansac, ARotatedRoomHasTheSameShapes) {
  const Scene scene = make_scene(5);
  // A rotation by a third of a turn about (1, 1, 1) is exact: x, y, z change places.
  test::OrientedSet turned = scene.set;
  std::swap(turned.x, turned.y);
  std::swap(turned.y, turned.z);
  std::swap(turned.nx, turned.ny);
  std::swap(turned.ny, turned.nz);
  const auto turn = [](Vec3 v) { return Vec3{v.y, v.z, v.x}; };
  const auto found = ransac_shapes(turned.view(), scene_params(5));
  expect_sound_shapes(turned, scene_params(5), found);
  EXPECT_EQ(found.shapes.size(), scene.truth.size());
  for (const Truth& t : scene.truth) {
    Shape wanted = t.shape;
    wanted.origin = turn(wanted.origin);
    wanted.axis = turn(wanted.axis);
    EXPECT_TRUE(std::any_of(found.shapes.begin(), found.shapes.end(),
                            [&](const FoundShape& f) { return same_shape(f.shape, wanted, 800); }));
  }
}

TEST(ShapeRansac, OnlyTheKindsAskedFor) {
  const Scene scene = make_scene(6);
  ShapeRansacParams params = scene_params(6);
  params.kinds = shape_bit(ShapeKind::kPlane);
  for (const FoundShape& f : ransac_shapes(scene.set.view(), params).shapes) EXPECT_EQ(f.shape.kind, ShapeKind::kPlane);
  params = scene_params(6);
  params.max_radius = 250;
  for (const FoundShape& f : ransac_shapes(scene.set.view(), params).shapes) EXPECT_LE(f.shape.radius, 250);
}

// 200,000 points: candidates are counted on a sample, labels reach all.
TEST(ShapeRansac, LargeSetsAreSearchedOnAShareOfTheirPoints) {
  test::OrientedSetBuilder b(1);
  b.add(test::Patch{{100, 100, 100}, kX, kY, 500, 300, 10, 1});
  Rng rng(2);
  test::add_shape(b, rng, test::sphere({2000, 1500, 900}, 600), 50000, 1, -1, 1, 1);
  const auto set = b.build();
  ShapeRansacParams params = scene_params(1);
  params.epsilon = 5;
  params.connectivity = 50;
  const auto found = ransac_shapes(set.view(), params);
  expect_sound_shapes(set, params, found);
  ASSERT_EQ(found.shapes.size(), 2u);
  EXPECT_GT(found.shapes[0].points, 149000u);
  EXPECT_GT(found.shapes[1].points, 49000u);
  EXPECT_TRUE(same_shape(found.shapes[1].shape, test::sphere({2000, 1500, 900}, 600), 0));
}

TEST(ShapeRansac, DegenerateInputHasNoShapes) {
  EXPECT_TRUE(ransac_shapes({}, scene_params(1)).shapes.empty());
  for (const int n : {1, 2, 600}) {
    test::OrientedSetBuilder line(7), place(8), bare(9);
    for (int i = 0; i < n; ++i) {
      line.add({100 + 9.0 * i, 100 + 3.0 * i, 5}, kZ);
      place.add({100, 100, 5}, kZ);
      bare.add({100.0 + i % 30, 100.0 + i / 30, 5}, Vec3{});
    }
    for (const auto& set : {line.build(), place.build(), bare.build()}) {
      const auto found = ransac_shapes(set.view(), scene_params(1));
      EXPECT_TRUE(found.shapes.empty()) << n;
      EXPECT_EQ(found.label, std::vector<std::uint32_t>(static_cast<std::size_t>(n), 0));
    }
  }
}

}  // namespace
}  // namespace ilot
