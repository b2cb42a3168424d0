// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/extend.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

#include "kernels/core/portable_math.h"
#include "kernels/geometry/padded_points.h"

namespace ilot {
namespace {

constexpr std::int64_t kExtendEdge = 4096;
constexpr std::int64_t kExtendReach = 60;
constexpr float kExtendStep = 16;

// Points of a surface around the border x = kExtendEdge between a cell and its neighbour: the label says the cell.
struct TwoCells {
  PaddedPoints points;
  std::vector<std::uint8_t> core;
  std::vector<std::uint32_t> label;

  // In the frame of the first cell or, with `second`, in that of the second one.
  template <class Height>
  TwoCells(bool second, float rows, Height height) {
    const auto edge = static_cast<float>(kExtendEdge);
    for (float x = edge - 2000; x < edge + 2000; x += kExtendStep)
      for (float y = 1000; y < 1000 + rows * kExtendStep; y += kExtendStep) {
        points.add(second ? x - edge : x, y, std::nearbyint(height(x)));
        core.push_back((x < edge) != second);
        label.push_back(x < edge ? 1 : 2);
      }
    points.pad();
  }
  std::size_t extend(const std::vector<ExtendedPlane>& planes, double angle = 10) {
    return extend_planes(points.points(), core, planes, {kExtendEdge, kExtendReach, cos_degrees(angle), 0.8}, label);
  }
};

// A level plane at this height, and one through the border that leans.
ExtendedPlane level_plane(double height, double epsilon) {
  return {{{0, 0, 1}, -height}, epsilon};
}
ExtendedPlane leaning_plane(bool second, double height, double slope, double epsilon) {
  const double n = std::sqrt(1 + slope * slope), at = second ? 0 : static_cast<double>(kExtendEdge);
  return {{{-slope / n, 0, 1 / n}, (slope * at - height) / n}, epsilon};
}

// A surface that is level up to the border and then bends down.
double bent(double x) {
  const double beyond = std::max(0.0, x - static_cast<double>(kExtendEdge));
  return 1000 - beyond * beyond / 40000;
}

TEST(ExtendPlanes, TheFirstPlaneEndsWhereEpsilonEndsAndBothCellsAgree) {
  // 0.8 epsilon = 16 units are reached 800 units beyond the border.
  TwoCells first(false, 40, bent), second(true, 40, bent);
  EXPECT_EQ(first.extend({level_plane(1000, 20), leaning_plane(false, 1010, -0.05, 20)}), 0u);
  EXPECT_GT(second.extend({level_plane(1000, 20), leaning_plane(true, 1010, -0.05, 20)}), 0u);
  for (std::size_t i = 0; i < second.points.size; ++i) {
    const double x = second.points.x[i], off = std::abs(second.points.z[i] - 1000);
    if (second.core[i] && x < 700) {
      EXPECT_EQ(second.label[i], 1u) << x;
    }
    if (second.core[i] && second.label[i] == 1) {
      EXPECT_LE(off, 20);
    }
    if (second.core[i] && x > 900) {
      EXPECT_EQ(second.label[i], 2u) << x;
    }
  }
}

// The second plane has what is more than 17 units above the first one, the first what is less than 15 above it.
void expect_the_ramp_is_divided(const TwoCells& cell) {
  for (std::size_t i = 0; i < cell.points.size; ++i) {
    if (!cell.core[i]) continue;
    const double low = cell.points.z[i] - 1000;
    if (low > 17) {
      EXPECT_EQ(cell.label[i], 2u) << cell.points.x[i];
    }
    if (low < 15) {
      EXPECT_EQ(cell.label[i], 1u) << cell.points.x[i];
    }
  }
}

TEST(ExtendPlanes, ThePlaneThatComesSecondTakesWhatTheFirstFitsBadly) {
  // The first plane is 18 units too low at the border and fits only far inside of its cell.
  const auto ramp = [](double x) { return 1000 + std::max(0.0, x - 3000) * 18 / 1096; };
  TwoCells cell(false, 40, ramp);
  EXPECT_GT(cell.extend({level_plane(1000, 20), leaning_plane(false, 1018, 18.0 / 1096, 20)}), 0u);
  expect_the_ramp_is_divided(cell);
}

// The same surface with a wide first plane: what decides in one cell must decide in the other one, and the second cell
// knows only points near the narrow plane.
TEST(ExtendPlanes, TheSmallerEpsilonOfTheTwoDecides) {
  const auto ramp = [](double x) { return 1000 + std::max(0.0, x - 3000) * 18 / 1096; };
  TwoCells cell(false, 40, ramp);
  EXPECT_GT(cell.extend({level_plane(1000, 40), leaning_plane(false, 1018, 18.0 / 1096, 20)}), 0u);
  expect_the_ramp_is_divided(cell);
}

TEST(ExtendPlanes, PlanesAtAGreatAngleAndPointsBeyondAGapStay) {
  const auto ridge = [](double x) { return 1000 - std::max(0.0, x - static_cast<double>(kExtendEdge)) / 2; };
  TwoCells roof(true, 40, ridge);
  EXPECT_EQ(roof.extend({level_plane(1000, 20), leaning_plane(true, 1000, -0.5, 20)}), 0u);
  TwoCells flat(true, 40, [](double) { return 1000.0; });
  PaddedPoints apart;
  std::vector<std::uint8_t> core;
  std::vector<std::uint32_t> label;
  for (std::size_t i = 0; i < flat.points.size; ++i) {
    const float x = flat.points.x[i];
    if (x > 400 && x < 700) continue;
    apart.add(x, flat.points.y[i], flat.points.z[i]);
    core.push_back(flat.core[i]);
    label.push_back(flat.label[i]);
  }
  apart.pad();
  EXPECT_GT(extend_planes(apart.points(), core, std::vector{level_plane(1000, 20), level_plane(1001, 20)},
                          {kExtendEdge, kExtendReach, cos_degrees(10), 0.8}, label),
            0u);
  for (std::size_t i = 0; i < apart.size; ++i) EXPECT_EQ(label[i], apart.x[i] > 500 ? 2u : 1u) << apart.x[i];
}

TEST(ExtendPlanes, NothingToDoIsNothing) {
  EXPECT_EQ(extend_planes({}, {}, {}, {}, {}), 0u);
  TwoCells one(false, 10, [](double) { return 1000.0; });
  for (std::uint32_t& l : one.label) l = 1;
  EXPECT_EQ(one.extend({level_plane(1000, 20)}), 0u);
}

}  // namespace
}  // namespace ilot
