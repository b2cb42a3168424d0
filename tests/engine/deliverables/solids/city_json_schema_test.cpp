// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/city_json_schema.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

using Json = nlohmann::json;

const Json kRoot = Json::parse(R"({"type":"CityJSON","version":"2.0",
  "transform":{"scale":[0.001,0.001,0.001],"translate":[0,0,0]},
  "metadata":{"referenceSystem":"https://www.opengis.net/def/crs/EPSG/0/7415"},
  "CityObjects":{},"vertices":[[0,0,0],[1,2,3]]})");

std::string head_fault(const Json& root) {
  CityJsonHead head;
  const auto faults = check_city_json_head(root, head);
  return faults.empty() ? "" : faults[0].text;
}

// The root with one value replaced; null takes it away.
Json with(const char* pointer, const Json& value) {
  Json root = kRoot;
  root[Json::json_pointer(pointer)] = value;
  if (value.is_null()) root.erase(pointer + 1);
  return root;
}

TEST(CityJsonSchema, Head) {
  EXPECT_EQ(head_fault(kRoot), "");
  EXPECT_EQ(head_fault(with("/version", "3.0")), "version '3.0' is none of 1.0, 1.1, 2.0");
  EXPECT_EQ(head_fault(with("/transform", nullptr)), "transform is missing");
  EXPECT_EQ(head_fault(with("/transform/scale", {1, 1})), "transform.scale is not three numbers");
  EXPECT_EQ(head_fault(with("/vertices/1/2", 0.5)), "vertex 1 is not three whole numbers");
  EXPECT_EQ(head_fault(with("/vertices/1", {1, 2})), "vertex 1 is not three numbers");
  EXPECT_EQ(head_fault(with("/vertices", nullptr)), "vertices is missing or no list");
  EXPECT_EQ(head_fault(with("/CityObjects", nullptr)), "CityObjects is missing or no object");
  EXPECT_EQ(head_fault(with("/metadata/geographicalExtent", {1, 2, 3})),
            "metadata.geographicalExtent is not six numbers");
  EXPECT_NE(head_fault(with("/metadata/referenceSystem", "EPSG:7415")).find("EPSG:7415"), std::string::npos);
  Json old = with("/version", "1.0");
  old.erase("transform");
  old["vertices"][0][0] = 0.25;
  EXPECT_EQ(head_fault(old), "") << "1.0 has coordinates as they are";
}

TEST(CityJsonSchema, Features) {
  CityJsonHead head{"2.0", 0};
  Json feature =
      Json::parse(R"({"type":"CityJSONFeature","id":"b","CityObjects":{"b":{"type":"Building"}},"vertices":[]})");
  EXPECT_TRUE(check_city_json_feature(feature, head).empty());
  feature["id"] = "c";
  EXPECT_EQ(check_city_json_feature(feature, head).at(0).text, "none of the feature's CityObjects has its id");
  feature.erase("id");
  EXPECT_EQ(check_city_json_feature(feature, head).at(0).text, "a CityJSONFeature has no id");
}

std::string object_fault(const char* objects, const char* version = "2.0") {
  const auto faults = check_city_objects(Json::parse(objects), 4, {version, 0});
  return faults.empty() ? "" : faults[0].object + ": " + faults[0].text;
}

TEST(CityJsonSchema, Objects) {
  EXPECT_EQ(object_fault(R"({"b":{"type":"Building","attributes":{},"geometry":[]}})"), "");
  EXPECT_EQ(object_fault(R"({"b":{"type":"+Shed"}})"), "");
  EXPECT_EQ(object_fault(R"({"b":{"type":"Shed"}})"), "b: 'Shed' is no type of city object");
  EXPECT_EQ(object_fault(R"({"b":{}})"), "b: type is missing");
  EXPECT_EQ(object_fault(R"({"b":{"type":"Building","attributes":[]}})"), "b: attributes is no object");
  EXPECT_EQ(object_fault(R"({"b":{"type":"Building","geometry":{}}})"), "b: geometry is no list");
  EXPECT_EQ(object_fault(R"({"b":[]})"), "b: a city object is no object");
}

TEST(CityJsonSchema, Relatives) {
  EXPECT_EQ(object_fault(R"({"b":{"type":"Building","children":["p"]},"p":{"type":"BuildingPart","parents":["b"]}})"),
            "");
  EXPECT_EQ(object_fault(R"({"p":{"type":"BuildingPart"}})"), "p: a BuildingPart has no parents");
  EXPECT_EQ(object_fault(R"({"p":{"type":"BuildingPart"}})", "1.0"), "");
  EXPECT_EQ(object_fault(R"({"b":{"type":"Building","children":["p"]}})"), "b: children names 'p', which is no object");
  EXPECT_EQ(object_fault(R"({"b":{"type":"Building"},"p":{"type":"BuildingPart","parents":["b"]}})"),
            "p: parents names 'b', whose children do not name it");
}

