// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/truth_facades.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/facades.h"

namespace ilot {
namespace {

TruePlane plane_of(std::uint32_t id, Ring3 ring, double y) {
  return {id, "facade", {{0, -1, 0}, y}, {{1, std::move(ring), {}}}};
}

// A wall in y = 8, 10 by 6, with a window; before it at y = 7.9 the front of a sill; another wall at y = 20.
Truth a_truth() {
  Truth truth;
  truth.planes = {plane_of(1, wall_rectangle(4, 1.8, 6, 2, 7.9), 7.9), plane_of(2, wall_rectangle(0, 0, 10, 6, 8), 8),
                  plane_of(3, wall_rectangle(0, 0, 10, 6, 20), 20)};
  truth.elements = {{1, 1, "window", 1, 2, wall_rectangle(4, 2, 6, 4, 8), 2, 2, -0.3},
                    {2, 1, "sill", 0, 0, wall_rectangle(4, 1.8, 6, 2, 7.9), 2, 0.2, 0.1},
                    {3, 0, "car", 0, 0, wall_rectangle(0, 0, 2, 1, 3), 2, 1, 0},
                    {4, 2, "window", 0, 0, wall_rectangle(1, 1, 2, 2, 20), 1, 1, -0.2}};
  return truth;
}

TEST(TruthFacades, AreTheWallsThatOpeningsLieOn) {
  const std::vector<Facade> facades = true_facades(a_truth());
  ASSERT_EQ(facades.size(), 2u);
  const Facade& f = facades[0];
  EXPECT_EQ(f.id, 1u);
  EXPECT_EQ(f.out.y, -1);
  EXPECT_EQ(f.right.x, 1);
  EXPECT_EQ(f.up.z, 1);
  EXPECT_NEAR(f.origin.y, 8, 1e-12) << "not the sill's plane";
  EXPECT_NEAR(f.width_m, 10, 1e-12);
  ASSERT_EQ(f.elements.size(), 3u);
  EXPECT_EQ(f.elements[0].kind, "outline");
  EXPECT_EQ(f.elements[1].kind, "window");
  EXPECT_TRUE(f.elements[1].opening);
  EXPECT_EQ(f.elements[1].column, 2u);
  EXPECT_FALSE(f.elements[2].opening);
  EXPECT_EQ(facades[1].id, 2u);
  EXPECT_NEAR(facades[1].origin.y, 20, 1e-12);
}

TEST(TruthFacades, ChordsOfAnArchGetTheirArc) {
  Truth truth = a_truth();
  Ring3 arch{{4, 8, 1}, {6, 8, 1}};
  for (int i = 0; i <= 12; ++i) {
    const double angle = i * 3.14159265358979 / 12;
    arch.push_back({5 + std::cos(angle), 8, 3 + std::sin(angle)});
  }
  truth.elements[0].ring = arch;
  const FacadeElement window = true_facades(truth)[0].elements[1];
  ASSERT_EQ(window.arcs.size(), 1u);
  EXPECT_NEAR(window.arcs[0].centre.x, 5, 1e-6);
  EXPECT_NEAR(window.arcs[0].centre.z, 3, 1e-6);
  EXPECT_NEAR(window.arcs[0].radius_m, 1, 1e-6);
  EXPECT_NEAR(window.arcs[0].from_deg, 0, 1e-6);
  EXPECT_NEAR(window.arcs[0].to_deg, 180, 1e-6);
  EXPECT_TRUE(true_facades(truth)[0].elements[2].arcs.empty()) << "a rectangle";
}

TEST(TruthFacades, AFacadeWithoutAPlaneIsLeftOut) {
  Truth truth = a_truth();
  truth.planes.clear();
  EXPECT_TRUE(true_facades(truth).empty());
}

TEST(TruthFacades, InTheAxesOfOneThatWasFound) {
  const std::vector<Facade> truth = true_facades(a_truth());
  Facade found = facade_of({});
  found.id = 9;
  found.origin = {0.013, 8.004, 0.1};
  const std::optional<Facade> same = truth_in_frame_of(truth, found);
  ASSERT_TRUE(same);
  EXPECT_EQ(same->id, 9u);
  EXPECT_EQ(same->origin.x, 0.013);
  EXPECT_EQ(same->elements[1].ring[0].x, 4);
  found.origin.y = 9;
  EXPECT_FALSE(truth_in_frame_of(truth, found)) << "between the two walls";
  found.origin.y = 8;
  found.out = {0, 1, 0};
  EXPECT_FALSE(truth_in_frame_of(truth, found)) << "it looks the other way";
}

}  // namespace
}  // namespace ilot
