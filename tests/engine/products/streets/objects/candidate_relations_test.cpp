// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/candidate_relations.h"

#include <gtest/gtest.h>

#include <vector>

namespace ilot {
namespace {

double get(const ObjectCandidate& t, CandidateFeature f) {
  return t.features[static_cast<std::size_t>(f)];
}

ObjectCandidate candidate(double area, double length, double width, double top, double mean) {
  ObjectCandidate t;
  t.features[static_cast<std::size_t>(ComponentFeature::area)] = area;
  t.features[static_cast<std::size_t>(ComponentFeature::max_height)] = top;
  t.features[static_cast<std::size_t>(ComponentFeature::mean_height)] = mean;
  t.features[static_cast<std::size_t>(CandidateFeature::length)] = length;
  t.features[static_cast<std::size_t>(CandidateFeature::width)] = width;
  return t;
}

TEST(CandidateRelations, TwoBesideWhatJoinsThem) {
  std::vector<ObjectCandidate> candidates{candidate(1, 1, 1, 2, 1), candidate(3, 3, 1, 1.5, 0.75),
                                          candidate(4, 4, 2, 2, 0.8)};
  candidates[2].parts[0] = 1, candidates[2].parts[1] = 2;
  relate_candidates(candidates);
  const ObjectCandidate &a = candidates[0], &b = candidates[1], &both = candidates[2];
  EXPECT_DOUBLE_EQ(get(both, CandidateFeature::fill), 0.5);
  EXPECT_DOUBLE_EQ(get(both, CandidateFeature::lesser_share), 0.25);
  EXPECT_DOUBLE_EQ(get(both, CandidateFeature::top_step), 0.5);
  EXPECT_DOUBLE_EQ(get(both, CandidateFeature::mean_step), 0.25);
  EXPECT_DOUBLE_EQ(get(both, CandidateFeature::joined_share), 1);
  EXPECT_DOUBLE_EQ(get(both, CandidateFeature::joined_length), 4);
  EXPECT_DOUBLE_EQ(get(a, CandidateFeature::lesser_share), 0);
  EXPECT_DOUBLE_EQ(get(a, CandidateFeature::joined_share), 0.25);
  EXPECT_DOUBLE_EQ(get(b, CandidateFeature::joined_share), 0.75);
  EXPECT_DOUBLE_EQ(get(a, CandidateFeature::rise), 0.5);
  EXPECT_DOUBLE_EQ(get(b, CandidateFeature::rise), -0.5);
  EXPECT_DOUBLE_EQ(get(a, CandidateFeature::joined_fill), 0.5);
  EXPECT_DOUBLE_EQ(get(b, CandidateFeature::joined_length), 4);
}

TEST(CandidateRelations, WhatStandsAlone) {
  std::vector<ObjectCandidate> candidates{candidate(1, 2, 1, 2, 1), ObjectCandidate{}};
  relate_candidates(candidates);
  EXPECT_DOUBLE_EQ(get(candidates[0], CandidateFeature::fill), 0.5);
  EXPECT_DOUBLE_EQ(get(candidates[0], CandidateFeature::joined_fill), 0.5);
  EXPECT_DOUBLE_EQ(get(candidates[0], CandidateFeature::joined_share), 1);
  EXPECT_DOUBLE_EQ(get(candidates[0], CandidateFeature::rise), 0);
  EXPECT_DOUBLE_EQ(get(candidates[1], CandidateFeature::fill), 0);
  relate_candidates({});
}

}  // namespace
}  // namespace ilot
