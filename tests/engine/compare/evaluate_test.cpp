// SPDX-License-Identifier: Apache-2.0
// A whole evaluation of results made by hand: a cloud with truth and labels, planes.csv, a facade, roofs.
#include "engine/compare/evaluate.h"

#include <gtest/gtest.h>

#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/compare/evaluation_report.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/deliverables/tables/planes_csv.h"
#include "engine/error.h"
#include "engine/formats/writer.h"
#include "tests/support/facades.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

struct LabelledPoint {
  Vec3 place;
  std::uint8_t true_class = 0;
  std::uint32_t true_plane = 0, true_element = 0, plane_id = 0, object_id = 0;
  std::uint8_t label = 0, boundary = 0;
  std::uint32_t shape_id = 0;
};

void write_cloud(const std::filesystem::path& path, const std::vector<LabelledPoint>& points) {
  CloudSpec spec;
  spec.like.layout.point_format = 6;
  spec.like.layout.record_length = 30;
  const auto field = [](const char* name, FieldType type, std::uint16_t size) {
    return ExtraField{name, "", type, 0, size, 1, 0};
  };
  spec.appended = {field("true_class", FieldType::u8, 1),    field("true_plane", FieldType::u32, 4),
                   field("true_element", FieldType::u32, 4), field("plane_id", FieldType::u32, 4),
                   field("object_id", FieldType::u32, 4),    field("label", FieldType::u8, 1),
                   field("boundary", FieldType::u8, 1),      field("shape_id", FieldType::u32, 4)};
  std::filesystem::create_directories(path.parent_path());
  const std::unique_ptr<PointWriter> writer = create_cloud(path, spec);
  for (const LabelledPoint& p : points) {
    std::vector<std::byte> record(writer->record_length());
    store<std::int32_t>(&record[0], static_cast<std::int32_t>(std::lround(p.place.x * 1000)));
    store<std::int32_t>(&record[4], static_cast<std::int32_t>(std::lround(p.place.y * 1000)));
    store<std::int32_t>(&record[8], static_cast<std::int32_t>(std::lround(p.place.z * 1000)));
    record[14] = std::byte{0x11};
    store(&record[30], p.true_class);
    store(&record[31], p.true_plane);
    store(&record[35], p.true_element);
    store(&record[39], p.plane_id);
    store(&record[43], p.object_id);
    store(&record[47], p.label);
    store(&record[48], p.boundary);
    store(&record[49], p.shape_id);
    writer->write(record);
  }
  writer->finish();
}

// A wall of 4 x 4 m in the plane y = 0, points every half metre, plane 5 of the truth and 9 of the result; its lowest
// row is not found. The boundary is marked all around what was found.
std::vector<LabelledPoint> wall() {
  std::vector<LabelledPoint> points;
  for (int column = 0; column < 8; ++column)
    for (int row = 0; row < 8; ++row) {
      LabelledPoint p{{0.25 + 0.5 * column, 0, 0.25 + 0.5 * row}, 1, 5};
      if (row > 0) p.plane_id = 9;
      p.boundary = row == 1 || row == 7 || (row > 0 && (column == 0 || column == 7));
      points.push_back(p);
    }
  return points;
}

Truth wall_truth() {
  return parse_truth(R"({"classes":{"1":"wall","2":"car"},
    "planes":[{"id":5,"class":"wall","plane":[0,-1,0,0],"polygons":[{"ring":[[0,0,0],[4,0,0],[4,0,4],[0,0,4]]}]},
      {"id":6,"class":"roof","plane":[0,0,1,-4],"polygons":[{"building":1,"ring":[[0,0,4],[4,0,4],[4,4,4],[0,4,4]]}]}],
    "openings":[{"id":1,"ring":[[1,0,1],[2,0,1],[2,0,3],[1,0,3]]}],
    "control_points":[{"group":"window_top","position":[1,0,3]},{"group":"sill_top","position":[1,0,1]}],
    "buildings":[{"id":1}],"objects":[{"id":40,"class":"car","points":10}]})",
                     "t.json");
}

