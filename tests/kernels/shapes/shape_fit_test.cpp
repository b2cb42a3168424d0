// SPDX-License-Identifier: Apache-2.0
#include "kernels/shapes/shape_fit.h"

#include "tests/support/segment_sets.h"
#include "tests/support/shape_sets.h"

namespace ilot {
namespace {

test::OrientedSet points_of(const Shape& s, int n, double noise, std::uint64_t key) {
  test::OrientedSetBuilder b(key);
  Rng rng(key);
  const bool ball = s.kind == ShapeKind::kSphere;
  test::add_shape(b, rng, s, n, 0.6, ball ? -0.9 : 200, ball ? 0.9 : 2000, noise);
  return b.build();
}

Shape disturbed(Shape s, double by) {
  s.origin = s.origin + by * Vec3{30, -40, 20};
  s.axis = s.axis + by * Vec3{0.05, 0.03, -0.04};
  s.axis = (1 / norm(s.axis)) * s.axis;
  s.radius *= 1 + 0.1 * by;
  const double sine = s.sine + (s.sine > 0 ? 0.05 * by : 0);
  const double length = std::sqrt(sine * sine + s.cosine * s.cosine);
  s.sine = sine / length;
  s.cosine /= length;
  return s;
}

// Noise of sigma leaves each parameter with an error of a few sigma / sqrt(n): 2 mm and 3,000 points, 0.04 mm times the
// lever of an arc of 216 degrees. 1 mm and 0.001 are far above it, and the lattice rounds by 0.3 mm at random.
TEST(ShapeFit, FindsTheParametersFromARoughStart) {
  const Shape wanted[]{test::sphere({3000, 3000, 3000}, 700), test::cylinder({2500, 2500, 2500}, {1, 2, 3}, 300),
                       test::cone({2500, 2500, 2500}, {2, 1, 3}, 0.4)};
  for (const Shape& w : wanted) {
    const auto set = points_of(w, 3000, 2, 5);
    const auto fit = fit_shape(set.view().points, test::all_of(set.size), disturbed(w, 1));
    ASSERT_TRUE(fit.valid);
    EXPECT_NEAR(fit.rms, 2, 0.15);
    EXPECT_NEAR(fit.shape.radius, w.radius, 1);
    EXPECT_NEAR(fit.shape.sine, w.sine, 0.001);
    const Vec3 off = w.origin - fit.shape.origin;
    const bool round = w.kind == ShapeKind::kCylinder;
    EXPECT_LT(norm(round ? off - dot(off, fit.shape.axis) * fit.shape.axis : off), round ? 1 : 2);
    if (w.kind != ShapeKind::kSphere) {
      EXPECT_GT(dot(fit.shape.axis, w.axis), 1 - 1e-6);
    }
  }
}

// Nothing near by fits better: distances are least squares.
TEST(ShapeFit, NoNeighbouringShapeIsCloser) {
  const Shape wanted[]{test::sphere({3000, 3000, 3000}, 700), test::cylinder({2500, 2500, 2500}, {1, 2, 3}, 300),
                       test::cone({2500, 2500, 2500}, {2, 1, 3}, 0.4)};
  for (const Shape& w : wanted) {
    const auto set = points_of(w, 1000, 5, 7);
    const auto fit = fit_shape(set.view().points, test::all_of(set.size), disturbed(w, 0.5));
    const auto error = [&](const Shape& s) {
      double sum = 0;
      for (std::size_t i = 0; i < set.size; ++i) sum += std::pow(view_of(s, set.position(i)).distance, 2);
      return sum;
    };
    const double least = error(fit.shape);
    for (const double by : {0.02, -0.02}) EXPECT_GT(error(disturbed(fit.shape, by)), least);
    Shape wider = fit.shape;
    wider.radius += 0.5;
    wider.origin = wider.origin + Vec3{0.5, 0, 0};
    EXPECT_GT(error(wider), least);
  }
}

TEST(ShapeFit, SameBitsEveryTimeAndForPlanesTheMoments) {
  const auto set = points_of(test::sphere({3000, 3000, 3000}, 700), 500, 2, 8);
  const auto a = fit_shape(set.view().points, test::all_of(set.size), test::sphere({3010, 3000, 2990}, 690));
  const auto b = fit_shape(set.view().points, test::all_of(set.size), test::sphere({3010, 3000, 2990}, 690));
  EXPECT_EQ(a.shape.radius, b.shape.radius);
  EXPECT_EQ(a.shape.origin.x, b.shape.origin.x);
  const auto corner = test::make_set("corner", {{0, 0, 5}, {9, 0, 5}, {0, 9, 5}, {9, 9, 5}});
  const auto plane = fit_shape(corner.view(), test::all_of(4), {});
  ASSERT_TRUE(plane.valid);
  EXPECT_NEAR(plane_of(plane.shape).d, -5, 1e-12);
}

TEST(ShapeFit, TooFewOrUselessPointsAreSaid) {
  const auto line = test::point_sets(50)[3];
  for (int k = 0; k < kShapeKinds; ++k) {
    Shape start{static_cast<ShapeKind>(k), {0, 0, 0}, {0, 0, 1}, 10, 0.6, 0.8};
    EXPECT_FALSE(fit_shape(line.view(), {}, start).valid);
    EXPECT_FALSE(fit_shape(line.view(), test::all_of(2), start).valid);
    const auto fit = fit_shape(line.view(), test::all_of(50), start);  // must end, whatever it says
    EXPECT_LE(fit.iterations, 30);
  }
}

}  // namespace
}  // namespace ilot
