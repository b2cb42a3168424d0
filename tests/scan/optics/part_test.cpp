// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/part.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

Solid unit_cube() {
  return prism(std::array{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{1, 1, 0}, Vec3{0, 1, 0}}, {0, 0, 1}, 0);
}

Ray ray_to(Vec3 from, Vec3 to) {
  const Vec3 way = to - from;
  return {from, (1 / norm(way)) * way};
}

Vec3 random_place(Rng& rng, double reach) {
  return {reach * (2 * rng.uniform() - 1), reach * (2 * rng.uniform() - 1), reach * (2 * rng.uniform() - 1)};
}

TEST(Part, RaysMeetAPrismWhereTheyEnter) {
  const Part cube = unit_cube();
  const auto hit = meet({{0.5, 0.25, 3}, {0, 0, -1}}, cube, 0);
  ASSERT_TRUE(hit);
  EXPECT_DOUBLE_EQ(hit->t, 2);
  EXPECT_DOUBLE_EQ(hit->normal.z, 1);
  EXPECT_FALSE(meet({{0.5, 0.25, 3}, {0, 0, -1}}, cube, 2.5));  // inside by then
  EXPECT_FALSE(meet({{0.5, 0.25, 3}, {0, 0, 1}}, cube, 0));
  EXPECT_FALSE(meet({{1.5, 0.25, 3}, {0, 0, -1}}, cube, 0));
}

TEST(Part, FacesOfAPrismBearTheirOwnSurfaces) {
  Solid cube = unit_cube();
  for (std::uint32_t face = 0; face < 6; ++face) cube.surfaces[face] = face;
  const Vec3 middle{0.5, 0.5, 0.5};
  const std::array<Vec3, 6> sides{{{0, -1, 0}, {1, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, -1}, {0, 0, 1}}};
  for (std::uint32_t face = 0; face < 6; ++face) {
    const auto hit = meet(ray_to(middle + 5.0 * sides[face], middle), cube, 0);
    ASSERT_TRUE(hit);
    EXPECT_EQ(hit->surface, face);
    EXPECT_DOUBLE_EQ(hit->t, 4.5);
  }
}

// The same ring the other way round, or swept the other way, encloses the same space.
TEST(Part, APrismDoesNotDependOnTheOrientationOfItsRing) {
  const Part a = unit_cube();
  const Part b = prism(std::array{Vec3{0, 1, 1}, Vec3{1, 1, 1}, Vec3{1, 0, 1}, Vec3{0, 0, 1}}, {0, 0, -1}, 0);
  Rng rng(7);
  for (int i = 0; i < 2000; ++i) {
    const Ray ray = ray_to(random_place(rng, 4), random_place(rng, 1));
    const auto one = meet(ray, a, 0), other = meet(ray, b, 0);
    ASSERT_EQ(one.has_value(), other.has_value());
    if (!one) continue;
    EXPECT_NEAR(one->t, other->t, 1e-12);
  }
}

// Points met on quadrics satisfy the equation, and no point of the way before them lies inside.
TEST(Part, QuadricsAreMetOnTheirSurfaceAndNotBefore) {
  const Vec3 axis = (1 / norm(Vec3{1, 2, 3})) * Vec3{1, 2, 3};
  const Vec3 at{0.3, -0.2, 0.1};
  const std::array<Solid, 3> solids{cylinder(at, axis, 1.5, 0.4, 0), cone(at, axis, 0.2, 1.5, 0.5, 0),
                                    sphere(at, 0.7, 0)};
  const auto depth = [&](const Solid& solid, Vec3 p) {  // positive outside
    const Quadric& q = solid.quadric;
    const Vec3 offset = p - q.point;
    const double height = dot(offset, q.axis), radial = norm(offset - height * q.axis);
    double outside = q.kind == Quadric::Kind::sphere ? norm(offset) - q.radius
                     : q.kind == Quadric::Kind::cone ? radial - q.tangent * height
                                                     : radial - q.radius;
    for (std::uint32_t i = 0; i < solid.plane_count; ++i)
      outside = std::max(outside, signed_distance(solid.planes[i], p));
    return outside;
  };
  Rng rng(3);
  for (const Solid& solid : solids) {
    int met = 0;
    for (int i = 0; i < 4000; ++i) {
      const Ray ray = ray_to(random_place(rng, 5), random_place(rng, 1));
      if (depth(solid, ray.origin) <= 0) continue;
      const auto hit = meet(ray, solid, 0);
      met += hit.has_value();
      const double end = hit ? hit->t : 20;
      for (int step = 0; step < 40; ++step) ASSERT_GT(depth(solid, point_at(ray, end * step / 40)), -1e-9);
      if (!hit) continue;
      EXPECT_NEAR(depth(solid, point_at(ray, hit->t)), 0, 1e-9);
      EXPECT_LT(dot(hit->normal, ray.direction), 0);
    }
    EXPECT_GT(met, 500);
  }
}