std::string geometry(const char* text, const char* version = "2.0") {
  return geometry_fault(Json::parse(text), 4, {version, 1});
}

TEST(CityJsonSchema, Geometries) {
  EXPECT_EQ(geometry(R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2]]]})"), "");
  EXPECT_EQ(geometry(R"({"type":"Solid","lod":"2.2","boundaries":[[[[0,1,2]]]]})"), "");
  EXPECT_EQ(geometry(R"({"type":"Solid","lod":"2.2","boundaries":[[[0,1,2]]]})"),
            "boundaries: lists are not nested as the type asks");
  EXPECT_EQ(geometry(R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,4]]]})"), "boundaries: 4 is none of 4");
  EXPECT_EQ(geometry(R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,-1]]]})"), "boundaries: -1 is none of 4");
  EXPECT_EQ(geometry(R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,"2"]]]})"),
            "boundaries: \"2\" is none of 4");
  EXPECT_EQ(geometry(R"({"type":"Blob","lod":"2","boundaries":[]})"), "'Blob' is no type of geometry");
  EXPECT_EQ(geometry(R"({"type":"Solid","boundaries":[]})"), "lod is missing");
  EXPECT_EQ(geometry(R"({"type":"Solid","lod":2,"boundaries":[]})"), "lod is not a text from \"0\" to \"3.3\"");
  EXPECT_EQ(geometry(R"({"type":"Solid","lod":2,"boundaries":[]})", "1.0"), "");
  EXPECT_EQ(geometry("3"), "is no object");
}

TEST(CityJsonSchema, Semantics) {
  const std::string start = R"({"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2]],[[0,2,3]]],"semantics":)";
  const auto semantics = [&](const std::string& text) { return geometry((start + text + "}").c_str()); };
  EXPECT_EQ(semantics(R"({"surfaces":[{"type":"RoofSurface"}],"values":[0,null]})"), "");
  EXPECT_EQ(semantics(R"({"surfaces":[{"type":"+Chimney"}],"values":null})"), "");
  EXPECT_EQ(semantics(R"({"surfaces":[{"type":"RoofSurface"}],"values":[0]})"),
            "semantics.values has 1 entries where boundaries has 2");
  EXPECT_EQ(semantics(R"({"surfaces":[{"type":"RoofSurface"}],"values":[0,1]})"), "semantics.values: 1 is none of 1");
  EXPECT_EQ(semantics(R"({"surfaces":[{"type":"Roof"}],"values":[0,0]})"), "'Roof' is no type of surface");
  EXPECT_EQ(semantics(R"({"surfaces":[{}],"values":[0,0]})"), "a semantic surface has no type");
  EXPECT_EQ(semantics(R"({"values":[0,0]})"), "semantics.surfaces is missing or no list");
  EXPECT_EQ(semantics(R"({"surfaces":[]})"), "semantics.values is missing");
  EXPECT_EQ(geometry(R"({"type":"Solid","lod":"2","boundaries":[[[[0,1,2]]]],
                         "semantics":{"surfaces":[{"type":"RoofSurface"}],"values":[[0]]}})"),
            "");
  EXPECT_EQ(geometry(R"({"type":"Solid","lod":"2","boundaries":[[[[0,1,2]]]],
                         "semantics":{"surfaces":[{"type":"RoofSurface"}],"values":[0]}})"),
            "semantics.values: lists are not nested as the type asks");
}

TEST(CityJsonSchema, Instances) {
  const std::string matrix = "[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]";
  const auto instance = [&](const std::string& text) {
    return geometry((R"({"type":"GeometryInstance",)" + text + "}").c_str());
  };
  EXPECT_EQ(instance(R"("template":0,"boundaries":[1],"transformationMatrix":)" + matrix), "");
  EXPECT_EQ(instance(R"("template":1,"boundaries":[1],"transformationMatrix":)" + matrix), "template is none of 1");
  EXPECT_EQ(instance(R"("template":0,"boundaries":[9],"transformationMatrix":)" + matrix),
            "boundaries: 9 is none of 4");
  EXPECT_EQ(instance(R"("template":0,"boundaries":[1],"transformationMatrix":[1])"),
            "transformationMatrix is not 16 numbers");
}

}  // namespace
}  // namespace ilot
