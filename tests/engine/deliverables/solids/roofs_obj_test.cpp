// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/roofs_obj.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>

#include "engine/deliverables/solids/model_file.h"
#include "engine/validity/validate_models.h"
#include "tests/support/buildings.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

TEST(RoofsObj, ReadsBackAsGroupsThatAreValid) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "roofs.obj";
  RoofsObj obj(path, {{652000, 6862000, 0}, 0.0001});
  Building low = gable_house("7", {652000.12345, 6862000.5, 35});
  low.lod = "1.2";
  obj.add(std::vector<Building>{low, gable_house("7", {652000.12345, 6862000.5, 35})});
  obj.add(std::vector<Building>{court_house("a court")});
  obj.add(std::vector<Building>{Building{"none", "2.2", {}, {}, {}}});
  Building outline = gable_house("outline", {});
  outline.lod = "0";
  obj.add(std::vector<Building>{outline});
  EXPECT_FALSE(std::filesystem::exists(path));
  obj.finish();
  const ModelFile file = read_models(path);
  ASSERT_EQ(file.models.size(), 2u);
  EXPECT_EQ(file.models[0].name, "7");
  EXPECT_EQ(file.models[0].vertices.size(), 10u) << "the highest level alone";
  EXPECT_EQ(file.models[0].vertices[0].x, 652000.1234);
  EXPECT_EQ(file.models[1].name, "a_court");
  EXPECT_EQ(file.models[1].faces.size(), 8u + 16u) << "two faces with a hole: eight triangles each";
  EXPECT_TRUE(validate_models(path, [](const ObjectValidity&) {}).valid());
}

TEST(RoofsObj, NamesItsMaterials) {
  const TemporaryFolder folder;
  RoofsObj obj(folder.path() / "roofs.obj", {});
  obj.add(std::vector<Building>{gable_house("a", {})});
  obj.finish();
  const auto text_of = [&](const char* name) {
    std::ifstream file(folder.path() / name);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  const std::string obj_text = text_of("roofs.obj"), materials = text_of("roofs.mtl");
  EXPECT_TRUE(obj_text.starts_with("mtllib roofs.mtl\ng a\nv 0.0000 0.0000 0.0000\n"));
  for (const std::string name : {"roof", "wall", "ground"}) {
    EXPECT_NE(obj_text.find("usemtl " + name + "\nf "), std::string::npos) << name;
    EXPECT_NE(materials.find("newmtl " + name + "\n"), std::string::npos) << name;
  }
}

}  // namespace
}  // namespace ilot
