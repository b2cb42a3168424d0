// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_solid.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>

#include "scan/roofs/roof_styles.h"
#include "scan/roofs/roof_wings.h"

namespace ilot::scan {
namespace {

std::size_t count(const RoofSolid& solid, RoofPart part) {
  return static_cast<std::size_t>(
      std::count_if(solid.faces.begin(), solid.faces.end(), [&](const RoofFace& f) { return f.part == part; }));
}

double volume(const RoofSolid& solid) {
  double sum = 0;
  for (const RoofFace& face : solid.faces)
    sum += face_area(solid, face) * dot(face.plane.n, solid.vertices[face.rings[0][0]]) / 3;
  return sum;
}

// By the pieces' own prisms: area times mean height over a fan of triangles.
double volume(const std::vector<RoofPiece>& pieces, double floor) {
  double sum = 0;
  for (const RoofPiece& piece : pieces) {
    std::vector<Vec3> corners;
    for (const Corner& corner : piece.outline) {
      const double u = static_cast<double>(corner.at.u) / static_cast<double>(corner.at.w);
      const double v = static_cast<double>(corner.at.v) / static_cast<double>(corner.at.w);
      corners.push_back(0.001 * Vec3{u, v, height_mm(piece.plane, u, v)});
    }
    for (std::size_t i = 1; i + 1 < corners.size(); ++i) {
      const Vec3 a = corners[i] - corners[0], b = corners[i + 1] - corners[0];
      sum += (a.x * b.y - a.y * b.x) / 2 * ((corners[0].z + corners[i].z + corners[i + 1].z) / 3 - floor);
    }
  }
  return sum;
}

TEST(RoofSolid, ABoxHasSixFacesAndEightVertices) {
  const std::vector<Wing> wings{flat_wing({0, 0, 4000, 3000}, 2000)};
  const RoofSolid solid = build_solid(partition_roof(wings), 0);
  EXPECT_EQ(solid.vertices.size(), 8u);
  EXPECT_EQ(solid.faces.size(), 6u);
  EXPECT_NEAR(volume(solid), 24, 1e-9);
  EXPECT_FALSE(fault_of(solid, 0.1, 0.1));
}

TEST(RoofSolid, AnEllOfTwoGablesMeetsInAValleyAndARidge) {
  const std::vector<Wing> wings{gable_wing({0, 0, 12000, 8000}, Axis::u, 3000, 12),
                                gable_wing({0, -5000, 8000, 4000}, Axis::v, 3000, 12)};
  const RoofSolid solid = build_solid(partition_roof(wings), 0);
  EXPECT_FALSE(fault_of(solid, 0.1, 0.1));
  EXPECT_EQ(count(solid, RoofPart::roof), 5u);  // the wing parts the body's slope in two that meet in the ridge
  EXPECT_EQ(count(solid, RoofPart::floor), 1u);
  EXPECT_EQ(count(solid, RoofPart::wall), 6u);  // an L has six sides, of which the long one is one wall
}

TEST(RoofSolid, ALowerWingMakesAStepAndAChimneyAHole) {
  const std::vector<Wing> wings{flat_wing({0, 0, 6000, 6000}, 5000), flat_wing({6000, 1000, 9000, 5000}, 3000),
                                flat_wing({2000, 2000, 2600, 2600}, 6000)};
  const RoofSolid solid = build_solid(partition_roof(wings), 0);
  EXPECT_FALSE(fault_of(solid, 0.1, 0.1));
  EXPECT_EQ(count(solid, RoofPart::roof), 3u);
  std::map<std::size_t, int> rings;
  for (const RoofFace& face : solid.faces) ++rings[face.rings.size()];
  EXPECT_EQ(rings[2], 1);
  EXPECT_NEAR(volume(solid), 36 * 5 + 12 * 3 + 0.36, 1e-9);
  const auto top =
      std::find_if(solid.faces.begin(), solid.faces.end(), [](const RoofFace& f) { return f.rings.size() == 2; });
  EXPECT_FALSE(face_contains(solid, *top, {2.3, 2.3, 5}));
  EXPECT_TRUE(face_contains(solid, *top, {1.3, 2.3, 5}));
}

TEST(RoofSolid, FaultsAreFound) {
  // Two boxes that touch along one upright edge, and two that touch in nothing: the first is no solid.
  const std::vector<Wing> touching{flat_wing({0, 0, 1000, 1000}, 2000), flat_wing({1000, 1000, 2000, 2000}, 2000)};
  EXPECT_TRUE(fault_of(build_solid(partition_roof(touching), 0), 0.1, 0.1));
  const std::vector<Wing> narrow{flat_wing({0, 0, 100, 5000}, 2000)};
  EXPECT_TRUE(fault_of(build_solid(partition_roof(narrow), 0), 0.01, 0.25));
  RoofSolid open = build_solid(partition_roof(std::vector<Wing>{flat_wing({0, 0, 4000, 3000}, 2000)}), 0);
  open.faces.pop_back();
  EXPECT_TRUE(fault_of(open, 0.1, 0.1));
}

TEST(RoofSolid, DrawnRoofsAreClosedFlatAndHoldTheirVolume) {
  Rng rng(11);
  int sound = 0;
  for (int round = 0; round < 400; ++round) {
    const RoofDesign design =
        draw_roof(rng, RoofKind::complex, round % 3 ? BuiltForm::detached : BuiltForm::terraced, 0.2);
    const std::vector<RoofPiece> pieces = partition_roof(design.wings);
    const RoofSolid solid = build_solid(pieces, -500);
    if (fault_of(solid, 0.1, 0.3)) continue;
    ++sound;
    EXPECT_NEAR(volume(solid), volume(pieces, -0.5), 1e-6);
    for (const RoofFace& face : solid.faces) {
      EXPECT_GT(face_area(solid, face), 0);
      for (const auto& ring : face.rings)
        for (std::uint32_t v : ring) EXPECT_NEAR(signed_distance(face.plane, solid.vertices[v]), 0, 1e-9);
    }
  }
  EXPECT_GT(sound, 280);
}

}  // namespace
}  // namespace ilot::scan