TEST(Part, BoundsHoldWhatIsMet) {
  const Vec3 axis = (1 / norm(Vec3{-2, 1, 2})) * Vec3{-2, 1, 2};
  const std::array<Part, 4> parts{cylinder({0, 0, 0}, axis, 1, 0.3, 0), cone({0, 0, 0}, axis, 0, 1, 0.8, 0),
                                  sphere({0.1, 0, 0}, 0.6, 0), unit_cube()};
  Rng rng(5);
  for (const Part& part : parts) {
    const Box3<Vec3> box = bounds_of(part);
    for (int i = 0; i < 2000; ++i) {
      const Ray ray = ray_to(random_place(rng, 4), random_place(rng, 1));
      const auto hit = meet(ray, part, 0);
      if (!hit) continue;
      const Vec3 p = point_at(ray, hit->t);
      EXPECT_GE(p.x, box.min.x - 1e-9);
      EXPECT_GE(p.y, box.min.y - 1e-9);
      EXPECT_GE(p.z, box.min.z - 1e-9);
      EXPECT_LE(p.x, box.max.x + 1e-9);
      EXPECT_LE(p.y, box.max.y + 1e-9);
      EXPECT_LE(p.z, box.max.z + 1e-9);
    }
  }
}

TEST(Part, PanelsAreOpenWhereTheirOpeningsAre) {
  Panel panel{{0, 0, 0}, {1, 0, 0}, {0, 0, 1}, {{0, 0}, {4, 0}, {4, 3}, {0, 3}}, {}, 7};
  panel.openings.push_back({1, 2, 1, 2, 0.5});      // a round head: crown at 2.5
  panel.openings.push_back({2.5, 3.5, 0.5, 2, 0});  // square
  const auto met = [&](double x, double z) { return meet({{x, -5, z}, {0, 1, 0}}, Part(panel), 0).has_value(); };
  EXPECT_TRUE(met(0.5, 1.5));
  EXPECT_FALSE(met(1.5, 1.5));
  EXPECT_FALSE(met(1.5, 2.49));
  EXPECT_TRUE(met(1.5, 2.51));
  EXPECT_TRUE(met(1.05, 2.4));  // beside the arch
  EXPECT_FALSE(met(3, 1.99));
  EXPECT_TRUE(met(3, 2.01));
  EXPECT_FALSE(met(4.5, 1));
  EXPECT_DOUBLE_EQ(meet({{0.5, -5, 0.5}, {0, 1, 0}}, Part(panel), 0)->t, 5);
  EXPECT_DOUBLE_EQ(meet({{0.5, 5, 0.5}, {0, -1, 0}}, Part(panel), 0)->normal.y, 1);  // from behind
}

TEST(Part, ArchesHaveTheRadiusOfTheirRise) {
  EXPECT_DOUBLE_EQ(arch_radius({0, 2, 0, 1, 1}), 1);
  EXPECT_DOUBLE_EQ(arch_radius({0, 6, 0, 1, 1}), 5);  // 3-4-5
}

