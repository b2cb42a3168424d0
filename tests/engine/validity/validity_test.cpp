// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validity.h"

#include <gtest/gtest.h>

#include "tests/support/solids.h"

namespace ilot {
namespace {

const Shape kCube = box({0, 0, 0}, {1, 1, 1});

TEST(Validity, ACubeIsValid) {
  EXPECT_EQ(codes(kCube), Codes{});
  EXPECT_EQ(codes(box({766000, 6234000, -3}, {766010, 6234020, 4})), Codes{}) << "national coordinates";
  EXPECT_EQ(codes(CityObject{"a", "Building", {}, {}}), Codes{}) << "no geometry";
}

TEST(Validity, SaysWhereFaultsAre) {
  Shape open = kCube;
  open.faces.pop_back();
  const Faults faults = validate_object(object_of(open));
  ASSERT_EQ(faults.size(), 1u);
  EXPECT_EQ(faults[0].code, 302);
  EXPECT_EQ(faults[0].where, "lod 2.2, near (0.000, 0.000, 0.000)");
}

TEST(Validity, NamesCodes) {
  EXPECT_STREQ(validity_code_name(302), "SHELL_NOT_CLOSED");
  EXPECT_STREQ(validity_code_name(1), "UNKNOWN_ERROR");
  EXPECT_EQ(codes_of({{302, ""}, {102, ""}, {302, ""}}), (Codes{102, 302}));
}

// Solids of the given corners as parts of one building.
CityObject parts(const std::vector<Shape>& solids, const std::string& second_lod = "2.2") {
  CityObject object{"a", "Building", {}, {}};
  for (const Shape& s : solids) {
    const SolidShell shell = shell_of(s, static_cast<std::uint32_t>(object.vertices.size()));
    object.primitives.push_back({PrimitiveKind::solid, object.primitives.empty() ? "2.2" : second_lod, "a", {{shell}}});
    object.vertices.insert(object.vertices.end(), s.vertices.begin(), s.vertices.end());
  }
  return object;
}

TEST(Validity, PartsOfABuildingDoNotOverlap) {
  EXPECT_EQ(codes(parts({kCube, box({0.5, 0.5, 0.5}, {2, 2, 2})})), Codes{601});
  EXPECT_EQ(codes(parts({kCube, box({1, 0, 0}, {2, 1, 1})})), Codes{}) << "a party wall";
  EXPECT_EQ(codes(parts({kCube, box({5, 0, 0}, {6, 1, 1})})), Codes{}) << "apart";
  EXPECT_EQ(codes(parts({kCube, kCube})), Codes{601}) << "twice the same";
  EXPECT_EQ(codes(parts({kCube, kCube}, "1.2")), Codes{}) << "of two levels of detail";
  CityObject bridge = parts({kCube, kCube});
  bridge.type = "Bridge";
  EXPECT_EQ(codes(bridge), Codes{}) << "a rule for buildings";
}

TEST(Validity, RefusesVerticesWithoutAPlace) {
  Shape far = kCube;
  far.vertices[3].z = 1e300;
  EXPECT_EQ(codes(far), Codes{901});
}

Building house() {
  Building b{"h", "2.2", kCube.vertices, {}, {}};
  for (const FaceRings& rings : kCube.faces) b.surfaces.push_back({SurfaceKind::wall, 0, rings});
  return b;
}

TEST(Validity, JudgesBuildingsAsTheyAreWritten) {
  EXPECT_TRUE(validate_building(house(), {}, 0.0001).empty());
  Building thin = house();
  for (std::size_t i = 4; i < 8; ++i) thin.vertices[i].z = 0.04;
  EXPECT_TRUE(validate_building(thin, {}, 0.0001).empty());
  EXPECT_EQ(codes_of(validate_building(thin, {}, 0.1)), Codes{102}) << "steps that are too coarse make it flat";
}

TEST(Validity, OutlinesAreNoSolids) {
  Building flat{"h", "0", kCube.vertices, {{SurfaceKind::ground, 0, kCube.faces[0]}}, {}};
  EXPECT_TRUE(validate_building(flat, {}, 0.0001).empty());
  flat.lod = "1.2";
  EXPECT_EQ(codes_of(validate_building(flat, {}, 0.0001)), Codes{301});
}

TEST(Validity, ABuildingWithoutSurfacesIsEmpty) {
  EXPECT_EQ(codes_of(validate_building({"h", "2.2", {}, {}, {}}, {}, 0.0001)), Codes{902});
}

}  // namespace
}  // namespace ilot
