// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/roofs/wireframe.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "engine/compare/roofs/assignment.h"
#include "engine/compare/roofs/wireframe_report.h"
#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

constexpr Vec3 kAnchor{538094, 6584173, 0};

// A gable over [x0, x0 + 6] x [0, 10], eaves at 5 m, ridge at 8 m; seven edges.
PolygonModel gabled(double x0, const std::string& name = "gable") {
  PolygonModel model{name, {}, {}};
  for (const Vec3 p : {Vec3{x0, 0, 5}, Vec3{x0 + 3, 0, 8}, Vec3{x0 + 6, 0, 5}, Vec3{x0 + 6, 10, 5}, Vec3{x0 + 3, 10, 8},
                       Vec3{x0, 10, 5}})
    model.vertices.push_back(kAnchor + p);
  model.faces.push_back({{{0, 1, 4, 5}}, FaceKind::roof, 0});
  model.faces.push_back({{{1, 2, 3, 4}}, FaceKind::roof, 0});
  return model;
}

Wireframe wireframe_of(const PolygonModel& model) {
  Wireframe wireframe{model.name, {}, 0};
  for (const RoofEdge& edge : roof_edges(model)) wireframe.edges.push_back(edge.edge);
  wireframe.radius = radius_of(wireframe.edges);
  return wireframe;
}

std::vector<RoofEdge> moved(std::vector<RoofEdge> edges, Vec3 by) {
  for (RoofEdge& e : edges) e.edge = {e.edge.a + by, e.edge.b + by};
  return edges;
}

TEST(Wireframe, TheSameEdgesAreAllRight) {
  const Wireframe truth = wireframe_of(gabled(0));
  ASSERT_EQ(truth.edges.size(), 7u);
  EXPECT_NEAR(truth.radius, std::hypot(3, 5, 8 - 41.0 / 7), 1.0);
  std::vector<RoofEdge> drawn = roof_edges(gabled(0));
  std::reverse(drawn.begin(), drawn.end());
  for (RoofEdge& e : drawn) std::swap(e.edge.a, e.edge.b);  // neither order nor direction matters
  const EdgeScore score = compare_edges(truth, drawn, false);
  EXPECT_EQ(*score.f1(), 1);
  EXPECT_EQ(*score.f1_close(), 1);
  EXPECT_EQ(*score.precision(), 1);
  EXPECT_EQ(*score.recall(), 1);
  EXPECT_NEAR(*score.corner_offset_m(), 0, 1e-9);
  EXPECT_EQ(score.short_edges, 0u);
}

TEST(Wireframe, MissingAndInventedEdgesCount) {
  Wireframe truth = wireframe_of(gabled(0));
  truth.edges.push_back({kAnchor + Vec3{0, 0, 0}, kAnchor + Vec3{6, 0, 0}});  // eight of them
  std::vector<RoofEdge> drawn;
  for (std::size_t i = 0; i < 8; i += 2) drawn.push_back({truth.edges[i], false, false});
  const EdgeScore half = compare_edges(truth, drawn, false);
  EXPECT_EQ(*half.recall(), 0.5);
  EXPECT_EQ(*half.precision(), 1);
  EXPECT_NEAR(*half.f1(), 2.0 / 3, 1e-12);
  for (std::size_t i = 1; i < 8; i += 2) drawn.push_back({truth.edges[i], false, false});
  for (int i = 0; i < 8; ++i)  // far from all of them
    drawn.push_back({{kAnchor + Vec3{40.0 + i, 0, 5}, kAnchor + Vec3{40.0 + i, 0.3, 5}}, false, false});
  const EdgeScore doubled = compare_edges(truth, drawn, false);
  EXPECT_EQ(*doubled.recall(), 1);
  EXPECT_EQ(*doubled.precision(), 0.5);
  EXPECT_EQ(*doubled.drawn_over_true(), 2);
  EXPECT_EQ(doubled.short_edges, 8u);
  EXPECT_EQ(compare_edges(truth, {}, false).f1(), 0.0);
  EXPECT_FALSE(compare_edges(truth, {}, false).precision());
}

TEST(Wireframe, AnEdgeThatIsDrawnTwiceIsRightOnce) {
  const Wireframe truth = wireframe_of(gabled(0));
  std::vector<RoofEdge> drawn = roof_edges(gabled(0)), again = drawn;
  drawn.insert(drawn.end(), again.begin(), again.end());
  EXPECT_EQ(*compare_edges(truth, drawn, false).precision(), 0.5);
}

