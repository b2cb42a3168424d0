// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/model_file.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

constexpr const char* kCube =
    R"("boundaries":[[[[0,3,2,1]],[[4,5,6,7]],[[0,1,5,4]],[[1,2,6,5]],[[2,3,7,6]],[[3,0,4,7]]]])";
constexpr const char* kCorners = R"([[0,0,0],[1000,0,0],[1000,1000,0],[0,1000,0],[0,0,1000],[1000,0,1000],)"
                                 R"([1000,1000,1000],[0,1000,1000]])";

std::string city(const std::string& objects, const std::string& vertices = kCorners) {
  return R"({"type":"CityJSON","version":"2.0","transform":{"scale":[0.001,0.001,0.001],"translate":[10,20,30]},)"
         R"("CityObjects":{)" +
         objects + R"(},"vertices":)" + vertices + "}";
}

std::string building(const std::string& id, const std::string& more = "") {
  return "\"" + id + R"(":{"type":"Building",)" + more + R"("geometry":[{"type":"Solid","lod":"1.2",)" + kCube + "}]}";
}

std::string model_fault(const std::string& text) {
  try {
    parse_city_json(text, "a.json");
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

std::string obj_fault(const std::string& text) {
  try {
    parse_obj(text, "a.obj", "a");
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

TEST(ModelFile, ReadsGroupsOfAnObj) {
  const ModelFile file = parse_obj(
      "# two buildings\ng 7\nv 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3\no barn\r\nv 0 1 5\nvn 0 0 1\nf 1/1/1 3//1 -1\n"
      "g 7\nf 4 3 2 1\ng empty\n",
      "a.obj", "a");
  ASSERT_EQ(file.models.size(), 2u);
  EXPECT_EQ(file.models[0].name, "7");
  EXPECT_EQ(file.models[0].faces.size(), 2u);
  EXPECT_EQ(file.models[0].vertices.size(), 4u);
  EXPECT_EQ(file.models[1].name, "barn");
  EXPECT_EQ(file.models[1].vertices.back().z, 5);
  EXPECT_EQ(parse_obj("v 0 0 0\nv 1 0 0\nv 1 1 0\nf 1 2 3", "a.obj", "hut").models.at(0).name, "hut");
  EXPECT_TRUE(parse_obj("", "a.obj", "a").models.empty());
}

TEST(ModelFile, OtherFilesAreNoObj) {
  EXPECT_NE(obj_fault(std::string("v 0 0 0\n\0", 9)).find("byte 8 is zero"), std::string::npos);
  EXPECT_NE(obj_fault("x y z\n1 2 3\n").find("another kind of file"), std::string::npos);
  for (const char* text : {"", " \r\n\n", "# none\n", "mtllib a.mtl\n"}) EXPECT_EQ(obj_fault(text), "none") << text;
}

TEST(ModelFile, RefusesBrokenObjsWithThePlace) {
  const std::string start = "v 0 0 0\nv 1 0 0\nv 1 1 0\n";
  EXPECT_EQ(obj_fault(start + "f 1 2 4\n"), "a.obj:4: a face names vertex 4 of 3");
  EXPECT_EQ(obj_fault(start + "f 1 2 0\n"), "a.obj:4: a face names vertex 0 of 3");
  EXPECT_EQ(obj_fault(start + "f 1 2 -4\n"), "a.obj:4: a face names vertex -4 of 3");
  EXPECT_EQ(obj_fault(start + "f 1 2 99999999999999999999\n"),
            "a.obj:4: '99999999999999999999' is no corner of a face");
  EXPECT_EQ(obj_fault(start + "f 1 2\n"), "a.obj:4: a face has fewer than three corners");
  EXPECT_EQ(obj_fault("v 1 nan 2\n"), "a.obj:1: a vertex needs three finite numbers");
  EXPECT_EQ(obj_fault("v 1 2\n"), "a.obj:1: a vertex needs three finite numbers");
  EXPECT_EQ(obj_fault("v 1e999 2 3\n"), "a.obj:1: a vertex needs three finite numbers");
}

TEST(ModelFile, ReadsSolidsWithTheirTransform) {
  const ModelFile file = parse_city_json(city(building("b-1")), "a.json");
  ASSERT_EQ(file.models.size(), 1u);
  EXPECT_EQ(file.models[0].name, "b-1");
  EXPECT_EQ(file.models[0].faces.size(), 6u);
  EXPECT_TRUE(is_closed(file.models[0]));
  EXPECT_EQ(file.models[0].vertices.size(), 8u);
  EXPECT_NEAR(file.models[0].vertices[0].x, 10, 1e-12);
}

TEST(ModelFile, TakesSemanticsThePartsAndTheHighestLevelOfDetail) {
  const std::string surface = R"({"type":"MultiSurface","lod":"2.2","boundaries":[[[4,5,6,7]],[[0,1,5,4]]],)"
                              R"("semantics":{"surfaces":[{"type":"WallSurface"},{"type":"RoofSurface"}],)"
                              R"("values":[1,0]}})";
  const std::string part = R"("p":{"type":"BuildingPart","parents":["b"],"geometry":[{"type":"MultiSurface","lod":1,)"
                           R"("boundaries":[[[0,1,2]]]},)" +
                           surface + "]}";
  const std::string road =
      R"("r":{"type":"Road","geometry":[{"type":"MultiSurface","lod":1,"boundaries":[[[0,1,2]]]}]})";
  const ModelFile file =
      parse_city_json(city(building("b", R"("children":["p"],)") + "," + part + "," + road), "a.json");
  ASSERT_EQ(file.models.size(), 1u);
  ASSERT_EQ(file.models[0].faces.size(), 8u);
  EXPECT_EQ(file.models[0].faces[6].kind, FaceKind::roof);
  EXPECT_EQ(file.models[0].faces[7].kind, FaceKind::wall);
  EXPECT_NE(file.models[0].faces[7].shell, file.models[0].faces[0].shell);
  EXPECT_EQ(parse_city_json(city(road), "a.json").models.at(0).name, "r");  // nothing else is there
}

TEST(ModelFile, ReadsSequences) {
  const std::string feature =
      R"({"type":"CityJSONFeature","id":"f","CityObjects":{)" + building("f") + R"(},"vertices":)" + kCorners + "}";
  const std::string text = city("", "[]") + "\n" + feature + "\n\n";
  const ModelFile file = parse_city_json(text, "a.jsonl");
  ASSERT_EQ(file.models.size(), 1u);
  EXPECT_NEAR(file.models[0].vertices[3].x, 11, 1e-12);
  EXPECT_TRUE(model_fault(city("", "[]") + "\n{\"type\":").starts_with("a.json:2: broken JSON"));
}

TEST(ModelFile, RefusesBrokenCityJson) {
  const auto face = [](const std::string& boundaries) {
    return city(R"("b":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"2","boundaries":)" + boundaries +
                "}]}");
  };
  EXPECT_EQ(model_fault(face("[[[0,1,8]]]")), "a.json: a face names a vertex that is none of 8");
  EXPECT_EQ(model_fault(face("[[[0,1,-1]]]")), "a.json: a face names a vertex that is none of 8");
  EXPECT_EQ(model_fault(face("[[[0,1,1.5]]]")), "a.json: a face names a vertex that is none of 8");
  EXPECT_EQ(model_fault(face("[[0,1,2]]")), "a.json: boundaries are not nested as their type asks");
  EXPECT_EQ(model_fault(face("{}")), "a.json: boundaries are not nested as their type asks");
  EXPECT_EQ(model_fault(face("[[]]")), "a.json: a face has no ring");
  EXPECT_EQ(model_fault(face("[[[0,1]]]")), "a.json: a ring has fewer than three corners");
  EXPECT_EQ(model_fault("[]"), "a.json: neither a CityJSON object nor a CityJSONFeature");
  EXPECT_EQ(model_fault(city("", "[[0,0]]")), "a.json: a vertex needs three numbers");
  EXPECT_EQ(model_fault(city("", R"([[0,0,"x"]])")), "a.json: a vertex needs three finite numbers");
  EXPECT_EQ(model_fault(city("", "7")), "a.json: vertices is missing or no list");
  EXPECT_EQ(model_fault(R"({"type":"CityJSON","vertices":[]})"), "a.json: CityObjects is missing or no object");
  const std::string loop = R"("x":{"type":"BuildingPart","parents":["x"],"geometry":[]})";
  EXPECT_EQ(model_fault(city(loop)), "none");
  EXPECT_EQ(model_fault(std::string(100, '[') + std::string(100, ']')), "a.json: values nest too deeply");
}

TEST(ModelFile, ChoosesByExtension) {
  const TemporaryFolder folder;
  EXPECT_EQ(read_models(folder.put("a.OBJ", "v 0 0 0\nf 1 1 1\n")).models.at(0).name, "a");
  EXPECT_EQ(read_models(folder.put("a.city.json", city(building("b")))).models.size(), 1u);
  EXPECT_TRUE(is_model_file("x/a.OBJ") && is_model_file("a.city.json") && is_model_file("a.city.jsonl"));
  EXPECT_FALSE(is_model_file("a.truth.json") || is_model_file("a.json") || is_model_file("a.laz"));
  EXPECT_THROW(read_models(folder.put("a.stl", "solid")), Error);
  EXPECT_THROW(read_models(folder.path() / "none.obj"), Error);
}

TEST(ModelFile, KeepsSemanticSurfacesAndTheirParents) {
  const std::string text =
      R"({"type":"CityJSON","version":"2.0","metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/7415"},)"
      R"("CityObjects":{"b":{"type":"Building","geometry":[{"type":"MultiSurface","lod":"3",)"
      R"("boundaries":[[[0,1,2]],[[0,1,3]],[[1,2,3]]],"semantics":{"surfaces":[{"type":"WallSurface","id":"w"},)"
      R"({"type":"Window","parent":0}],"values":[0,1,null]}}]}},"vertices":[[0,0,0],[1,0,0],[0,1,0],[0,0,1]]})";
  const ModelFile file = parse_city_json(text, "a.json");
  EXPECT_EQ(file.crs, "EPSG:7415");
  const PolygonModel& model = file.models.at(0);
  const auto surface = [&](std::size_t f) {
    return model.surfaces.at(static_cast<std::size_t>(model.faces[f].surface));
  };
  EXPECT_EQ(surface(0).type, "WallSurface");
  EXPECT_EQ(surface(0).id, "w");
  EXPECT_EQ(surface(1).type, "Window");
  EXPECT_EQ(surface(1).parent, model.faces[0].surface);
  EXPECT_EQ(surface(2).type, "");
  EXPECT_EQ(surface(2).object_type, "Building");
}

TEST(ModelFile, TakesTheWantedLevelOfDetail) {
  const auto geometry = [](const char* lod, const char* ring) {
    return fmt::format(R"({{"type":"MultiSurface","lod":"{}","boundaries":[[{}]]}})", lod, ring);
  };
  const std::string text = R"({"type":"CityJSON","version":"2.0","CityObjects":{"b":{"type":"Building","geometry":[)" +
                           geometry("1.2", "[0,1,2]") + "," + geometry("2.2", "[0,1,2,3]") +
                           R"(]}},"vertices":[[0,0,0],[1,0,0],[1,1,0],[0,1,0]]})";
  EXPECT_EQ(parse_city_json(text, "a.json").models.at(0).faces[0].rings[0].size(), 4u);
  EXPECT_EQ(parse_city_json(text, "a.json", {"1", false}).models.at(0).faces[0].rings[0].size(), 3u);
  EXPECT_EQ(parse_city_json(text, "a.json", {"2.2", false}).models.at(0).faces[0].rings[0].size(), 4u);
  try {
    parse_city_json(text, "a.json", {"3", false});
    FAIL();
  } catch (const Error& error) {
    EXPECT_NE(std::string(error.what()).find("\"1.2\", \"2.2\""), std::string::npos) << error.what();
  }
}

TEST(ModelFile, PutsTemplatesWhereTheirInstancesAre) {
  const auto text = [](const char* number, const char* matrix) {
    return fmt::format(
        R"({{"type":"CityJSON","version":"2.0","transform":{{"scale":[0.5,0.5,0.5],"translate":[100,0,0]}},)"
        R"("geometry-templates":{{"templates":[{{"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2]]]}}],)"
        R"("vertices-templates":[[0,0,0],[1,0,0],[0,1,0]]}},"CityObjects":{{"t":{{"type":"CityFurniture","geometry":)"
        R"([{{"type":"GeometryInstance","template":{},"boundaries":[0],"transformationMatrix":{}}}]}}}},)"
        R"("vertices":[[20,40,6]]}})",
        number, matrix);
  };
  const char* twice = "[2,0,0,1,0,2,0,0,0,0,2,0,0,0,0,1]";
  const ModelFile file = parse_city_json(text("0", twice), "a.json");
  ASSERT_EQ(file.models.size(), 1u);
  EXPECT_NEAR(file.models[0].vertices.at(1).x, 100 + 10 + 2 + 1, 1e-12);
  EXPECT_NEAR(file.models[0].vertices.at(2).y, 20 + 2, 1e-12);
  EXPECT_NEAR(file.models[0].vertices.at(0).z, 3, 1e-12);
  EXPECT_THROW(parse_city_json(text("1", twice), "a.json"), Error);
  EXPECT_THROW(parse_city_json(text("0", "[1,2]"), "a.json"), Error);
}

TEST(ModelFile, KeepsMaterialsOfObj) {
  const ModelFile file = parse_obj(
      "mtllib a.mtl\nv 0 0 0\nv 1 0 0\nv 1 1 0\nusemtl Glass\nf 1 2 3\nusemtl wall\nf -3 -2 -1\n", "a.obj", "a");
  const PolygonModel& model = file.models.at(0);
  ASSERT_EQ(model.surfaces.size(), 2u);
  EXPECT_EQ(model.surfaces[static_cast<std::size_t>(model.faces[0].surface)].material, "Glass");
  EXPECT_EQ(model.surfaces[static_cast<std::size_t>(model.faces[1].surface)].material, "wall");
  EXPECT_EQ(file.material_files, std::vector<std::string>{"a.mtl"});
}

}  // namespace
}  // namespace ilot
