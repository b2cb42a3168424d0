// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_section.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/error.h"
#include "tests/support/facades.h"

namespace ilot {
namespace {

// A wall 10 x 6 with a window 0.3 deep from 4 to 6, 2 to 4, and a sill 0.1 before it from 1.8 to 2.
Facade cut_facade() {
  FacadeElement window = drawn("window", wall_rectangle(4, 2, 6, 4));
  window.depth_m = -0.3;
  FacadeElement sill = drawn("sill", wall_rectangle(4, 1.8, 6, 2, -0.1));
  sill.depth_m = 0.1;
  return facade_of({window, sill, drawn("outline", wall_rectangle(0, 0, 10, 6))});
}

Drawing cut(const SectionPlane& plane, std::span<const FlatPoint> points = {}) {
  return section_drawing(cut_facade(), plane, facade_faces(cut_facade()), points, "here");
}

std::vector<DrawingLine> cuts_of(const Drawing& drawing) {
  std::vector<DrawingLine> lines;
  for (const DrawingLine& line : drawing.lines)
    if (line.role == DrawingRole::section && !line.is_sample) lines.push_back(line);
  return lines;
}

TEST(FacadeSection, ALevelOneShowsWallRevealAndPane) {
  const auto lines = cuts_of(cut(level_section(cut_facade(), 3)));
  ASSERT_EQ(lines.size(), 1u);  // one line from end to end
  ASSERT_EQ(lines[0].corners.size(), 8u - 2);
  double deepest = 0, width = 0;
  for (const DrawingCorner& c : lines[0].corners) {
    deepest = std::max(deepest, c.y);
    width = std::max(width, c.x);
  }
  EXPECT_NEAR(deepest, 0.3, 1e-9);  // into the wall is up
  EXPECT_NEAR(width, 10, 1e-9);
}

TEST(FacadeSection, AnUprightOneShowsTheSill) {
  const auto lines = cuts_of(cut(upright_section({5, -3, 0}, {5, 3, 0})));
  double front = 0;
  for (const DrawingLine& line : lines)
    for (const DrawingCorner& c : line.corners) front = std::max(front, 3 - c.x);
  EXPECT_NEAR(front, 0.1, 1e-9);
  double up = 0;
  for (const DrawingLine& line : lines)
    for (const DrawingCorner& c : line.corners) up = std::max(up, c.y);
  EXPECT_NEAR(up, 6, 1e-9);
  EXPECT_THROW(upright_section({5, 3, 0}, {5, 3, 9}), Error);
}

TEST(FacadeSection, WithoutAnOutlineTheWallIsTheRectangleAboutAll) {
  Facade facade = cut_facade();
  facade.elements.pop_back();
  const auto edges = cut_faces(facade_faces(facade), level_section(facade, 1.9));
  EXPECT_FALSE(edges.empty());
  EXPECT_TRUE(cut_faces(facade_faces(facade), level_section(facade, 5)).empty());
}

TEST(FacadeSection, PointsNearTheCutOneACell) {
  SectionPoints once(level_section(cut_facade(), 3), 0.01, 0.01), turned = once;
  std::vector<Vec3> points;
  for (int i = 0; i < 1000; ++i) points.push_back({i * 0.001 + 0.0005, -0.0005, 3 + (i % 3 - 1) * 0.02});
  once.add(points);
  std::reverse(points.begin(), points.end());
  for (const Vec3& p : points) turned.add({&p, 1});
  const auto places = once.places();
  ASSERT_EQ(places.size(), 100u);  // the middle third, a cell a centimetre
  EXPECT_NEAR(places[0].x, 0.005, 1e-9);
  EXPECT_NEAR(places[0].y, 0.005 - 0.01 * (places[0].y < 0), 1e-9);
  ASSERT_EQ(turned.places().size(), places.size());
  for (std::size_t i = 0; i < places.size(); ++i) EXPECT_EQ(turned.places()[i].x, places[i].x);
  EXPECT_EQ(cut(level_section(cut_facade(), 3), places).points.size(), 100u);
}

}  // namespace
}  // namespace ilot
