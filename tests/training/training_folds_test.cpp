// SPDX-License-Identifier: Apache-2.0
#include "training/training_folds.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

std::vector<TrainingSample> in_groups(std::initializer_list<std::uint32_t> groups) {
  std::vector<TrainingSample> out;
  for (const std::uint32_t g : groups) {
    out.emplace_back();
    out.back().group = g;
  }
  return out;
}

TEST(TrainingFolds, DealGroupsOutInTheirOrder) {
  const auto samples = in_groups({70, 10, 10, 40, 99, 70});
  const TrainingFolds folds(samples, 3);
  ASSERT_TRUE(folds.by_group());
  std::vector<std::uint32_t> of;
  for (std::size_t i = 0; i < samples.size(); ++i) of.push_back(folds.of(samples[i], i));
  EXPECT_EQ(of, (std::vector<std::uint32_t>{2, 0, 0, 1, 0, 2}));
}

TEST(TrainingFolds, FewGroupsAreSplitSampleBySample) {
  const auto samples = in_groups({5, 5, 5, 6});
  const TrainingFolds folds(samples, 3);
  EXPECT_FALSE(folds.by_group());
  for (std::size_t i = 0; i < samples.size(); ++i) EXPECT_EQ(folds.of(samples[i], i), i % 3);
}

// Six things: 4 joins 1 and 2, 6 joins 3 and 5. The fold of 2 goes, so 4 joins none; 3, 5 and 6 are numbered anew.
TEST(TrainingFolds, WhatHasLostAPartJoinsNone) {
  auto samples = in_groups({1, 2, 1, 1, 1, 1});
  samples[3].parts = {1, 2};
  samples[5].parts = {3, 5};
  const TrainingFolds folds(samples, 2);
  const ChosenSamples rest = choose(samples, folds, 1, Chosen::of_others);
  EXPECT_EQ(rest.places, (std::vector<std::size_t>{0, 2, 3, 4, 5}));
  EXPECT_EQ(rest.samples[2].parts, (CandidateParts{0, 0}));
  EXPECT_EQ(rest.samples[4].parts, (CandidateParts{2, 4}));
  EXPECT_EQ(choose(samples, folds, 1, Chosen::of_fold).places, (std::vector<std::size_t>{1}));
}

}  // namespace
}  // namespace ilot
