// SPDX-License-Identifier: Apache-2.0
#include "scan/models/model_stage.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/error.h"
#include "kernels/core/rng.h"
#include "tests/scan/models/test_models.h"
#include "tests/support/temporary_folder.h"

namespace ilot::scan {
namespace {

using test_models::block;

ModelStage stage_of(const std::string& text, double ground = 10) {
  const TemporaryFolder folder;
  ModelInput input;
  input.path = folder.put("a.city.json", text);
  return make_stage(read_scanned_model(input), ground);
}

std::string fault_of(const std::string& name, const std::string& text, ModelInput input = {}) {
  const TemporaryFolder folder;
  input.path = folder.put(name, text);
  try {
    read_scanned_model(input);
  } catch (const Error& error) {
    return error.what();
  }
  return "";
}

const TruePlane& plane_at(const ModelStage& stage, const std::string& surface_class, Vec3 normal) {
  for (const TruePlane& plane : stage.planes)
    if (plane.surface_class == surface_class && dot(plane.plane.n, normal) > 0.999) return plane;
  throw Error("no such plane");
}

// A file that turns its faces inside out gives the same truth.
TEST(ModelStage, TellsWallsRoofsAndWindowsWithTheirAreas) {
  for (const bool turned : {false, true}) {
    const ModelStage stage = stage_of(block(turned));
    const TruePlane& south = plane_at(stage, "facade", {0, -1, 0});
    EXPECT_NEAR(south.area, 10 * 6 - 1.2 * 1.5, 1e-9);
    EXPECT_NEAR(south.plane.d, 0, 1e-9);
    ASSERT_EQ(south.polygons.size(), 1u);
    EXPECT_EQ(south.polygons[0].holes.size(), 1u);
    EXPECT_NEAR(plane_at(stage, "roof", {0, 0, 1}).area, 80, 1e-9);
    EXPECT_NEAR(plane_at(stage, "ground", {0, 0, 1}).area, 30 * 28, 1e-9);
    const TruePlane& window = plane_at(stage, "window", {0, -1, 0});
    EXPECT_NEAR(window.area, 1.2 * 1.5, 1e-9) << "frame and pane are one plane";
    EXPECT_EQ(window.element, 1u);
    ASSERT_EQ(stage.buildings.size(), 1u);
    EXPECT_NEAR(stage.buildings[0].ridge - stage.buildings[0].ground, 6, 1e-9);
    EXPECT_EQ(stage.place.origin.x, 678000);
  }
}

TEST(ModelStage, AnOpeningIsTheOutlineOfItsWindowOnTheWall) {
  const ModelStage stage = stage_of(block());
  ASSERT_EQ(stage.openings.size(), 1u);
  ASSERT_EQ(stage.elements.size(), 1u);
  const TrueElement& window = stage.elements[0];
  EXPECT_EQ(window.kind, "window");
  EXPECT_NEAR(window.width, 1.2, 1e-3);
  EXPECT_NEAR(window.height, 1.5, 1e-3);
  EXPECT_NEAR(window.depth, -0.1, 1e-9);
  ASSERT_TRUE(window.seen);
  EXPECT_FALSE(window.seen->flush);
  EXPECT_NEAR(window.seen->area, 1.8, 1e-3);
  EXPECT_NEAR(stage.opening_normals[0].y, -1, 1e-9);
  ASSERT_EQ(stage.openings[0].ring.size(), 4u);
  for (const Vec3& p : stage.openings[0].ring) EXPECT_NEAR(p.y, 0, 1e-9) << "on the wall";
}

TEST(ModelStage, FramesAreWoodAndPanesAreGlass) {
  const ModelStage stage = stage_of(block());
  const PartScene scene(stage.scene.parts);
  const auto material_at = [&](double x, double z) {
    const auto hit = scene.cast({{x, -5, z}, {0, 1, 0}});
    return hit ? stage.scene.surfaces[hit->surface].material : Material::white_target;
  };
  EXPECT_EQ(material_at(2.6, 1.7), Material::glass);
  EXPECT_EQ(material_at(2.03, 1.7), Material::wood);
  EXPECT_NE(material_at(1.5, 1.7), Material::glass);
}

// A flush window on its wall is told apart and seen before it.
TEST(ModelStage, FlushWindowsAreToldApart) {
  const ModelStage stage = stage_of(block(false, "", true));
  ASSERT_EQ(stage.openings.size(), 1u);
  EXPECT_TRUE(stage.openings[0].seen->flush);
  const PartScene scene(stage.scene.parts);
  const auto hit = scene.cast({{2.6, -5, 1.7}, {0, 1, 0}});
  ASSERT_TRUE(hit);
  EXPECT_NEAR(hit->t, 4.998, 1e-9);
  EXPECT_EQ(stage.scene.surfaces[hit->surface].element, 1u);
}

// No ray from outside gets into a closed model, also not between two triangles.
TEST(ModelStage, IsWatertight) {
  const ModelStage stage = stage_of(block(), 0);
  const PartScene scene(stage.scene.parts);
  Rng rng(5);
  for (int i = 0; i < 20000; ++i) {
    const double angle = 6.283185 * rng.uniform();
    const Vec3 from{5 + 20 * std::cos(angle), 4 + 20 * std::sin(angle), 12 * rng.uniform()};
    // Half of the rays aim at corners and edges, where triangles meet.
    const Vec3 inner{i % 2 ? 10 * rng.uniform() : 2.0, i % 2 ? 8 * rng.uniform() : 0.05,
                     i % 2 ? 6 * rng.uniform() : 1.0};
    const Vec3 way = inner - from;
    const auto hit = scene.cast({from, (1 / norm(way)) * way});
    ASSERT_TRUE(hit);
    EXPECT_LE(hit->t, norm(way) + 0.06);
  }
}

TEST(ModelStage, ModelsInOtherUnitsAreScaledOrRefused) {
  const std::string obj = "v 0 0 0\nv 10 0 0\nv 10 0 6\nv 0 0 6\nf 1 2 3 4\n";
  const TemporaryFolder folder;
  ModelInput input;
  input.path = folder.put("a.obj", obj);
  input.unit = "ft";
  const ScannedModel feet = read_scanned_model(input);
  EXPECT_NEAR(feet.faces.at(0).area, 60 * 0.3048 * 0.3048, 1e-9);
  EXPECT_EQ(feet.place.crs.epsg, 0);
  EXPECT_EQ(feet.faces[0].face_class, FaceClass::facade);
  input.unit = "";
  input.y_up = true;
  EXPECT_EQ(read_scanned_model(input).faces.at(0).face_class, FaceClass::floor) << "the wall lies down";
  EXPECT_NE(fault_of("a.obj", "v 2.3 48.8 0\nv 2.3001 48.8 0\nv 2.3 48.8 12\nf 1 2 3").find("degrees"),
            std::string::npos);
  EXPECT_NE(fault_of("a.obj", "v 0 0 0\nv 9000 0 0\nv 0 0 6000\nf 1 2 3").find("--unit"), std::string::npos);
  EXPECT_NE(fault_of("a.obj", "v 1e12 0 0\nv 1e12 1 0\nv 1e12 0 1\nf 1 2 3").find("1e+12"), std::string::npos);
  EXPECT_NE(fault_of("a.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nf 1 2 3").find("area"), std::string::npos);
  EXPECT_NE(fault_of("a.obj", "v 0 0 0\n").find("no face"), std::string::npos);
  ModelInput mixed;
  mixed.crs = "EPSG:32632+6360";  // metres, and heights in US survey feet
  EXPECT_NE(fault_of("a.obj", obj, mixed).find("another unit"), std::string::npos);
  EXPECT_NE(fault_of("a.city.json", block(false, R"("metadata":{"referenceSystem":"urn:ogc:def:crs:EPSG::4326"},)"))
                .find("degrees"),
            std::string::npos);
}

TEST(ModelStage, NamesOfObjMaterialsTellWhatFacesAre) {
  const TemporaryFolder folder;
  ModelInput input;
  input.path = folder.put(
      "house.obj",
      "mtllib missing.mtl\nv 0 0 0\nv 4 0 0\nv 4 0 3\nv 0 0 3\nv 1 0.1 1\nv 2 0.1 1\nv 2 0.1 2\nv 1 0.1 2\n"
      "v 3 0.1 1\nv 3.5 0.1 1\nv 3.5 0.1 2\nv 3 0.1 2\nv 0 5 4\nv 4 5 4\n"
      "usemtl Brick_01\nf -14 -13 -12 -11\nusemtl Fensterglas\nf 5 6 7 8\nf 9 10 11 12\nusemtl x\nf 4 3 14 13\n");
  const ModelStage stage = make_stage(read_scanned_model(input), 0);
  EXPECT_EQ(stage.openings.size(), 2u) << "two panes that do not touch are two windows";
  EXPECT_EQ(stage.buildings.size(), 1u);
  EXPECT_NO_THROW(plane_at(stage, "facade", {0, -1, 0}));
  EXPECT_EQ(stage.scene.surfaces.at(0).material, Material::brick);
  EXPECT_TRUE(std::any_of(stage.planes.begin(), stage.planes.end(), [](const TruePlane& p) {
    return p.surface_class == "roof";  // nothing names it: it leans
  }));
}

}  // namespace
}  // namespace ilot::scan