TEST(Wireframe, ToleranceEndsAtATenthOfTheRadius) {
  Wireframe truth = wireframe_of(gabled(0));
  truth.radius = 5;
  const std::vector<RoofEdge> drawn = roof_edges(gabled(0));
  const EdgeScore within = compare_edges(truth, moved(drawn, {0, 0, 0.499}), false);
  EXPECT_EQ(*within.f1(), 1);
  EXPECT_EQ(*within.f1_close(), 0);
  EXPECT_NEAR(*within.corner_offset_m(), 0.499, 1e-6);
  const EdgeScore beyond = compare_edges(truth, moved(drawn, {0, 0, 0.501}), false);
  EXPECT_EQ(*beyond.f1(), 0);
  EXPECT_FALSE(beyond.corner_offset_m());
  EXPECT_EQ(*compare_edges(truth, moved(drawn, {0, 0, 0.299}), false).f1_close(), 1);
  // The same in feet: all lengths and the radius are in the units of the coordinates.
  EXPECT_EQ(*compare_edges(truth, moved(drawn, {0, 0, 0.499}), false, 0.3048).f1_close(), 1);
}

TEST(Wireframe, StraightCornersAndCommonEdgesAreNoEdges) {
  PolygonModel model{"flat", {}, {}};
  for (const Vec3 p : {Vec3{0, 0, 5}, Vec3{4, 0, 5}, Vec3{8, 0.1, 5}, Vec3{8, 6, 5}, Vec3{0, 6, 5}, Vec3{4, 6, 5}})
    model.vertices.push_back(kAnchor + p);
  model.faces.push_back({{{0, 1, 2, 3, 4}}, FaceKind::roof, 0});  // bends by 1.4 degrees at vertex 1
  EXPECT_EQ(roof_edges(model).size(), 4u);
  model.faces = {{{{0, 1, 5, 4}}, FaceKind::roof, 0}, {{{1, 2, 3, 5}}, FaceKind::roof, 0}};
  const std::vector<RoofEdge> edges = roof_edges(model);
  ASSERT_EQ(edges.size(), 7u);
  EXPECT_EQ(std::count_if(edges.begin(), edges.end(), [](const RoofEdge& e) { return e.inside_face; }), 1);
  const std::vector<RoofEdge> gable = roof_edges(gabled(0));
  EXPECT_TRUE(std::none_of(gable.begin(), gable.end(), [](const RoofEdge& e) { return e.inside_face; }));
}

TEST(Wireframe, ShortEdgesOfAFootprintAreNotJudged) {
  PolygonModel model{"corner", {}, {}};
  for (const double z : {5.0, 0.0})
    for (const Vec3 p : {Vec3{0, 0, z}, Vec3{8, 0, z}, Vec3{8, 5.7, z}, Vec3{7.7, 6, z}, Vec3{0, 6, z}})
      model.vertices.push_back(kAnchor + p);
  model.faces.push_back({{{0, 1, 2, 3, 4}}, FaceKind::roof, 0});
  model.faces.push_back({{{9, 8, 7, 6, 5}}, FaceKind::ground, 0});
  const Wireframe truth = wireframe_of(model);
  const EdgeScore found = compare_edges(truth, roof_edges(model), false);
  EXPECT_EQ(found.short_edges, 1u);
  EXPECT_EQ(found.judged_length, 5u);
  const EdgeScore given = compare_edges(truth, roof_edges(model), true);
  EXPECT_EQ(given.short_edges, 0u);
  EXPECT_EQ(given.judged_length, 4u);
  EXPECT_EQ(*given.f1(), 1);
}

TEST(Wireframe, EachModelBelongsToOneWireframe) {
  const std::vector<Wireframe> truth{wireframe_of(gabled(0)), wireframe_of(gabled(20)), wireframe_of(gabled(40))};
  const std::vector<PolygonModel> models{gabled(40), gabled(0.1), gabled(300)};
  const std::vector<EdgeScore> scores = compare_wireframes(truth, models, false);
  ASSERT_EQ(scores.size(), 3u);
  EXPECT_EQ(*scores[0].f1(), 1);
  EXPECT_EQ(scores[1].drawn, 0u);
  EXPECT_EQ(*scores[2].recall(), 1);
  EXPECT_EQ(*scores[2].precision(), 0.5);  // the invented building is judged by the nearest one
  EXPECT_TRUE(compare_wireframes({}, models, false).empty());
}

