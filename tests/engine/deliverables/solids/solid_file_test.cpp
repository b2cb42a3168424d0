// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/solid_file.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

struct Read {
  std::vector<CityObject> objects;
  std::vector<FormatFault> faults;
};

Read read(const std::string& name, const std::string& text) {
  const TemporaryFolder folder;
  std::ofstream(folder.path() / name, std::ios::binary) << text;
  Read r;
  read_solids(folder.path() / name, {[&](const CityObject& o) { r.objects.push_back(o); },
                                     [&](const FormatFault& f) { r.faults.push_back(f); }});
  return r;
}

std::string solid_fault(CityObject (*parse)(std::string_view, const std::string&), const std::string& text) {
  try {
    parse(text, "a");
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

TEST(SolidFile, ReadsOff) {
  const CityObject o = parse_off("OFF # a comment\n4 2 0\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 1 2 255 0 0\n3 0 2 3\n", "a");
  ASSERT_EQ(o.primitives.size(), 1u);
  EXPECT_EQ(o.vertices.size(), 4u);
  const SolidShell& shell = o.primitives[0].solids[0][0];
  ASSERT_EQ(shell.size(), 2u);
  EXPECT_EQ(shell[1].rings, (FaceRings{{0, 2, 3}}));
  EXPECT_EQ(solid_fault(parse_off, "OF\n1 1 1"), "a:1: an OFF file begins with OFF");
  EXPECT_EQ(solid_fault(parse_off, "OFF\n1 1 1\n0 0 0\n3 0 0 7"), "a:4: '7' is no number of a vertex");
  EXPECT_EQ(solid_fault(parse_off, "OFF\n99999999999 1 1\n"), "a:2: '99999999999' is no number of vertices");
  EXPECT_EQ(solid_fault(parse_off, "OFF\n1 0 0\n0 0 nan"), "a:3: 'nan' is no number");
}

TEST(SolidFile, ReadsPolyWithHolesAndInnerShells) {
  const std::string shell =
      "3 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n2 0\n2 1\n3 0 1 2\n3 2 1 0\n0 0.1 0.1 0\n1 0\n3 0 1 2\n0\n0\n";
  const CityObject o = parse_poly(shell + shell, "a");
  ASSERT_EQ(o.primitives[0].solids[0].size(), 2u);
  EXPECT_EQ(o.primitives[0].solids[0][0][0].rings, (FaceRings{{0, 1, 2}, {2, 1, 0}}));
  EXPECT_EQ(o.primitives[0].solids[0][1][1].rings, (FaceRings{{3, 4, 5}}));
  EXPECT_EQ(solid_fault(parse_poly, "3 3 0 0\n0 0 0 0\n"), "a:3: the file ends too early");
}

TEST(SolidFile, ReadsWhatFollowsTheCountsOfThePolyAsNothing) {
  const CityObject o = parse_poly("3 3 0 0\n0 0 0 0\n1 1 0 0\n2 0 1 0\n1 0\n1 0\n3 0 1 2\n1 0\n3 2 1 0\n0\n0\n", "a");
  EXPECT_EQ(o.primitives[0].solids[0].size(), 1u);
  EXPECT_EQ(o.primitives[0].solids[0][0].size(), 1u);
}

constexpr const char* kHead =
    R"("type":"CityJSON","version":"2.0","transform":{"scale":[0.5,0.5,0.5],"translate":[10,20,30]})";
constexpr const char* kVertices = R"("vertices":[[0,0,0],[2,0,0],[0,2,0]])";

TEST(SolidFile, GathersPartsUnderTheirBuilding) {
  const Read r = read("a.city.json", std::string("{") + kHead + R"(,"CityObjects":{
    "b":{"type":"Building","children":["p"],"geometry":[{"type":"MultiSurface","lod":"0","boundaries":[[[0,1,2]]]}]},
    "p":{"type":"BuildingPart","parents":["b"],"geometry":[{"type":"Solid","lod":"2.2","boundaries":[[[[2,1,0]]]]}]},
    "r":{"type":"Road","geometry":[{"type":"MultiLineString","lod":"1","boundaries":[[0,1]]}]}},)" +
                                         kVertices + "}");
  EXPECT_TRUE(r.faults.empty());
  ASSERT_EQ(r.objects.size(), 2u);
  EXPECT_EQ(r.objects[0].id, "b");
  ASSERT_EQ(r.objects[0].primitives.size(), 2u);
  EXPECT_EQ(r.objects[0].primitives[0].kind, PrimitiveKind::multi_surface);
  EXPECT_EQ(r.objects[0].primitives[1].owner, "p");
  EXPECT_EQ(r.objects[0].primitives[1].lod, "2.2");
  EXPECT_EQ(r.objects[0].vertices[1].x, 11);
  EXPECT_EQ(r.objects[0].vertices[1].z, 30);
  EXPECT_TRUE(r.objects[1].primitives.empty());
}

TEST(SolidFile, ReadsSequencesLineByLine) {
  const std::string head = std::string("{") + kHead + R"(,"CityObjects":{},"vertices":[]})" + "\n";
  const std::string feature =
      std::string(R"({"type":"CityJSONFeature","id":"b","CityObjects":{"b":{"type":"Building",)") +
      R"("geometry":[{"type":"Solid","lod":"1","boundaries":[[[[0,1,2]]]]}]}},)" + kVertices + "}\n";
  const Read r = read("a.city.jsonl", head + feature + "\n" + feature);
  EXPECT_TRUE(r.faults.empty());
  ASSERT_EQ(r.objects.size(), 2u);
  EXPECT_EQ(r.objects[1].vertices[0].y, 20);
  EXPECT_FALSE(read("a.city.jsonl", feature).faults.empty()) << "no head";
  EXPECT_THROW(read("a.city.jsonl", head + "{"), Error);
}

TEST(SolidFile, PutsTemplatesInPlaceOfInstances) {
  const Read r = read("a.json", std::string("{") + kHead + R"(,"CityObjects":{"t":{"type":"CityFurniture","geometry":[
    {"type":"GeometryInstance","template":0,"boundaries":[0],"transformationMatrix":[1,0,0,0,0,1,0,0,0,0,1,0,0,0,0,1]}]}},
    "geometry-templates":{"templates":[{"type":"MultiSurface","lod":"2","boundaries":[[[0,1,2]]]}],
      "vertices-templates":[[0,0,0],[0.5,0,0],[0,0.5,0]]},)" +
                                    kVertices + "}");
  EXPECT_TRUE(r.faults.empty()) << r.faults[0].text;
  ASSERT_EQ(r.objects.size(), 1u);
  ASSERT_EQ(r.objects[0].primitives.size(), 1u);
  EXPECT_EQ(r.objects[0].vertices[1].x, 0.5);
}

TEST(SolidFile, KnowsItsNames) {
  for (const char* name : {"a.obj", "a.OFF", "a.poly", "a.json", "a.city.jsonl"})
    EXPECT_TRUE(is_solid_file(name)) << name;
  for (const char* name : {"a.las", "a", "a.dxf"}) EXPECT_FALSE(is_solid_file(name)) << name;
}

}  // namespace
}  // namespace ilot
