// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/classes/role_trees.h"

#include <gtest/gtest.h>

#include <sstream>

#include "engine/products/streets/classes/role_trees_text.h"
#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"
#include "training/role_training.h"

namespace ilot {
namespace {

double& area(CandidateFeatures& f) {
  return f[static_cast<std::size_t>(ComponentFeature::area)];
}

// Pairs and what joins them. A pair of bricks is one wall where both are rough, else two: what joins them does not show
// it, only its parts do.
std::vector<TrainingSample> walls(std::size_t count, std::uint64_t seed) {
  Rng rng(seed, 3);
  std::vector<TrainingSample> out;
  for (std::uint32_t i = 0; i < count; ++i) {
    const bool one = rng.below(2) == 0;
    for (std::uint32_t part = 0; part < 3; ++part) {
      TrainingSample s;
      for (double& f : s.features) f = rng.uniform();
      area(s.features) = part == 2 ? 2 : 1 + 0.1 * part;
      const auto rough = static_cast<std::size_t>(CandidateFeature::roughness);
      if (part != 2) s.features[rough] = (one ? 1 : 0) + 0.5 * rng.uniform();
      s.label = PointLabel::other;
      s.group = i % 10;
      if (part == 2) s.parts = {3 * i + 1, 3 * i + 2};
      s.role = one == (part == 2) ? CandidateRole::whole : one ? CandidateRole::part : CandidateRole::merged;
      out.push_back(s);
    }
  }
  return out;
}

std::string text_of(const RoleTrees& model) {
  return role_trees_text(model);
}

std::string read(const std::string& text, RoleTrees& model) {
  TreesReader reader;
  ColumnTrees classes;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);)
    if (const std::string wrong = reader.take(line, 0); !wrong.empty()) return wrong;
  return reader.finish(model, classes);
}

TEST(CandidateRelations, OfATreeOfFive) {
  std::vector<CandidateFeatures> candidates(5);
  const double areas[] = {1, 2, 2, 3, 5};
  for (std::size_t i = 0; i < 5; ++i) area(candidates[i]) = areas[i];
  const std::vector<CandidateParts> parts{{}, {}, {}, {1, 2}, {3, 4}};
  const auto of = candidate_relations(candidates, parts);
  using Row = std::array<std::uint32_t, kCandidateRelations>;  // itself, joined, beside, larger, lesser part
  EXPECT_EQ(of[0], (Row{1, 4, 2, 0, 0}));
  EXPECT_EQ(of[1], (Row{2, 4, 1, 0, 0}));
  EXPECT_EQ(of[2], (Row{3, 5, 4, 0, 0}));
  EXPECT_EQ(of[3], (Row{4, 5, 3, 2, 1}));
  EXPECT_EQ(of[4], (Row{5, 0, 0, 4, 3}));
}

TEST(RoleTrees, PredictionsOfPartsGiveTheirJoin) {
  const auto samples = walls(200, 1), others = walls(100, 2);
  const LearntRoles learnt = learn_roles(samples, TrainingFolds(samples, 3), true);
  const auto features = features_of(others);
  const auto parts = parts_of(others);
  const auto both = kind_shares(learnt.trees, features, parts);
  const auto alone = stage_shares(learnt.trees.stages[0], features, parts, {});
  std::size_t right = 0, right_alone = 0;
  for (std::size_t i = 2; i < others.size(); i += 3) {
    const auto kind = static_cast<std::size_t>(others[i].role == CandidateRole::whole ? CandidateKind::object
                                                                                      : CandidateKind::merged);
    right += both[i][kind] > 0.5;
    right_alone += alone[i][kind] > 0.5;
  }
  EXPECT_GE(right, 97u);
  EXPECT_LT(right_alone, 70u);
}

TEST(RoleTrees, TextAndBackAndThreads) {
  const auto samples = walls(60, 3);
  std::string first;
  RoleTrees model;
  for (const int threads : {1, 3})
    with_threads(threads, [&] {
      model = learn_roles(samples, TrainingFolds(samples, 2), true).trees;
      const std::string text = text_of(model);
      if (first.empty()) first = text;
      EXPECT_EQ(text, first);
    });
  RoleTrees back;
  ASSERT_EQ(read(first, back), "");
  EXPECT_EQ(text_of(back), first);
  const auto features = features_of(samples);
  const auto parts = parts_of(samples);
  EXPECT_EQ(kind_shares(back, features, parts), kind_shares(model, features, parts));  // the same bits
  RoleTrees none;
  EXPECT_EQ(read("", none), "");
  EXPECT_TRUE(none.empty());
}

TEST(RoleTrees, BrokenTextsAreRefused) {
  const std::string good = "stage 1 0 0 0 0 0\ncolumn 1 0.5 area\n";
  const std::string tree = "tree 0:0 1 2\n", trees = tree + tree + tree + tree + tree;
  RoleTrees model;
  EXPECT_EQ(read(good + trees + good + trees, model), "");
  EXPECT_EQ(model.stages[0].trees.trees(), kCandidateKinds);
  EXPECT_NE(read(good + trees, model), "");                        // one stage
  EXPECT_NE(read(good + trees + good + tree, model), "");          // a class without a tree
  EXPECT_NE(read(good + trees + good + trees + good, model), "");  // three stages
  EXPECT_NE(read(tree, model), "");                                // no stage
  EXPECT_NE(read("stage 9 0 0 0 0 0\n", model), "");               // too deep
  EXPECT_NE(read("stage 1 0 0\n", model), "");                     // natures missing
  EXPECT_NE(read(good + "tree 1:0 1 2\n", model), "");             // no such column
  EXPECT_NE(read(good + "tree 0:1 1 2\n", model), "");             // no such limit
  EXPECT_NE(read(good + "tree 0:0 1\n", model), "");               // a leaf missing
  EXPECT_NE(read(good + "tree 0:0 1 x\n", model), "");             // no number
  EXPECT_NE(read(good + "column 2 3 1 length\n", model), "");      // limits fall
  EXPECT_NE(read(good + "column 1 nan length\n", model), "");      // no limit
  EXPECT_NE(read(good + "column 1 3 beside: part\n", model), "");  // the first stage knows no others
  EXPECT_EQ(read(good + "column 0 length\n" + trees + good + "column 1 3 beside: part\n" + trees, model), "");
}

}  // namespace
}  // namespace ilot
