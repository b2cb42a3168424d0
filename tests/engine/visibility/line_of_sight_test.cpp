// SPDX-License-Identifier: Apache-2.0
#include "engine/visibility/line_of_sight.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

// A rectangle in the plane x = at.
SectionFace screen(double at, double y0, double y1, double z0, double z1) {
  return {{{{at, y0, z0}, {at, y1, z0}, {at, y1, z1}, {at, y0, z1}}}};
}

TEST(LineOfSight, StopsAtFacesAndPassesThroughHoles) {
  SectionFace wall = screen(5, 0, 10, 0, 4);
  wall.rings.push_back({{5, 2, 1}, {5, 3, 1}, {5, 3, 2}, {5, 2, 2}});
  const LineOfSight sight({wall});
  EXPECT_FALSE(sight.clear({0, 1, 1}, {9, 1, 1}));
  EXPECT_FALSE(sight.clear({9, 1, 1}, {0, 1, 1})) << "both sides block";
  EXPECT_TRUE(sight.clear({0, 2.5, 1.5}, {9, 2.5, 1.5})) << "the hole";
  EXPECT_TRUE(sight.clear({0, 1, 1}, {4.99, 1, 1})) << "ends before it";
  EXPECT_FALSE(sight.clear({0, 1, 1}, {5, 1, 1})) << "ends on it";
  EXPECT_TRUE(sight.clear({0, 1, 5}, {9, 1, 5})) << "above it";
  EXPECT_TRUE(sight.clear({4, 0, 1}, {4, 9, 1})) << "along it";
  EXPECT_FALSE(sight.clear({0, 0.5, 0.5}, {9000, 0.5, 0.5})) << "however far";
  EXPECT_FALSE(sight.clear({5, 1, 1}, {5 + 1e-9, 1, 1})) << "a line without length to speak of";
}

TEST(LineOfSight, NothingIsInTheWayOfNothing) {
  EXPECT_TRUE(LineOfSight({}).clear({0, 0, 0}, {1, 0, 0}));
  const SectionFace line{{{{1, 0, 0}, {1, 1, 0}, {1, 2, 0}}}}, point{{{{1, 0, 0}}}}, none{};
  EXPECT_TRUE(LineOfSight({line, point, none}).clear({0, 0.5, 0}, {2, 0.5, 0}));
}

Vec3 random_place(Rng& rng, Vec3 at, double size) {
  const double x = rng.uniform(), y = rng.uniform(), z = rng.uniform();
  return at + Vec3{size * x, size * y, size * z};
}

// Triangles, whose crossing a signed volume tells.
bool crosses(Vec3 from, Vec3 to, const std::vector<Vec3>& t) {
  const auto volume = [](Vec3 a, Vec3 b, Vec3 c, Vec3 d) { return dot(cross(b - a, c - a), d - a); };
  if ((volume(t[0], t[1], t[2], from) > 0) == (volume(t[0], t[1], t[2], to) > 0)) return false;
  const bool a = volume(from, to, t[0], t[1]) > 0, b = volume(from, to, t[1], t[2]) > 0,
             c = volume(from, to, t[2], t[0]) > 0;
  return a == b && b == c;
}

TEST(LineOfSight, AgreesWithBruteForceHereAndFarAway) {
  for (const Vec3 at : {Vec3{0, 0, 0}, Vec3{652000, 6862000, 40}}) {
    Rng rng(3);
    std::vector<SectionFace> faces;
    for (int i = 0; i < 300; ++i) {
      const Vec3 a = random_place(rng, at, 20);
      faces.push_back({{{a, random_place(rng, a, 1.5), random_place(rng, a, 1.5)}}});
    }
    const LineOfSight sight(faces);
    int blocked = 0;
    for (int i = 0; i < 2000; ++i) {
      const Vec3 from = random_place(rng, at - Vec3{20, 20, 20}, 60), to = random_place(rng, at, 20);
      bool clear = true;
      for (const SectionFace& f : faces)
        clear &= !crosses(from - at, to - at, {f.rings[0][0] - at, f.rings[0][1] - at, f.rings[0][2] - at});
      blocked += !clear;
      ASSERT_EQ(sight.clear(from, to), clear) << i;
    }
    EXPECT_GT(blocked, 150);
    EXPECT_LT(blocked, 1900);
  }
}

TEST(LineOfSight, SeveralThreadsMayAsk) {
  std::vector<SectionFace> faces;
  for (int i = 0; i < 64; ++i) faces.push_back(screen(1 + i, 0, 1 + 0.1 * i, 0, 1));
  const LineOfSight sight(faces);
  std::vector<std::uint8_t> clear(4000);
  with_threads(3, [&] {
    parallel_for(clear.size(), [&](std::size_t i) {
      const double y = 8.0 * static_cast<double>(i) / static_cast<double>(clear.size());
      clear[i] = sight.clear({0, y, 0.5}, {100, y, 0.5});
    });
  });
  for (std::size_t i = 0; i < clear.size(); ++i)
    EXPECT_EQ(clear[i] != 0, 8.0 * static_cast<double>(i) / static_cast<double>(clear.size()) > 1 + 0.1 * 63) << i;
}

}  // namespace
}  // namespace ilot
