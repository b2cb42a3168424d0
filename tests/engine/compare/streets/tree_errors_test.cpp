// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/streets/tree_errors.h"

#include <gtest/gtest.h>

#include "engine/compare/streets/kerb_errors.h"

namespace ilot {
namespace {

TEST(ErrorSizes, RanksOfSizes) {
  std::vector<double> errors;
  for (int i = 1; i <= 20; ++i) errors.push_back(i % 2 == 0 ? i : -i);
  const ErrorSizes sizes = sizes_of(errors);
  EXPECT_EQ(sizes.count, 20u);
  EXPECT_EQ(sizes.median, 10);
  EXPECT_EQ(sizes.p95, 19);
  EXPECT_EQ(sizes_of({}).count, 0u);
}

TEST(TreeErrors, PartnersFalseAndUnseen) {
  const std::vector<TrueTree> truth{
      {1, {0, 0, 0}, 8, 2, 2}, {2, {10, 0, 0}, 6, 2, 2}, {3, {20, 0, 0}, 9, 2, 2}, {4, {30, 0, 0}, 9, 2, 2}};
  const std::map<std::uint32_t, SeenTree> seen{{1, {500, 7.9}}, {2, {500, 6}}, {3, {5, 8}}, {4, {100, 2}}};
  StreetTree near, false_tree, of_unseen;
  near.position = {0.2, 0, 0}, near.height_m = 7.8, near.trunk_seen = true, near.crown_radius_m = 2.5;
  near.crown_base_m = 2.5;
  false_tree.position = {5, 5, 0};
  of_unseen.position = {20.5, 0, 0};
  const std::vector<StreetTree> found{near, false_tree, of_unseen};
  const TreeResult r = evaluate_trees(truth, seen, found, 1);
  EXPECT_EQ(r.truth, 2u);
  EXPECT_EQ(r.unseen, 2u);
  EXPECT_EQ(r.found, 2u);
  EXPECT_EQ(r.matched, 1u);
  EXPECT_EQ(r.false_found, 1u);
  EXPECT_EQ(r.trunks, 1u);
  EXPECT_NEAR(r.position.median, 0.2, 1e-12);
  EXPECT_NEAR(r.height.median, 0.1, 1e-12);
  EXPECT_NEAR(r.height_of_tree.median, 0.2, 1e-12);
  EXPECT_NEAR(r.crown_radius.median, 0.5, 1e-12);
  EXPECT_NEAR(r.crown_base.median, 0.5, 1e-12);
  // In feet everything is as far as in metres.
  std::vector<TrueTree> feet = truth;
  for (TrueTree& t : feet) t.base = (1 / 0.3048) * t.base;
  std::vector<StreetTree> found_feet = found;
  for (StreetTree& t : found_feet) t.position = (1 / 0.3048) * t.position;
  std::map<std::uint32_t, SeenTree> seen_feet = seen;
  for (auto& [id, s] : seen_feet) s.top /= 0.3048;
  EXPECT_NEAR(evaluate_trees(feet, seen_feet, found_feet, 0.3048).position.median, 0.2, 1e-9);
}

StreetKerb kerb_at(double y, double from, double to, double height, bool seen = true) {
  StreetKerb k;
  k.seen = seen;
  k.line = {{from, y, 0.1}, {to, y, 0.1}};
  k.heights_m = {height, height};
  return k;
}

TEST(KerbErrors, CompleteCorrectAndErrors) {
  const std::vector<TrueKerb> truth{{{{0, 0, 0.1}, {20, 0, 0.1}}, 0.12}, {{{0, 9, 0}, {20, 9, 0}}, 0.02}};
  KerbSight sight(truth, 1);
  for (double x = 0; x < 20; x += 0.05)  // the ground of the last 4 m is seen on one side only
    for (const double y : {-0.3, -0.2, 0.2, 0.3})
      if (x < 16 || y < 0) sight.add({x, y, 0});
  const std::vector<StreetKerb> found{kerb_at(0.05, 0, 8, 0.13), kerb_at(0.05, 8, 12, 0.1, false),
                                      kerb_at(5, 0, 8, 0.1)};
  const KerbResult r = evaluate_kerbs(sight, truth, found, 1);
  EXPECT_NEAR(r.true_m, 16.25, 0.5);
  EXPECT_NEAR(r.unseen_m, 40 - r.true_m, 1e-9);
  EXPECT_NEAR(r.found_m, 16, 1e-9);
  EXPECT_NEAR(r.complete, 8 / r.true_m, 0.05);
  EXPECT_NEAR(r.correct, 0.5, 1e-9);
  EXPECT_NEAR(r.bridged_m, 4, 1e-9);
  EXPECT_NEAR(r.bridged_correct, 1, 1e-9);
  EXPECT_NEAR(r.plan.p95, 0.05, 1e-9);
  EXPECT_NEAR(r.height.p95, 0.01, 1e-9);
  EXPECT_NEAR(r.elevation.p95, 0, 1e-9);
}

}  // namespace
}  // namespace ilot