TEST(Part, ShellsAreMetFromInside) {
  const Shell vault{
      {Quadric::Kind::cylinder, {0, 0, 0}, {0, 1, 0}, 1, 0}, {Plane{{0, 0, -1}, 0}}, 3, {{-1, -1, 0}, {1, 1, 1}}};
  const auto up = meet({{0, 0, -2}, {0, 0, 1}}, Part(vault), 0);
  ASSERT_TRUE(up);  // the lower half is clipped away
  EXPECT_DOUBLE_EQ(up->t, 3);
  EXPECT_DOUBLE_EQ(up->normal.z, -1);
}

// A wall of boxes beside each other has no gaps: rays aimed at the very joints never pass.
TEST(Part, NoRaySlipsBetweenBoxesThatShareAFace) {
  const auto box = [](double x0, double x1) {
    return Part(prism(std::array{Vec3{x0, 0, 0}, Vec3{x1, 0, 0}, Vec3{x1, 0.3, 0}, Vec3{x0, 0.3, 0}}, {0, 0, 3}, 0));
  };
  const std::array<Part, 3> wall{box(0, 1.1), box(1.1, 2.3), box(2.3, 4)};
  Rng rng(9);
  for (int i = 0; i < 20000; ++i) {
    const double joint = i % 2 ? 1.1 : 2.3;
    const Ray ray = ray_to({4 * rng.uniform(), -1 - 5 * rng.uniform(), 3 * rng.uniform()}, {joint, 0, 1.5});
    EXPECT_TRUE(meet(ray, wall[0], 0) || meet(ray, wall[1], 0) || meet(ray, wall[2], 0));
  }
}

TEST(Part, CutKeepsTheSurfacesOfTheOtherFaces) {
  Solid ball = sphere({0, 0, 0}, 1, 1);
  cut(ball, {{0, 0, 1}, 0}, 2);  // the lower half
  const auto top = meet({{0.2, 0, 5}, {0, 0, -1}}, Part(ball), 0),
             bottom = meet({{0.2, 0, -5}, {0, 0, 1}}, Part(ball), 0);
  ASSERT_TRUE(top && bottom);
  EXPECT_DOUBLE_EQ(top->t, 5);
  EXPECT_EQ(top->surface, 2u);
  EXPECT_EQ(bottom->surface, 1u);
}

// Facets around one corner: a ray through the corner or a common edge meets one of them at least.
TEST(Part, NoRayPassesBetweenFacets) {
  Rng rng(11);
  for (int round = 0; round < 200; ++round) {
    std::vector<Vec3> rim;
    for (int i = 0; i < 6; ++i) {
      const double angle = 1.0471975 * i;
      rim.push_back({std::cos(angle), std::sin(angle), 0.3 * rng.uniform()});
    }
    const Vec3 centre = 0.01 * random_place(rng, 1);
    std::vector<Part> parts;
    for (std::size_t i = 0; i < 6; ++i) parts.push_back(*facet(centre, rim[i], rim[(i + 1) % 6], 0));
    for (int k = 0; k < 50; ++k) {
      const Vec3 edge = centre + (k % 10 / 10.0) * (rim[static_cast<std::size_t>(k) % 6] - centre);
      const Ray ray = ray_to(edge + Vec3{rng.uniform(), rng.uniform(), 3}, edge);
      EXPECT_TRUE(std::any_of(parts.begin(), parts.end(), [&](const Part& p) { return meet(ray, p, 0).has_value(); }));
    }
  }
}

TEST(Part, FacetsAreSeenFromBothSides) {
  const Part triangle = *facet({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, 7);
  for (const double side : {1.0, -1.0}) {
    const auto hit = meet({{0.2, 0.3, 2 * side}, {0, 0, -side}}, triangle, 0);
    ASSERT_TRUE(hit);
    EXPECT_DOUBLE_EQ(hit->t, 2);
    EXPECT_DOUBLE_EQ(hit->normal.z, side);
    EXPECT_EQ(hit->surface, 7u);
    EXPECT_FALSE(meet({{0.6, 0.6, 2 * side}, {0, 0, -side}}, triangle, 0));
    EXPECT_FALSE(meet({{0.2, 0.3, 2 * side}, {0, 0, side}}, triangle, 0));
  }
  EXPECT_FALSE(facet({0, 0, 0}, {1, 1, 1}, {2, 2, 2}, 0));
}

}  // namespace
}  // namespace ilot::scan
