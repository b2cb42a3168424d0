// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/truth.h"

#include <gtest/gtest.h>

#include "engine/error.h"

namespace ilot {
namespace {

std::string fault_of(const std::string& text) {
  try {
    parse_truth(text, "t.json");
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

TEST(Truth, ReadsWhatIsThere) {
  const Truth t = parse_truth(
      R"({"scan":{},"classes":{"0":"mixed","3":"wall"},
      "planes":[{"id":7,"class":"wall","plane":[0,2,0,-8],"points":5,"polygons":[{"building":4,
        "ring":[[0,4,0],[1,4,0],[1,4,1]],"holes":[[[0,4,0],[1,4,0],[1,4,1]]]}]},{"id":8,"plane":[0,0,1,0]}],
      "elements":[{"id":3,"kind":"window","facade":2,"row":1,"column":4,"depth_m":-0.2,
        "ring":[[0,4,0],[1,4,0],[1,4,1]]},{"id":5}],
      "openings":[{"id":1,"facade":2,"ring":[[0,4,0],[1,4,0],[1,4,1]]}],
      "control_points":[{"group":"window_top","element":3,"position":[1,2,3]}],
      "objects":[{"id":9,"class":"car","points":77}],"buildings":[{"id":4}],"blocks":[1,2],"unknown":null})",
      "t.json");
  EXPECT_EQ(t.classes.at(3), "wall");
  ASSERT_EQ(t.planes.size(), 2u);
  EXPECT_EQ(t.planes[0].plane.n.y, 1);  // made a unit normal
  EXPECT_EQ(t.planes[0].plane.d, -4);
  EXPECT_EQ(t.planes[0].polygons.at(0).building, 4u);
  EXPECT_EQ(t.planes[0].polygons.at(0).holes.size(), 1u);
  ASSERT_EQ(t.elements.size(), 2u);
  EXPECT_EQ(t.elements[0].kind, "window");
  EXPECT_EQ(t.elements[0].facade, 2u);
  EXPECT_EQ(t.elements[0].column, 4u);
  EXPECT_EQ(t.elements[0].depth_m, -0.2);
  EXPECT_EQ(t.elements[0].ring.size(), 3u);
  EXPECT_TRUE(t.elements[1].ring.empty());
  EXPECT_EQ(t.openings.at(0).facade, 2u);
  EXPECT_EQ(t.control_points.at(0).position.z, 3);
  EXPECT_EQ(t.objects.at(0).points, 77u);
  EXPECT_TRUE(t.has_buildings && t.has_objects && t.has_openings && t.has_control_points);
}

TEST(Truth, TakesAnEmptyOneAndCountsOfBuildings) {
  const Truth t = parse_truth(R"({"points":30000,"buildings":12})", "t.json");
  EXPECT_TRUE(t.planes.empty());
  EXPECT_FALSE(t.has_buildings);
  EXPECT_TRUE(parse_truth(R"({"objects":[]})", "t.json").has_objects);
}

TEST(Truth, TakesTheRoofsOfModels) {
  const PolygonModel hut{"hut",
                         {{0, 0, 0}, {4, 0, 0}, {4, 4, 0}, {0, 4, 0}, {0, 0, 3}, {4, 0, 3}, {4, 4, 3}, {0, 4, 3}},
                         {{{{0, 3, 2, 1}}, FaceKind::unknown, 0},
                          {{{4, 5, 6, 7}}, FaceKind::unknown, 0},
                          {{{0, 1, 5, 4}}, FaceKind::unknown, 0}}};
  const Truth t = truth_of_models(std::vector<PolygonModel>{{"empty", {}, {}}, hut});
  EXPECT_TRUE(t.has_buildings);
  EXPECT_EQ(t.buildings.size(), 2u);
  ASSERT_EQ(t.planes.size(), 1u);
  EXPECT_EQ(t.planes[0].class_name, "roof");
  EXPECT_EQ(t.planes[0].plane.n.z, 1);
  EXPECT_EQ(t.planes[0].plane.d, -3);
  EXPECT_EQ(t.planes[0].polygons.at(0).building, 2u);
}

TEST(Truth, NamesThePlaceOfAFault) {
  EXPECT_TRUE(fault_of("{\"planes\":").starts_with("t.json: broken JSON: "));
  EXPECT_EQ(fault_of("[1]"), "t.json: needs a JSON object");
  EXPECT_EQ(fault_of(R"({"planes":3})"), "t.json.planes: needs a list");
  EXPECT_EQ(fault_of(R"({"planes":[{"id":-1}]})"), "t.json.planes[0].id: needs a whole number from 0 on");
  EXPECT_EQ(fault_of(R"({"planes":[{"id":4294967296}]})"), "t.json.planes[0].id: needs a whole number below 2^32");
  EXPECT_EQ(fault_of(R"({"planes":[{"id":1}]})"), "t.json.planes[0]: 'plane' is missing");
  EXPECT_EQ(fault_of(R"({"planes":[{"id":1,"plane":[0,0,0,1]}]})"),
            "t.json.planes[0].plane: needs a, b, c, d of a plane");
  EXPECT_EQ(fault_of(R"({"planes":[{"id":1,"plane":[0,0,1]}]})"),
            "t.json.planes[0].plane: needs a, b, c, d of a plane");
  EXPECT_EQ(fault_of(R"({"openings":[{"id":1,"ring":[[0,0,0]]}]})"),
            "t.json.openings[0].ring: needs three corners or more");
  EXPECT_EQ(fault_of(R"({"control_points":[{"group":"a","position":[0,"x",0]}]})"),
            "t.json.control_points[0].position: needs a finite number");
  EXPECT_EQ(fault_of(R"({"classes":{"wall":"3"}})"), "t.json.classes: 'wall' is no class from 0 to 255");
  EXPECT_EQ(fault_of(R"({"objects":[{"id":1,"class":7}]})"), "t.json.objects[0].class: needs a text");
  EXPECT_THROW(read_truth("/none/such.truth.json"), Error);
}

}  // namespace
}  // namespace ilot
