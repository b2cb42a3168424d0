// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_styles.h"

#include <gtest/gtest.h>

#include <map>

#include "scan/roofs/roof_solid.h"

namespace ilot::scan {
namespace {

TEST(RoofStyles, SimpleRoofsHaveTheirFaces) {
  Rng rng(3);
  for (int round = 0; round < 100; ++round)
    for (RoofKind kind : {RoofKind::gable, RoofKind::hip}) {
      const RoofDesign design = draw_roof(rng, kind, BuiltForm::detached, 0);
      const RoofSolid solid = build_solid(partition_roof(design.wings), 0);
      EXPECT_FALSE(fault_of(solid, 0.1, 0.3));
      int roofs = 0;
      for (const RoofFace& face : solid.faces) roofs += face.part == RoofPart::roof;
      EXPECT_EQ(roofs, kind == RoofKind::gable ? 2 : 4);
    }
}

TEST(RoofStyles, ComplexRoofsAreVariedAndMostlySound) {
  Rng rng(5);
  std::map<int, int> with_faces;
  int unsound = 0, many = 0;
  const int rounds = 1000;
  for (int round = 0; round < rounds; ++round) {
    const RoofDesign design =
        draw_roof(rng, RoofKind::complex, round % 4 ? BuiltForm::detached : BuiltForm::terraced, 0);
    const RoofSolid solid = build_solid(partition_roof(design.wings), 0);
    if (fault_of(solid, 0.1, 0.3)) {
      ++unsound;
      continue;
    }
    int roofs = 0;
    for (const RoofFace& face : solid.faces) roofs += face.part == RoofPart::roof;
    ++with_faces[roofs];
    many += roofs > 10;
    for (Vec3 v : solid.vertices) EXPECT_LE(v.z, kMaxRoofHeight * 0.001);
  }
  EXPECT_LT(unsound, rounds / 10);
  EXPECT_GT(many, rounds / 20);
  for (int faces = 3; faces <= 10; ++faces) EXPECT_GT(with_faces[faces], rounds / 40) << faces;
}

}  // namespace
}  // namespace ilot::scan
