// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/drawings/facade_plan.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"
#include "tests/support/facades.h"

namespace ilot {
namespace {

// A door 2 wide with a half circle over it, springing at 2, in chords of so many degrees.
FacadeElement arched_door(double chord_deg) {
  FacadeElement door = drawn("door", {{0, 0, 0}, {2, 0, 0}});
  for (double a = 0; a < 180 + chord_deg / 2; a += chord_deg)
    door.ring.push_back({1 + cos_degrees(a), 0, 2 + cos_degrees(a - 90)});
  door.arcs = {{{1, 0, 2}, 1, 0, 180}};
  return door;
}

std::size_t count_role(const Drawing& drawing, DrawingRole role) {
  return static_cast<std::size_t>(std::count_if(drawing.lines.begin(), drawing.lines.end(),
                                                [&](const DrawingLine& line) { return line.role == role; }));
}

Drawing drawing_of(const FacadeElement& element) {
  const Facade facade = facade_of({element});
  Drawing drawing;
  draw_element(facade.elements[0], flat_element(facade, facade.elements[0], 1), drawing);
  return drawing;
}

TEST(FacadePlan, HeightsAreThoseOfTheCrs) {
  Facade facade = facade_of({});
  facade.origin = {100, 200, 35.5};
  const FlatPoint p = flat_place(facade, {101, 200, 40}, 0.5);
  EXPECT_DOUBLE_EQ(p.x, 0.5);
  EXPECT_DOUBLE_EQ(p.y, 20);
}

TEST(FacadePlan, ChordsBecomeOneArc) {
  for (const double chord : {5.0, 45.0, 90.0, 180.0}) {
    const FacadeElement door = arched_door(chord);
    const FlatElement flat = flat_element(facade_of({door}), door, 1);
    ASSERT_EQ(flat.corners.size(), 4u) << chord;
    EXPECT_TRUE(flat.arcs.empty());
    EXPECT_NEAR(flat.corners[2].bulge, 1, 1e-9);
    EXPECT_DOUBLE_EQ(flat.corners[2].x, 2);
    EXPECT_NEAR(flat.corners[3].x, 0, 1e-12);
    EXPECT_NEAR(flat.box.max.y, 3, 1e-9);
    for (const FlatPoint& p : chords_of(flat))
      if (p.y > 2) {
        EXPECT_NEAR(std::hypot(p.x - 1, p.y - 2), 1, 1e-12);
      }
  }
}

// Jambs a millimetre off the circle leave the crown where it is.
TEST(FacadePlan, HalfCirclesKeepTheirCrown) {
  for (const double off : {-0.002, 0.002}) {
    FacadeElement door = arched_door(5);
    door.ring[1].x = door.ring[2].x = 2 + off;
    const FlatElement flat = flat_element(facade_of({door}), door, 1);
    EXPECT_NEAR(flat.box.max.y, 3, 0.003);
  }
}

TEST(FacadePlan, HolesLieInTheWall) {
  FacadeElement window = drawn("window", {{1, 0, 1}, {2, 0, 1}, {2, 0, 2}, {1, 0, 2}});
  window.opening = true;
  const Facade facade = facade_of({window});
  EXPECT_TRUE(is_hole(facade, window, 1));
  for (Vec3& p : window.ring) p = p - 0.3 * facade.out;
  EXPECT_NEAR(distance_from_wall(facade, window), -0.3, 1e-12);
  EXPECT_FALSE(is_hole(facade, window, 1));
}

TEST(FacadePlan, TheFootOfALunetteIsNoArc) {
  FacadeElement lunette = arched_door(10);
  lunette.ring.erase(lunette.ring.begin(), lunette.ring.begin() + 2);
  const FlatElement flat = flat_element(facade_of({lunette}), lunette, 1);
  ASSERT_EQ(flat.corners.size(), 2u);
  EXPECT_NEAR(std::max(flat.corners[0].bulge, flat.corners[1].bulge), 1, 1e-9);
  EXPECT_EQ(std::min(flat.corners[0].bulge, flat.corners[1].bulge), 0);
}

TEST(FacadePlan, AWholeCircleAndAnArcBesideTheRing) {
  FacadeElement eye = drawn("window", {});
  for (double a = 0; a < 360; a += 10) eye.ring.push_back({5 + 0.4 * cos_degrees(a), 0, 5 + 0.4 * cos_degrees(a - 90)});
  eye.arcs = {{{5, 0, 5}, 0.4, 0, 360}};
  FlatElement flat = flat_element(facade_of({eye}), eye, 1);
  EXPECT_LE(flat.corners.size(), 3u);
  for (const DrawingCorner& c : flat.corners) EXPECT_GT(c.bulge, 0);
  FacadeElement plain = drawn("window", wall_rectangle(0, 0, 1, 1));
  plain.arcs = {{{0.5, 0, 0.5}, 0.2, 30, 60}};
  flat = flat_element(facade_of({plain}), plain, 1);
  EXPECT_EQ(flat.corners.size(), 4u);
  ASSERT_EQ(flat.arcs.size(), 1u);
  EXPECT_EQ(flat.arcs[0].from_deg, 30);
  EXPECT_EQ(flat.arcs[0].to_deg, 60);
}

TEST(FacadePlan, ClockwiseRingsAreTurnedWithTheirEdges) {
  FacadeElement window = drawn("window", wall_rectangle(0, 0, 2, 1));
  window.edges.resize(4);
  window.edges[1].error_m = 7;  // the right side
  std::reverse(window.ring.begin(), window.ring.end());
  std::reverse(window.edges.begin(), window.edges.end());
  std::rotate(window.edges.begin(), window.edges.begin() + 1, window.edges.end());
  const FlatElement flat = flat_element(facade_of({window}), window, 1);
  for (std::size_t i = 0; i < 4; ++i) {
    const bool right = flat.corners[i].x == 2 && flat.corners[(i + 1) % 4].x == 2;
    EXPECT_EQ(flat.edges[i].error_m, right ? 7 : 0);
    if (right) {
      EXPECT_LT(flat.corners[i].y, flat.corners[(i + 1) % 4].y);
    }
  }
}

TEST(FacadePlan, StatusDecidesTheLayer) {
  FacadeElement window = drawn("window", wall_rectangle(0, 0, 1, 2));
  Drawing drawing = drawing_of(window);
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_TRUE(drawing.lines[0].closed);
  EXPECT_EQ(drawing.lines[0].role, DrawingRole::opening);

  window.status = DrawnStatus::completed;
  drawing = drawing_of(window);
  ASSERT_EQ(drawing.lines.size(), 1u);
  EXPECT_EQ(drawing.lines[0].role, DrawingRole::completed);

  window.status = DrawnStatus::occluded;
  drawing = drawing_of(window);
  EXPECT_EQ(count_role(drawing, DrawingRole::opening), 0u);  // never as an opening
  EXPECT_EQ(count_role(drawing, DrawingRole::occluded), 1u);
  EXPECT_GT(count_role(drawing, DrawingRole::shadow), 5u);
  for (const DrawingLine& line : drawing.lines)
    if (line.role == DrawingRole::shadow) {
      for (const DrawingCorner& c : line.corners)
        EXPECT_TRUE(c.x > -1e-9 && c.x < 1 + 1e-9 && c.y > -1e-9 && c.y < 2 + 1e-9);
    }
}

TEST(FacadePlan, OccludedEdgesOpenTheRing) {
  FacadeElement window = drawn("window", wall_rectangle(0, 0, 1, 2));
  window.edges.resize(4);
  window.edges[0].status = DrawnStatus::completed;  // the bottom
  Drawing drawing = drawing_of(window);
  ASSERT_EQ(drawing.lines.size(), 2u);
  EXPECT_TRUE(drawing.lines[0].closed);  // known all round
  EXPECT_EQ(drawing.lines[1].role, DrawingRole::completed);
  EXPECT_EQ(drawing.lines[1].corners.size(), 2u);

  window.edges[1].status = DrawnStatus::occluded;  // the right side
  drawing = drawing_of(window);
  ASSERT_EQ(drawing.lines.size(), 3u);
  for (const DrawingLine& line : drawing.lines) EXPECT_FALSE(line.closed);
  EXPECT_EQ(count_role(drawing, DrawingRole::opening), 1u);
  const auto seen = std::find_if(drawing.lines.begin(), drawing.lines.end(),
                                 [](const DrawingLine& line) { return line.role == DrawingRole::opening; });
  EXPECT_EQ(seen->corners.size(), 3u);  // top and left
}

TEST(FacadePlan, ErrorsWidenTheRing) {
  FacadeElement window = drawn("window", wall_rectangle(0, 0, 2, 1));
  EXPECT_TRUE(widened_ring(flat_element(facade_of({window}), window, 1)).empty());
  window.edges.resize(4);
  for (std::size_t i = 0; i < 4; ++i) window.edges[i].error_m = 0.01 * static_cast<double>(i + 1);
  const std::vector<FlatPoint> ring = widened_ring(flat_element(facade_of({window}), window, 1));
  ASSERT_EQ(ring.size(), 4u);
  EXPECT_NEAR(ring[0].x, -0.04, 1e-12);
  EXPECT_NEAR(ring[0].y, -0.01, 1e-12);
  EXPECT_NEAR(ring[2].x, 2.02, 1e-12);
  EXPECT_NEAR(ring[2].y, 1.03, 1e-12);
  FacadeElement door = arched_door(5);
  door.edges.assign(door.ring.size(), {DrawnStatus::seen, 1, 0, 0.01, 0});
  for (const FlatPoint& p : widened_ring(flat_element(facade_of({door}), door, 1)))
    if (p.y > 2.2) {
      EXPECT_NEAR(std::hypot(p.x - 1, p.y - 2), 1.01, 1e-4);
    }
  // A spike: its tip stays near.
  FacadeElement spike = drawn("stone", {{0, 0, 0}, {1, 0, 0}, {0, 0, 0.01}});
  spike.edges.assign(3, {DrawnStatus::seen, 1, 0, 0.01, 0});
  for (const FlatPoint& p : widened_ring(flat_element(facade_of({spike}), spike, 1))) EXPECT_LE(p.x, 1.0401);
}

TEST(FacadePlan, BrokenRingsDrawNothingOrLittle) {
  for (const std::vector<Vec3>& ring :
       {std::vector<Vec3>{}, {{1, 0, 1}}, {{1, 0, 1}, {1, 0, 1}, {1, 0, 1}}, {{0, 0, 0}, {1, 0, 0}, {0, 0, 0}}}) {
    FacadeElement broken = drawn("window", ring);
    broken.arcs = {{{0, 0, 0}, 0, 0, 0}, {{0, 0, 0}, 1, 0, 360}};
    EXPECT_LE(drawing_of(broken).lines.size(), 1u);
  }
}

}  // namespace
}  // namespace ilot
