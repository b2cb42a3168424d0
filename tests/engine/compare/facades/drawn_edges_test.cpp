// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/drawn_edges.h"

#include <gtest/gtest.h>

#include "tests/support/facades.h"

namespace ilot {
namespace {

DrawnEdges judge_edges(const std::vector<TrueOpening>& truth, const Facade& facade) {
  return evaluate_drawn_edges(truth, match_openings(truth, std::span(&facade, 1)));
}

TEST(DrawnEdges, MissedOpeningsCountAsWrong) {
  const std::vector<TrueOpening> truth{{1, 1, wall_rectangle(0, 0, 1, 2)}, {2, 1, wall_rectangle(4, 0, 5, 2)}};
  const DrawnEdges edges = judge_edges(truth, facade_of({drawn("window", wall_rectangle(0, 0, 1, 2))}));
  EXPECT_NEAR(edges.true_m, 12, 1e-9);
  for (std::size_t i = 0; i < kEdgeLimitsM.size(); ++i) EXPECT_NEAR(edges.share(i), 0.5, 1e-9);
  EXPECT_EQ(judge_edges({}, facade_of({})).share(0), 0);
}

TEST(DrawnEdges, SharesFollowTheLimits) {
  const std::vector<TrueOpening> truth{{1, 1, wall_rectangle(0, 0, 1, 2)}};
  // The top is 3 cm too high: 1 of 6 m is drawn within 5 cm only, and so are 3 cm at the top of each jamb or less.
  const DrawnEdges edges = judge_edges(truth, facade_of({drawn("window", wall_rectangle(0, 0, 1, 2.03))}));
  EXPECT_NEAR(edges.share(0), 5.0 / 6, 0.01);
  EXPECT_NEAR(edges.share(1), 5.0 / 6, 0.01);
  EXPECT_NEAR(edges.share(2), 1, 1e-9);
}

TEST(DrawnEdges, OccludedEdgesAreNotDrawn) {
  const std::vector<TrueOpening> truth{{1, 1, wall_rectangle(0, 0, 1, 2)}};
  FacadeElement window = drawn("window", wall_rectangle(0, 0, 1, 2));
  window.edges.assign(4, {});
  window.edges[0].status = DrawnStatus::occluded;  // the foot, 1 of 6 m
  EXPECT_NEAR(judge_edges(truth, facade_of({window})).share(2), 5.0 / 6, 0.02);
}

TEST(DrawnEdges, StatedErrorsAreJudgedByStatus) {
  const std::vector<TrueOpening> truth{{1, 1, wall_rectangle(0, 0, 1, 2)}};
  FacadeElement window = drawn("window", wall_rectangle(0, 0.02, 1, 2));
  window.edges.assign(4, {});
  for (FacadeEdge& edge : window.edges) edge.error_m = 0.001;
  window.edges[0].status = DrawnStatus::completed;
  window.edges[3].error_m = 0;  // nothing is stated
  const DrawnEdges edges = judge_edges(truth, facade_of({window}));
  EXPECT_EQ(edges.stated[0].edges, 2u);
  EXPECT_EQ(edges.stated[0].within, 2u);
  EXPECT_EQ(edges.stated[1].status, DrawnStatus::completed);
  EXPECT_EQ(edges.stated[1].edges, 1u);
  EXPECT_EQ(edges.stated[1].within, 0u);
  EXPECT_NEAR(edges.stated[1].median_true_m, 0.02, 1e-3);  // a little less at its ends, where the jambs are nearer
  EXPECT_EQ(edges.stated[1].median_stated_m, 0.001);
}

TEST(DrawnEdges, LengthsAreInMetresWhateverTheUnit) {
  const std::vector<TrueOpening> feet{{1, 1, wall_rectangle(0, 0, 3, 6)}};
  const Facade facade = facade_of({drawn("window", wall_rectangle(0, 0, 3, 6.1))});  // 3 cm
  const auto pairs = match_openings(feet, std::span(&facade, 1), {0.5, 0.5, 0.3048});
  const DrawnEdges edges = evaluate_drawn_edges(feet, pairs, 0.3048);
  EXPECT_NEAR(edges.true_m, 18 * 0.3048, 1e-9);
  EXPECT_NEAR(edges.share(1), 15.0 / 18, 0.02);
  EXPECT_NEAR(edges.share(2), 1, 1e-9);
}

}  // namespace
}  // namespace ilot
