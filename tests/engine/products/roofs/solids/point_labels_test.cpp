// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/point_labels.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

// A block of `sides` walls around the origin, 5 m high.
RoofModel round_block(int sides, double radius) {
  RoofModel model;
  Building& b = model.lod12;
  for (int i = 0; i < sides; ++i) {
    const double turn = 2 * 3.141592653589793 * i / sides;
    for (const double z : {0.0, 5.0}) b.vertices.push_back({radius * std::cos(turn), radius * std::sin(turn), z});
  }
  for (int i = 0; i < sides; ++i) {
    const auto at = [&](int n) { return static_cast<std::uint32_t>(2 * (n % sides)); };
    b.surfaces.push_back({SurfaceKind::wall, 0, {{at(i), at(i + 1), at(i + 1) + 1, at(i) + 1}}});
  }
  return model;
}

TEST(PointLabels, WallsAreFoundAsAmongAll) {
  RoofSite site;
  for (const double radius : {0.2, 6.0, 400.0}) {
    RoofModel model = round_block(40, radius);
    model.lod22 = model.lod12;
    const PointLabeller labeller(site, model, 1);
    Rng rng(3);
    int walls = 0;
    for (int i = 0; i < 4000; ++i) {
      const double turn = 7 * rng.uniform(), r = radius + rng.uniform() - 0.5, z = 7 * rng.uniform() - 1;
      const Vec3 p{r * std::cos(turn), r * std::sin(turn), z};
      double nearest = HUGE_VAL;
      for (const BuildingSurface& s : model.lod12.surfaces) {
        const Vec3 a = model.lod12.vertices[s.rings[0][0]], b = model.lod12.vertices[s.rings[0][1]];
        const Vec3 d = b - a;
        const double t = std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / (d.x * d.x + d.y * d.y), 0.0, 1.0);
        nearest = std::min(nearest, std::hypot(p.x - a.x - t * d.x, p.y - a.y - t * d.y));
      }
      if (std::abs(nearest - 0.3) < 1e-9 || std::abs(z - 5.3) < 1e-9) continue;
      const bool wall = nearest <= 0.3 && z <= 5.3;
      EXPECT_EQ(labeller.label(p, 0), wall ? PointLabel::wall : PointLabel::none) << p.x << " " << p.y << " " << z;
      EXPECT_EQ(labeller.label(p, 2), PointLabel::roof);
      walls += wall;
    }
    EXPECT_GT(walls, 500);
  }
}

TEST(PointLabels, OfALevelBlockAllElseIsRoof) {
  const RoofModel model = round_block(8, 10);
  const PointLabeller labeller({}, model, 1);
  EXPECT_EQ(labeller.label({0, 0, 5}, 0), PointLabel::roof);
  EXPECT_EQ(labeller.label({10, 0, 2}, 0), PointLabel::wall);
  EXPECT_EQ(PointLabeller({}, {}, 1).label({0, 0, 0}, 0), PointLabel::none);
}

}  // namespace
}  // namespace ilot
