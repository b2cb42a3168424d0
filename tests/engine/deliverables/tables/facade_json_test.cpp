// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/tables/facade_json.h"

#include <gtest/gtest.h>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

Facade written_facade() {
  FacadeElement window{1, "window", true, 1, 2, 3, DrawnStatus::completed, "hidden behind its sill", {}, {}, {}};
  window.ring = {{651000.1, 6861000, 1}, {651001.3, 6861000, 1}, {651001.3, 6861000, 2.2}};
  window.edges = {{DrawnStatus::seen, 40, 0.002, 0.004, 0.01, 0.125, 0.75}, {}, {DrawnStatus::occluded, 0, 0, 0.1, 0}};
  window.arcs = {{{651000.7, 6861000, 2}, 0.6, 0, 180}};
  window.width_m = 1.2;
  window.depth_m = -0.28;
  window.width_error_m = 0.004;
  window.points = 512;
  window.faces = {{"front", 300, 0.003, 0.5}, {"left", 0, 0, {}}};
  FacadeElement sill{2, "sill", false, 0, 0, 0, DrawnStatus::seen, "", {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {}, {}};
  sill.region = FacadeRegion::irregularity;
  sill.body = {false, {{0, 0, 0}, {1, 0, 0}, {1, 0, 1}}, {{0, 1, 2}}};
  return {7, "EPSG:2154", {651000, 6861000, 0}, {1, 0, 0}, {0, 0, 1}, {0, -1, 0}, 12.5, 9, {window, sill}};
}

std::string facade_fault(const std::string& text) {
  try {
    parse_facade_json(text, "f.json");
  } catch (const Error& fault) {
    return fault.what();
  }
  return "none";
}

std::string changed(std::string text, const std::string& from, const std::string& to) {
  const std::size_t at = text.find(from);
  return at == text.npos ? "not there: " + from : text.replace(at, from.size(), to);
}

TEST(FacadeJson, ReadsBackWhatItWrote) {
  const TemporaryFolder folder;
  const std::filesystem::path path = folder.path() / "facade-007.json";
  write_facade_json(path, written_facade());
  const Facade read = read_facade_json(path);
  EXPECT_EQ(facade_json(read), facade_json(written_facade()));
  EXPECT_EQ(read.id, 7u);
  EXPECT_EQ(read.out.y, -1);
  ASSERT_EQ(read.elements.size(), 2u);
  const FacadeElement& window = read.elements[0];
  EXPECT_EQ(window.kind, "window");
  EXPECT_TRUE(window.opening);
  EXPECT_EQ(window.status, DrawnStatus::completed);
  EXPECT_EQ(window.ring[1].x, 651001.3);
  EXPECT_EQ(window.edges[2].status, DrawnStatus::occluded);
  EXPECT_EQ(window.edges[0].points, 40u);
  EXPECT_EQ(window.edges[0].occluded_share, 0.125);
  EXPECT_FALSE(window.edges[1].occluded_share);
  EXPECT_EQ(window.edges[0].covered_share, 0.75);
  ASSERT_EQ(window.faces.size(), 2u);
  EXPECT_EQ(window.faces[0].name, "front");
  EXPECT_EQ(window.faces[0].points, 300u);
  EXPECT_EQ(window.faces[0].occluded_share, 0.5);
  EXPECT_FALSE(window.faces[1].occluded_share);
  EXPECT_EQ(window.arcs.at(0).radius_m, 0.6);
  EXPECT_EQ(window.depth_m, -0.28);
  EXPECT_EQ(window.region, FacadeRegion::element);
  EXPECT_TRUE(window.body.vertices.empty());
  EXPECT_EQ(read.elements[1].region, FacadeRegion::irregularity);
  EXPECT_EQ(read.elements[1].body.faces, (std::vector<std::vector<std::uint32_t>>{{0, 1, 2}}));
  EXPECT_EQ(read.elements[1].body.vertices.at(2).z, 1);
}

TEST(FacadeJson, RefusesWhatIsNoFacade) {
  const std::string good = facade_json(written_facade());
  ASSERT_EQ(facade_fault(good), "none");
  EXPECT_TRUE(facade_fault("{").starts_with("f.json: broken JSON: "));
  EXPECT_EQ(facade_fault("[]"), "f.json: 'type' is missing");
  EXPECT_EQ(facade_fault(changed(good, "\"version\": 1", "\"version\": 2")), "f.json: no facade of version 1");
  EXPECT_EQ(facade_fault(changed(good, "\"completed\"", "\"guessed\"")),
            "f.json.elements[0].status: 'guessed' is no status: seen, completed, occluded or by hand");
  EXPECT_EQ(facade_fault(changed(good, "\"points\": 512", "\"points\": -1")),
            "f.json.elements[0].points: needs a whole number from 0 on");
  EXPECT_EQ(facade_fault(changed(good, "\"width_m\": 12.5", "\"width_m\": null")),
            "f.json.width_m: needs a finite number");
  EXPECT_EQ(facade_fault(changed(good, "\"row\": 2", "\"row\": 4294967296")),
            "f.json.elements[0].row: needs a whole number below 2^32");
  EXPECT_EQ(facade_fault(changed(good, "\"opening\": true", "\"opening\": 1")),
            "f.json.elements[0].opening: needs true or false");
  EXPECT_EQ(facade_fault(changed(good, "\"irregularity\"", "\"odd\"")),
            "f.json.elements[1].region: 'odd' is no region: facade, element or irregularity");
  std::string strange = good;
  strange.replace(strange.rfind("2\n"), 1, "3");
  EXPECT_EQ(facade_fault(strange), "f.json.elements[1].body.faces[0]: names a vertex that is not there");
}

}  // namespace
}  // namespace ilot