TEST(Wireframe, TrueRoofsGiveTheirEdges) {
  std::vector<TruePlane> planes;
  const PolygonModel model = gabled(0);
  for (const PolygonFace& face : model.faces) {
    Ring3 ring;
    for (const std::uint32_t i : face.rings[0]) ring.push_back(model.vertices[i]);
    planes.push_back({static_cast<std::uint32_t>(planes.size()) + 1, "roof", {}, {{4, ring, {}}}});
  }
  planes.push_back({9, "wall", {}, planes[0].polygons});
  const std::vector<Wireframe> truth = true_wireframes(planes, 1);
  ASSERT_EQ(truth.size(), 1u);
  EXPECT_EQ(truth[0].name, "4");
  EXPECT_EQ(*compare_edges(truth[0], roof_edges(model), false).f1(), 1);
}

// The least sum over all permutations.
double least_sum(const std::vector<double>& costs, std::size_t rows, std::size_t columns) {
  std::vector<std::size_t> order(std::max(rows, columns));
  std::iota(order.begin(), order.end(), std::size_t{0});
  double least = std::numeric_limits<double>::infinity();
  do {
    double sum = 0;
    for (std::size_t i = 0; i < std::min(rows, columns); ++i)
      sum += rows <= columns ? costs[i * columns + order[i]] : costs[order[i] * columns + i];
    least = std::min(least, sum);
  } while (std::next_permutation(order.begin(), order.end()));
  return least;
}

TEST(Wireframe, TheAssignmentIsTheLeastOfAll) {
  std::uint64_t state = 7;
  for (const auto& [rows, columns] : {std::pair{1u, 1u}, {3u, 5u}, {5u, 3u}, {6u, 6u}, {7u, 4u}}) {
    for (int round = 0; round < 20; ++round) {
      std::vector<double> costs(rows * columns);
      for (double& cost : costs) {
        state = state * 6364136223846793005u + 1442695040888963407u;
        cost = static_cast<double>(state >> 60);  // small whole numbers: many ties
      }
      const std::vector<std::uint32_t> column = least_assignment(costs, rows, columns);
      double sum = 0;
      std::vector<char> taken(columns);
      for (std::size_t i = 0; i < rows; ++i) {
        if (column[i] == kUnassigned) continue;
        EXPECT_FALSE(taken[column[i]]);
        taken[column[i]] = 1;
        sum += costs[i * columns + column[i]];
      }
      EXPECT_EQ(std::count(taken.begin(), taken.end(), 1), std::min(rows, columns));
      EXPECT_EQ(sum, least_sum(costs, rows, columns));
    }
  }
}

TEST(Wireframe, FilesAreReadAndReported) {
  const TemporaryFolder folder;
  const std::string roof = "v 0 0 5\nv 8 0 5\nv 8 6 5\nv 0 6 5\n";
  folder.put("drawn.obj", "o a\n" + roof + "f 1 2 3 4\n");
  folder.put("true.obj", roof + "l 1 2 3\nl 3 4\nl 4 1\n");
  folder.put("faces.obj", roof + "f 1 2 3 4\n");
  const std::vector<std::string> files{(folder.path() / "true.obj").string()};
  const WireframeEvaluation evaluation = evaluate_wireframes(folder.path() / "drawn.obj", files);
  EXPECT_EQ(*evaluation.all.f1(), 1);
  EXPECT_NEAR(evaluation.wireframes[0].tolerance_m, 0.5, 1e-12);  // a tenth of half of the diagonal
  EXPECT_FALSE(evaluation.wireframes[0].from_points);
  EXPECT_NE(wireframes_text(evaluation).find("F1 1.000"), std::string::npos);
  EXPECT_NE(wireframes_json(evaluation).find("\"f1\": 1.0"), std::string::npos);
  const std::vector<std::string> none{(folder.path() / "faces.obj").string()};
  EXPECT_THROW(evaluate_wireframes(folder.path() / "drawn.obj", none), Error);
}

}  // namespace
}  // namespace ilot