TEST(Evaluate, JudgesEverythingThatIsThere) {
  const TemporaryFolder out;
  std::vector<LabelledPoint> points = wall();
  for (int i = 0; i < 10; ++i) points.push_back({{9 + 0.1 * i, 5, 0}, 2, 0, 40, 0, 3, 0, 0});
  write_cloud(out.path() / "points" / "a.las", points);
  Segment found;
  found.id = 9;
  found.plane = {{0, 1, 0}, -0.01};
  found.centroid = {2, 0.01, 2};
  write_planes_csv(out.path() / "planes.csv", std::vector<Segment>{found});
  std::filesystem::create_directories(out.path() / "facades");
  write_facade_json(out.path() / "facades" / "facade-001.json",
                    facade_of({drawn("window", wall_rectangle(1, 1, 2, 3.02))}));
  out.put("roofs/roofs.obj", "g 1\nv 0 0 4\nv 4 0 4\nv 4 4 4\nv 0 4 4\nf 1 2 3 4\n");

  Evaluation e = evaluate(out.path(), wall_truth());
  e.truth = "t.json";
  ASSERT_TRUE(e.confusion && e.planes && e.boundary && e.control_points && e.openings && e.roofs && e.objects);
  EXPECT_EQ(e.class_source, ClassSource::segments);
  EXPECT_EQ(e.confusion->counts, (std::vector<std::vector<std::uint64_t>>{{56, 0, 8}, {0, 0, 10}}));
  EXPECT_EQ(e.planes->matching.matches.size(), 1u);
  EXPECT_EQ(e.planes->errors->planes, 1u);
  EXPECT_NEAR(e.planes->errors->offset_m.mean, 0.01, 1e-12);
  // True edge: 28 points. Marked: 26, of which the row above the lowest one shares its two ends.
  EXPECT_EQ(e.boundary->truth, 28u);
  EXPECT_EQ(e.boundary->found, 26u);
  EXPECT_EQ(e.boundary->common, 20u);
  EXPECT_EQ(e.control_points->at(0).drawn, 1u);
  EXPECT_NEAR(e.control_points->at(0).dz_m.mean, 0.02, 1e-12);
  EXPECT_EQ(e.control_points->at(1).missed, 1u);
  EXPECT_EQ(e.openings->matched, 1u);
  EXPECT_EQ(e.roofs->result.matched_faces, 1u);
  EXPECT_EQ(e.roofs->closed, 0u);
  EXPECT_EQ(e.objects->detected, 1u);

  const auto json = nlohmann::json::parse(evaluation_json(e));
  EXPECT_DOUBLE_EQ(json["confusion"]["global_sensitivity"].get<double>(), 56.0 / 74);
  EXPECT_EQ(json["confusion"]["matrix"], (nlohmann::json{{56, 0}, {0, 0}}));
  EXPECT_EQ(json["confusion"]["undetected"], (nlohmann::json{8, 10}));
  EXPECT_TRUE(json["confusion"]["precision"][1].is_null());
  EXPECT_NEAR(json["planes"]["offset_m"].get<double>(), 0.01, 1e-12);
  EXPECT_DOUBLE_EQ(json["boundary"]["error"].get<double>(), 14.0 / 20);
  EXPECT_EQ(json["control_points"]["groups"][1]["missed"], 1);
  EXPECT_TRUE(json["control_points"]["groups"][1]["mean_m"].is_null());
  EXPECT_EQ(json["openings"]["invented"], 0);
  EXPECT_EQ(json["roofs"]["faces_true"], 1);
  EXPECT_EQ(json["objects"]["false"], 0);
  EXPECT_EQ(json["objects"]["confusion"]["classes"], (nlohmann::json{"car", "unlabelled"}));

  const std::string text = evaluation_text(e);
  EXPECT_NE(text.find("  wall               56    0           8     64       87.5 %\n"), std::string::npos) << text;
  EXPECT_NE(text.find("boundary error E 0.700"), std::string::npos) << text;
  const std::string html = evaluation_html(e);
  EXPECT_TRUE(html.starts_with("<section id=\"truth\""));
  EXPECT_EQ(html.find("http"), std::string::npos);
}

// A column of the truth's numbering of planes, found as shape 9: another segment than plane 9.
TEST(Evaluate, ShapesAreSegmentsOfTheirOwn) {
  const TemporaryFolder out;
  std::vector<LabelledPoint> points = wall();
  for (LabelledPoint& p : points)
    if (p.plane_id == 0) {
      p.true_class = 2;
      p.true_plane = 7;
      p.shape_id = 9;
    }
  write_cloud(out.path() / "a.las", points);
  const Evaluation e = evaluate(out.path() / "a.las", {});
  EXPECT_EQ(e.confusion->counts, (std::vector<std::vector<std::uint64_t>>{{56, 0, 0}, {0, 8, 0}}));
  EXPECT_EQ(e.planes->matching.matches.size(), 2u);
  EXPECT_EQ(e.planes->matching.carrying, 64u);
}

TEST(Evaluate, TakesClassesFromLabelsWhereThereAreAny) {
  const TemporaryFolder out;
  std::vector<LabelledPoint> points = wall();
  for (std::size_t i = 0; i < points.size(); ++i) points[i].label = i < 60 ? 3 : 0;  // wall
  write_cloud(out.path() / "a.las", points);
  const Evaluation e = evaluate(out.path() / "a.las", wall_truth());
  EXPECT_EQ(e.class_source, ClassSource::labels);
  EXPECT_EQ(e.confusion->counts, (std::vector<std::vector<std::uint64_t>>{{60, 4}}));
  EXPECT_FALSE(e.planes->errors.has_value());
  EXPECT_FALSE(e.openings || e.roofs);
  EXPECT_EQ(e.notes.size(), 2u);
}

TEST(Evaluate, WorksFromExtraBytesAlone) {
  const TemporaryFolder out;
  write_cloud(out.path() / "a.las", wall());
  EvaluateParams params;
  const Evaluation e = evaluate(out.path() / "a.las", {}, params);
  EXPECT_EQ(e.confusion->classes, std::vector<std::string>{"1"});
  EXPECT_EQ(e.planes->matching.carrying, 56u);
  EXPECT_FALSE(e.boundary || e.objects || e.roofs || e.control_points);
  params.min_points = 65;
  EXPECT_EQ(evaluate(out.path() / "a.las", {}, params).planes->matching.true_planes, 0u);
}

TEST(Evaluate, RefusesEmptyInput) {
  const TemporaryFolder out;
  EXPECT_THROW(evaluate(out.path(), wall_truth()), Error);
  EXPECT_THROW(evaluate(out.path() / "none", wall_truth()), Error);
  CloudSpec bare;
  const auto writer = create_cloud(out.path() / "bare.las", bare);
  writer->write(std::vector<std::byte>(writer->record_length()));
  writer->finish();
  EXPECT_THROW(evaluate(out.path() / "bare.las", wall_truth()), Error);
}

TEST(Evaluate, EscapesNamesInPages) {
  Evaluation e;
  e.result = "<script>&\"";
  e.confusion = ConfusionMatrix{{"a<b"}, {{1, 0}}};
  const std::string html = evaluation_html(e);
  EXPECT_EQ(html.find("<script>"), std::string::npos);
  EXPECT_NE(html.find("&lt;script&gt;&amp;&quot;"), std::string::npos);
  EXPECT_NE(html.find("a&lt;b"), std::string::npos);
}

}  // namespace
}  // namespace ilot
