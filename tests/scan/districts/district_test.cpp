// SPDX-License-Identifier: Apache-2.0
#include "scan/districts/district.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <optional>

#include "scan/districts/district_scan.h"
#include "scan/scanners/airborne.h"
#include "scan/scanners/cell_scan.h"

namespace ilot::scan {
namespace {

DistrictScan district_town(std::uint64_t seed) {
  SceneValues values(district_options());
  values.set("scene.area_km2=0.1");
  values.set("scene.density=4");
  return plan_district(values, seed, {});
}

// The oracle: the ray against the triangles of the rings that the truth file shows (Moeller, Trumbore 1997).
std::optional<double> hit_triangle(const Ray& ray, Vec3 a, Vec3 b, Vec3 c) {
  const Vec3 ab = b - a, ac = c - a, p = cross(ray.direction, ac);
  const double determinant = dot(ab, p);
  if (std::abs(determinant) < 1e-12) return std::nullopt;
  const Vec3 from = ray.origin - a, q = cross(from, ab);
  const double u = dot(from, p) / determinant, v = dot(ray.direction, q) / determinant;
  if (u < 0 || v < 0 || u + v > 1) return std::nullopt;
  return dot(ac, q) / determinant;
}

double nearest_ring(const Ray& ray, const Cell& cell, const Ground& ground) {
  const Plane plane = ground.plane();
  double nearest = -signed_distance(plane, ray.origin) / dot(plane.n, ray.direction);
  for (const Face& face : cell.faces)
    for (std::size_t i = 1; i + 1 < face.ring.size(); ++i)
      if (const auto t = hit_triangle(ray, face.ring[0], face.ring[i], face.ring[i + 1]))
        nearest = std::min(nearest, *t);
  return nearest;
}

TEST(District, NoRayPassesThroughAWallOrRoof) {
  const DistrictScan scan = district_town(5);
  const District district(scan.district);
  const FlightPlan flight(scan.flight, district.ground(), scan.district.seed);
  Cell cell = district.build_cell(1);
  cell.crowns.clear();
  CellTracer tracer(cell, district.ground(), 2);
  std::vector<Return> returns;
  std::array<int, 5> met{};
  int number = 0;
  flight.for_each_pulse(cell.area, [&](Pulse pulse) {
    if (++number % 23 != 0) return;
    tracer.trace(pulse.ray, pulse.rng, returns);
    ASSERT_EQ(returns.size(), 1u);
    ASSERT_NEAR(returns[0].range, nearest_ring(pulse.ray, cell, district.ground()), 1e-6);
    ++met[static_cast<std::size_t>(returns[0].surface)];
  });
  EXPECT_GT(met[1], 1000);
  EXPECT_GT(met[2], 500);
  EXPECT_GT(met[3], 10);
}

TEST(District, NoRayOfOneCellMeetsAnother) {
  const DistrictScan scan = district_town(6);
  const District district(scan.district);
  ASSERT_EQ(district.cell_count(), 4u);
  const FlightPlan flight(scan.flight, district.ground(), scan.district.seed);
  const Cell here = district.build_cell(0), right = district.build_cell(1), above = district.build_cell(2);
  CellTracer tracer_right(right, district.ground(), 2), tracer_above(above, district.ground(), 2);
  std::vector<Return> returns;
  flight.for_each_pulse(here.area, [&](Pulse pulse) {
    for (CellTracer* tracer : {&tracer_right, &tracer_above}) {
      tracer->trace(pulse.ray, pulse.rng, returns);
      ASSERT_EQ(returns.size(), 1u);
      ASSERT_EQ(returns[0].surface, Surface::ground);
    }
  });
}

TEST(District, CellsArePureAndNeighbourhoodsDiffer) {
  const District district(district_town(7).district);
  const Cell a = district.build_cell(2), again = district.build_cell(2), b = district.build_cell(3);
  ASSERT_EQ(a.faces.size(), again.faces.size());
  for (std::size_t i = 0; i < a.faces.size(); ++i) EXPECT_EQ(a.faces[i].plane.d, again.faces[i].plane.d);
  EXPECT_NE(a.houses[0].heading.cos, b.houses[0].heading.cos);
}

TEST(District, HousesStandApartOrSideBySideAndBelowTheLimit) {
  const DistrictScan scan = district_town(8);
  const District district(scan.district);
  for (std::uint64_t index = 0; index < district.cell_count(); ++index) {
    const Cell cell = district.build_cell(index);
    ASSERT_GT(cell.houses.size(), 10u);
    for (const Face& face : cell.faces)
      for (Vec3 p : face.ring) {
        EXPECT_LE(p.z - district.ground().height(p.x, p.y), kMaxHouseHeight);
        EXPECT_GE(p.x, cell.area.x0 + scan.district.clearance);
        EXPECT_LE(p.y, cell.area.y1 - scan.district.clearance);
      }
    for (std::size_t i = 0; i < cell.houses.size(); ++i)
      for (std::size_t j = 0; j < cell.houses.size(); ++j)
        if (i != j) {
          EXPECT_GT(distance_to_footprint(cell.houses[i], cell.houses[j].x, cell.houses[j].y), 3);
        }
  }
}

TEST(District, FacesLookOutwardsAreFlatAndShareAPlaneOnlyWhereCoplanar) {
  const District district(district_town(9).district);
  std::size_t shared = 0;
  for (std::uint64_t index = 0; index < district.cell_count(); ++index) {
    const Cell cell = district.build_cell(index);
    ASSERT_EQ(cell.face_plane.size(), cell.faces.size());
    for (std::size_t i = 0; i < cell.faces.size(); ++i) {
      const Face& face = cell.faces[i];
      const HouseForm& house = cell.houses[cell.face_building[i]];
      EXPECT_LT(signed_distance(face.plane, {house.x, house.y, house.eave - 1}), -0.4);
      for (Vec3 p : face.ring) EXPECT_NEAR(signed_distance(face.plane, p), 0, 1e-9);
      for (std::size_t j = 0; j < i; ++j) {
        if (cell.face_plane[i] != cell.face_plane[j]) continue;
        ++shared;
        EXPECT_EQ(cell.faces[j].surface, face.surface);
        for (Vec3 p : face.ring) EXPECT_NEAR(signed_distance(cell.faces[j].plane, p), 0, 1e-5);
      }
    }
  }
  EXPECT_GT(shared, 10u);
}

TEST(District, RoofShapesFollowTheirShares) {
  SceneValues values(district_options());
  values.set("scene.area_km2=1");
  values.set("scene.flat=0");
  values.set("scene.hip=1");
  const District district(plan_district(values, 1, {}).district);
  const Cell cell = district.build_cell(0);
  for (const HouseForm& house : cell.houses) EXPECT_EQ(house.roof, RoofShape::hip);
}

}  // namespace
}  // namespace ilot::scan
