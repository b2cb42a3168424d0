// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/side_faces.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/support/sampled_site.h"

namespace ilot {
namespace {

using test::SampledSite;

double volume(const FacadeBody& body) {
  double sum = 0;
  for (const auto& face : body.faces)
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
      sum += dot(body.vertices[face[0]], cross(body.vertices[face[i]], body.vertices[face[i + 1]])) / 6;
  return sum;
}

// Each edge is run through once in either direction.
bool is_closed(const FacadeBody& body) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> edges;
  for (const auto& face : body.faces)
    for (std::size_t i = 0; i < face.size(); ++i) ++edges[{face[i], face[(i + 1) % face.size()]}];
  for (const auto& [edge, count] : edges)
    if (count != 1 || !edges.contains({edge.second, edge.first})) return false;
  return true;
}

FacadeSite plain() {
  FacadeSite site;
  site.axes = {{10, 20, 30}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}};
  return site;
}

TEST(BodyBetween, IsClosedAndTurnsOutwardsOutAndIn) {
  constexpr double frustum = 1.0 * 2 * 3;  // 4 by 2 to 2 by 2 over 1: 3 wide in the mean
  for (const double depth : {1.0, -1.0}) {
    const FacadeBody body = body_between(plain(), {0, 4, 0, 2}, 0, {1, 3, 0, 2}, depth);
    EXPECT_EQ(body.vertices.size(), 8u);
    EXPECT_EQ(body.faces.size(), 6u);
    EXPECT_TRUE(is_closed(body));
    EXPECT_NEAR(volume(body), frustum, 1e-9) << depth;
  }
}

TEST(BodyBetween, AnEndWithoutWidthIsAnEdge) {
  for (const double depth : {1.0, -1.0}) {
    const FacadeBody wedge = body_between(plain(), {0, 1, 0, 3}, 0, {1, 1, 0, 3}, depth);
    EXPECT_EQ(wedge.vertices.size(), 6u);
    EXPECT_EQ(wedge.faces.size(), 5u);
    EXPECT_TRUE(is_closed(wedge));
    EXPECT_NEAR(volume(wedge), 1.5, 1e-9);
    const FacadeBody roof = body_between(plain(), {0, 4, 0, 2}, 0, {0, 4, 1, 1}, depth);
    EXPECT_TRUE(is_closed(roof));
    EXPECT_NEAR(volume(roof), 4, 1e-9);
    const FacadeBody peak = body_between(plain(), {0, 1, 0, 1}, 0, {0.5, 0.5, 0.5, 0.5}, depth);
    EXPECT_EQ(peak.vertices.size(), 5u);
    EXPECT_TRUE(is_closed(peak));
    EXPECT_NEAR(volume(peak), 1 / 3.0, 1e-9);
  }
}

// Reveals that splay by 10 cm over 30 cm; the end is given 4 cm off, as slices tell it.
TEST(SideFaces, SplayedRevealsLeanAndStraightOnesDoNot) {
  SampledSite s(4, 4, 0.015, 0.002);
  s.wall_around(1, 2.2, 1, 2.5);
  s.face({1, 1, 0}, {0.1, 0, -0.3}, {0, 1.5, 0}, 2);
  s.face({2.2, 1, 0}, {0, 0, -0.3}, {0, 1.5, 0}, 3);
  const SideFaces faces = side_faces(RaySamples(s.site), {1.01, 2.19, 1, 2.5}, {1.14, 2.1, 1.02, 2.48}, -0.3);
  EXPECT_NEAR(faces.outline.u0, 1, 0.004);
  EXPECT_NEAR(faces.end.u0, 1.1, 0.004);
  EXPECT_NEAR(faces.outline.u1, 2.2, 0.004);
  EXPECT_NEAR(faces.end.u1, 2.2, 0.004);  // its face was seen: straight, though its end's points stop earlier
  EXPECT_EQ(faces.end.v0, 1);             // nothing was seen of these
  EXPECT_EQ(faces.end.v1, 2.5);
  EXPECT_GT(faces.points[3], 500u);
  EXPECT_EQ(faces.points[0], 0u);
}

}  // namespace
}  // namespace ilot
