// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/boundaries/density_pass.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/model/outline_area.h"
#include "engine/products/planes/boundaries/boundaries_pass.h"
#include "engine/products/planes/join/label_pass.h"
#include "tests/support/plane_store.h"

namespace ilot {
namespace {

using test::PlaneStore;

constexpr double kStep = 0.004;  // radians
const Vec3 kStation{400, -6000, 900};

// A wall at y = 0 as a scanner on a tripod sees it: whole steps of azimuth and elevation, a window left out.
std::vector<Index3> scanned_wall() {
  std::vector<Index3> points;
  for (int a = -110; a <= 150; ++a)
    for (int e = -60; e <= 90; ++e) {
      const double x = kStation.x + 6000 * std::tan(a * kStep);
      const double z = kStation.z + std::hypot(x - kStation.x, 6000.0) * std::tan(e * kStep);
      if (std::abs(x - 1500) < 500 && std::abs(z - 1200) < 400) continue;
      points.push_back({std::llround(x), 0, std::llround(z)});
    }
  return points;
}

struct Mapped {
  std::vector<DensityMap> maps;
  std::size_t points = 0;
};

Mapped map_wall(const PlaneStore& s, bool with_station) {
  const Store& store = s.cloud.store();
  label_pass(store, s.cells, s.found, s.joined, {});
  const auto ranges = neighbour_ranges(store, s.cells, s.found);
  std::vector<std::uint32_t> id(s.joined.planes.size() + 1);
  for (std::uint32_t i = 0; i < id.size(); ++i) id[i] = i;
  const Scanner station{kStation, {0, 0, 1}, kStep, kStep};
  const std::span<const Scanner> stations(&station, with_station ? 1 : 0);
  Mapped m;
  m.points = store.points();
  std::vector<DensityRequest> requests;
  boundaries_pass(store, {1, 1, s.joined.planes, id, ranges, stations}, {}, [&](const Outline& o) {
    requests.push_back({o, m.points, area_of(o)});
  });
  density_pass(store, {s.joined.planes, id, stations}, requests, {},
               [&](const DensityMap& map) { m.maps.push_back(map); });
  return m;
}

TEST(DensityPass, WhatAStationSeesIsAsDenseAsItPredicts) {
  const Mapped m = map_wall(PlaneStore(scanned_wall()), true);
  ASSERT_EQ(m.maps.size(), 1u);
  const DensityMap& map = m.maps[0];
  EXPECT_EQ(map.plane_id, 1u);
  // A hundred points on a pixel in the mean: 24 mm between points ahead, 6 m away.
  EXPECT_DOUBLE_EQ(map.pixel, 0.5);
  std::size_t inside = 0, near = 0, window = 0;
  double counted = 0;
  for (std::size_t i = 0; i < map.measured.size(); ++i) {
    window += std::isnan(map.measured[i]);
    EXPECT_EQ(std::isnan(map.measured[i]), std::isnan(map.predicted[i]));
    if (std::isnan(map.measured[i])) continue;
    ++inside;
    near += std::abs(map.measured[i] / map.predicted[i] - 1) < 0.15;
    counted += map.measured[i] * map.pixel * map.pixel;
  }
  EXPECT_GT(inside, 50u);
  EXPECT_GE(window, 2u) << "pixels in the window hold no density";
  // Rows of points fall into a pixel or not: of ten rows and columns one more or less each.
  EXPECT_GT(static_cast<double>(near), 0.8 * static_cast<double>(inside));
  EXPECT_NEAR(counted, static_cast<double>(m.points), 0.1 * static_cast<double>(m.points));
}

TEST(DensityPass, WhereNoStationIsKnownNothingIsPredicted) {
  const Mapped m = map_wall(PlaneStore(scanned_wall()), false);
  ASSERT_EQ(m.maps.size(), 1u);
  std::size_t measured = 0;
  for (std::size_t i = 0; i < m.maps[0].measured.size(); ++i) {
    EXPECT_TRUE(std::isnan(m.maps[0].predicted[i]));
    measured += m.maps[0].measured[i] > 0;
  }
  EXPECT_GT(measured, 50u);
}

TEST(DensityPass, BlocksDoNotShow) {
  const Mapped a = map_wall(PlaneStore(scanned_wall()), true);
  const Mapped b = map_wall(PlaneStore(scanned_wall(), {700, 1u << 20, 1}), true);
  ASSERT_EQ(a.maps.size(), b.maps.size());
  ASSERT_EQ(a.maps[0].width, b.maps[0].width);
  ASSERT_EQ(a.maps[0].measured.size(), b.maps[0].measured.size());
  for (std::size_t i = 0; i < a.maps[0].measured.size(); ++i)
    if (!std::isnan(a.maps[0].measured[i])) {
      EXPECT_EQ(a.maps[0].measured[i], b.maps[0].measured[i]);
      EXPECT_EQ(a.maps[0].predicted[i], b.maps[0].predicted[i]);
    }
}

}  // namespace
}  // namespace ilot
