// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_town.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <set>

#include "scan/roofs/roof_neighbours.h"

namespace ilot::scan {
namespace {

const RoofTown& town() {
  static const RoofTown built = build_roof_town({});
  return built;
}

TEST(RoofTown, HasTheRoofsOfTheDocument) {
  std::array<int, 3> kinds{};
  int more_than_ten = 0, adjoining = 0;
  for (std::size_t b = 0; b < town().buildings.size(); ++b) {
    const RoofBuilding& building = town().buildings[b];
    ++kinds[static_cast<std::size_t>(building.kind)];
    int roofs = 0;
    for (const RoofFace& face : building.solid.faces) roofs += face.part == RoofPart::roof;
    if (building.kind == RoofKind::gable) {
      EXPECT_EQ(roofs, 2);
    }
    if (building.kind == RoofKind::hip) {
      EXPECT_EQ(roofs, 4);
    }
    if (building.kind == RoofKind::complex) {
      EXPECT_GE(roofs, 3);
    }
    more_than_ten += roofs > 10;
    adjoining += b > 0 && building.frame.x == town().buildings[b - 1].frame.x;
  }
  EXPECT_EQ(kinds[0], 128);
  EXPECT_EQ(kinds[1], 52);
  EXPECT_EQ(kinds[2], 265);
  EXPECT_GT(more_than_ten, 25);
  EXPECT_GT(adjoining, 60);
  EXPECT_GT(town().crowns.size(), 200u);
}

TEST(RoofTown, SharesKeepTheirProportion) {
  for (std::uint64_t n : {1u, 2u, 3u, 10u, 100u, 445u, 1000u}) {
    const RoofCounts counts = roof_counts(n);
    EXPECT_EQ(counts.gable + counts.hip + counts.complex, n);
    EXPECT_NEAR(static_cast<double>(counts.gable), static_cast<double>(n) * 128 / 445, 0.51);
  }
}

TEST(RoofTown, SolidsAreSoundAndStandOnTheGround) {
  for (const RoofBuilding& building : town().buildings) {
    EXPECT_FALSE(fault_of(building.solid, 0.1, 0.3));
    EXPECT_FALSE(doubtful(building, building));
    for (Vec3 v : building.solid.vertices) {
      const Vec3 p = building.frame.to_town(v);
      EXPECT_GE(p.z, building.floor - 1e-9);
      EXPECT_LE(building.floor, town().ground.height(p.x, p.y) + 1e-9);
      EXPECT_LE(p.z - town().ground.height(p.x, p.y), kMaxRoofHeight * 0.001 + 1);
      const Vec3 back = building.frame.to_local(p);
      EXPECT_NEAR(norm(back - v), 0, 1e-9);
    }
    EXPECT_GT(building.eave, building.floor + 1.5);
    EXPECT_GT(building.ridge, building.eave);
  }
}

// Of two buildings no corner of a wing lies inside a wing of the other.
TEST(RoofTown, BuildingsDoNotOverlap) {
  const auto& all = town().buildings;
  for (const RoofBuilding& a : all)
    for (const RoofBuilding& b : all) {
      if (&a == &b || std::abs(a.frame.x - b.frame.x) + std::abs(a.frame.y - b.frame.y) > 150) continue;
      for (const Wing& wing : a.wings)
        for (Integer u : {wing.rect.u0, wing.rect.u1})
          for (Integer v : {wing.rect.v0, wing.rect.v1}) {
            const Vec3 p =
                b.frame.to_local(a.frame.to_town({0.001 * static_cast<double>(u), 0.001 * static_cast<double>(v), 0}));
            for (const Wing& other : b.wings)
              EXPECT_FALSE(p.x > 0.001 * static_cast<double>(other.rect.u0) + 1e-6 &&
                           p.x < 0.001 * static_cast<double>(other.rect.u1) - 1e-6 &&
                           p.y > 0.001 * static_cast<double>(other.rect.v0) + 1e-6 &&
                           p.y < 0.001 * static_cast<double>(other.rect.v1) - 1e-6);
          }
    }
}

TEST(RoofTown, NeighboursShareOnlyPlanesThatAreOne) {
  std::vector<int> faces(town().plane_count);
  std::vector<Plane> planes(town().plane_count);
  int shared = 0;
  for (const RoofBuilding& building : town().buildings)
    for (std::size_t f = 0; f < building.solid.faces.size(); ++f) {
      const RoofFace& face = building.solid.faces[f];
      ASSERT_EQ(building.face_plane[f] == kNoPlane, face.part == RoofPart::floor);
      if (face.part == RoofPart::floor) continue;
      ASSERT_LT(building.face_plane[f], town().plane_count);
      if (faces[building.face_plane[f]]++ > 0) {
        ++shared;
        EXPECT_NEAR(planes[building.face_plane[f]].d, face.plane.d, 1e-6);
        EXPECT_GT(dot(planes[building.face_plane[f]].n, face.plane.n), 1 - 1e-9);
      }
      planes[building.face_plane[f]] = face.plane;
    }
  EXPECT_GT(shared, 10);
  EXPECT_EQ(std::count(faces.begin(), faces.end(), 0), 0);
}

TEST(RoofTown, ASeedIsATown) {
  RoofTownParams params;
  params.buildings = 30;
  const RoofTown a = build_roof_town(params), again = build_roof_town(params);
  params.seed = 1;
  const RoofTown b = build_roof_town(params);
  ASSERT_EQ(a.buildings.size(), 30u);
  ASSERT_EQ(b.buildings.size(), 30u);
  EXPECT_EQ(a.buildings[7].ridge, again.buildings[7].ridge);
  EXPECT_NE(a.buildings[7].ridge, b.buildings[7].ridge);
}

}  // namespace
}  // namespace ilot::scan
