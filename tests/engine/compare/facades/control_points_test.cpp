// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/facades/control_points.h"

#include <gtest/gtest.h>

#include <cmath>

#include "tests/support/facades.h"

namespace ilot {
namespace {

TEST(ControlPoints, MeasureHomologousVertices) {
  // Two windows; the second is drawn 3 cm too far right and 4 cm too high, the sill not at all.
  const std::vector<TrueControlPoint> truth{
      {"window_top", 1, {1, 0, 3}},    {"window_top", 1, {2, 0, 3}},    {"window_top", 2, {5, 0, 3}},
      {"window_top", 2, {6, 0, 3}},    {"window_bottom", 1, {1, 0, 1}}, {"window_bottom", 1, {2, 0, 1}},
      {"window_bottom", 2, {5, 0, 1}}, {"window_bottom", 2, {6, 0, 1}}, {"sill_top", 1, {1, 0, 1}}};
  const Facade facade = facade_of({drawn("window", wall_rectangle(1, 1, 2, 3)),
                                   drawn("window", wall_rectangle(5.03, 1.04, 6.03, 3.04), DrawnStatus::completed)});
  const std::vector<ControlGroup> groups = evaluate_control_points(truth, std::span(&facade, 1));
  ASSERT_EQ(groups.size(), 3u);
  EXPECT_EQ(groups[0].name, "window_top");
  EXPECT_EQ(groups[0].count, 4u);
  EXPECT_EQ(groups[0].missed, 0u);
  EXPECT_NEAR(groups[0].dx_m.mean, 0.015, 1e-12);
  EXPECT_NEAR(groups[0].dz_m.mean, 0.02, 1e-12);
  EXPECT_NEAR(groups[0].dd_m.mean, 0.025, 1e-12);
  EXPECT_NEAR(groups[0].dd_m.sd, std::sqrt(4 * 0.025 * 0.025 / 3), 1e-12);
  EXPECT_EQ(groups[0].completed, 2u);
  EXPECT_NEAR(groups[0].completed_dd_m.mean, 0.05, 1e-12);
  EXPECT_EQ(groups[2].name, "sill_top");
  EXPECT_EQ(groups[2].missed, 1u);
  EXPECT_EQ(groups[2].drawn, 0u);
}

TEST(ControlPoints, OneVertexServesOnePointAndTheLimitIsClosed) {
  const std::vector<TrueControlPoint> truth{{"door_top", 1, {0, 0, 0}}, {"door_top", 1, {0.2, 0, 0}}};
  const Facade facade = facade_of({drawn("door", {{0.25, 0, 0}, {9, 0, 0}, {9, 0, 9}})});
  const auto missed = [&](double limit) {
    return evaluate_control_points(truth, std::span(&facade, 1), {limit, 0.5, 1})[0].missed;
  };
  EXPECT_EQ(missed(0.3), 1u);  // the nearer control point has it
  EXPECT_EQ(missed(0.01), 2u);
  const Facade exact = facade_of({drawn("door", {{0, 0, 0.25}, {9, 0, 0}, {9, 0, 9}})});
  EXPECT_EQ(evaluate_control_points(truth, std::span(&exact, 1), {0.25, 0.5, 1})[0].missed, 1u);
}

TEST(ControlPoints, WhatIsHiddenFarBehindOrOfAnotherKindIsMissed) {
  const std::vector<TrueControlPoint> truth{{"window_top", 1, {1, 0, 3}}};
  const auto missed = [&](const Facade& facade) {
    return evaluate_control_points(truth, std::span(&facade, 1))[0].missed;
  };
  EXPECT_EQ(missed(facade_of({drawn("window", wall_rectangle(1, 1, 2, 3), DrawnStatus::occluded)})), 1u);
  EXPECT_EQ(missed(facade_of({drawn("window", wall_rectangle(1, 1, 2, 3, 0.6))})), 1u);
  EXPECT_EQ(missed(facade_of({drawn("sill", wall_rectangle(1, 1, 2, 3))})), 1u);
  EXPECT_EQ(missed(facade_of({drawn("opening", wall_rectangle(1, 1, 2, 3))})), 0u);
  EXPECT_EQ(missed(facade_of({})), 1u);
  EXPECT_TRUE(evaluate_control_points({}, {}).empty());
}

TEST(ControlPoints, VerticesOfOccludedEdgesAreNotDrawn) {
  FacadeElement window = drawn("window", wall_rectangle(1, 1, 2, 3));
  window.edges.assign(4, {});
  window.edges[0].status = DrawnStatus::occluded;  // the foot
  const Facade facade = facade_of({window});
  const std::vector<TrueControlPoint> truth{{"window_top", 1, {1, 0, 3}}, {"window_bottom", 1, {1, 0, 1}}};
  const auto groups = evaluate_control_points(truth, std::span(&facade, 1));
  EXPECT_EQ(groups[0].missed, 0u);
  EXPECT_EQ(groups[1].missed, 1u);
  ControlPointParams documents;
  documents.as_documents = true;
  EXPECT_EQ(evaluate_control_points(truth, std::span(&facade, 1), documents)[1].completed, 1u);
}

TEST(ControlPoints, VerticesOfCompletedEdgesAreCompleted) {
  FacadeElement window = drawn("window", wall_rectangle(1, 1, 2, 3));
  window.edges.assign(4, {});
  window.edges[0].status = DrawnStatus::completed;  // the bottom
  const Facade facade = facade_of({window});
  const std::vector<TrueControlPoint> truth{{"window_top", 1, {1, 0, 3}}, {"window_bottom", 1, {1, 0, 1}}};
  const auto groups = evaluate_control_points(truth, std::span(&facade, 1));
  EXPECT_EQ(groups[0].completed, 0u);
  EXPECT_EQ(groups[1].completed, 1u);
}

TEST(ControlPoints, SpreadOfAHandfulOfValues) {
  const std::vector<double> values{1, 2, 3, 4};
  EXPECT_DOUBLE_EQ(mean_and_spread(values).mean, 2.5);
  EXPECT_DOUBLE_EQ(mean_and_spread(values).sd, std::sqrt(5.0 / 3));
  EXPECT_EQ(mean_and_spread(std::span(values).first(1)).sd, 0);
  EXPECT_EQ(mean_and_spread({}).mean, 0);
}

}  // namespace
}  // namespace ilot
