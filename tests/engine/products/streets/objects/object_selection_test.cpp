// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/object_selection.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

ObjectCandidate joined(std::uint32_t a, std::uint32_t b) {
  ObjectCandidate t;
  t.parts[0] = a, t.parts[1] = b;
  return t;
}

CandidateClass roles(double whole, double part, double merged) {
  return {PointLabel::other, 1, whole, part, merged};
}

using Taken = std::vector<std::uint8_t>;

TEST(ObjectSelection, PartsOfOneAndTwoThatTouch) {
  const std::vector<ObjectCandidate> candidates{{}, {}, joined(1, 2)};
  const CandidateClass part = roles(0.2, 0.8, 0), whole = roles(0.8, 0.2, 0);
  EXPECT_EQ(select_objects(candidates, std::vector{part, part, roles(0.9, 0, 0.1)}), (Taken{0, 0, 1}));
  EXPECT_EQ(select_objects(candidates, std::vector{whole, whole, roles(0.1, 0, 0.9)}), (Taken{1, 1, 0}));
  // The parts tell where the whole does not, and the other way round.
  EXPECT_EQ(select_objects(candidates, std::vector{whole, whole, roles(0.5, 0, 0.5)}), (Taken{1, 1, 0}));
  EXPECT_EQ(select_objects(candidates, std::vector{roles(0.5, 0.5, 0), part, roles(0.5, 0, 0.5)}), (Taken{0, 0, 1}));
  EXPECT_EQ(select_objects(candidates, std::vector<CandidateClass>(3, roles(1, 1, 1))), (Taken{0, 0, 1}));
}

TEST(ObjectSelection, WhoStandsUnderACrownIsNotLostInIt) {
  // A crown of three tops, which may have any role, and a person who is whole.
  const CandidateClass crown = roles(0.95, 0.95, 0.95), person = roles(0.9, 0.1, 0), both = roles(0.5, 0.3, 0.95);
  const std::vector<ObjectCandidate> candidates{{}, {}, {}, {}, joined(1, 2), joined(5, 3), joined(6, 4)};
  EXPECT_EQ(select_objects(candidates, std::vector{crown, crown, crown, person, crown, crown, both}),
            (Taken{0, 0, 0, 1, 0, 1, 0}));
}

// The cut of a tree under which all roles are most probable, by trying all.
double best_cut(const std::vector<ObjectCandidate>& candidates, const std::vector<CandidateClass>& classes,
                std::size_t root, Taken& taken) {
  const auto all_parts = [&](auto&& self, std::size_t i) -> double {
    double p = classes[i].part;
    for (const std::uint32_t q : candidates[i].parts)
      if (q != 0) p *= self(self, q - 1);
    return p;
  };
  double whole = classes[root].whole;
  for (const std::uint32_t q : candidates[root].parts)
    if (q != 0) whole *= all_parts(all_parts, q - 1);
  if (candidates[root].parts[0] == 0) {
    taken[root] = 1;
    return whole;
  }
  Taken below = taken;
  double apart = classes[root].merged;
  for (const std::uint32_t q : candidates[root].parts) apart *= best_cut(candidates, classes, q - 1, below);
  if (whole >= apart) {
    taken[root] = 1;
    return whole;
  }
  taken = below;
  return apart;
}

// Things without parts, joined at random until one is left.
std::vector<ObjectCandidate> random_tree(Rng& rng, std::size_t parts) {
  std::vector<ObjectCandidate> candidates(parts);
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 1; i <= candidates.size(); ++i) open.push_back(i);
  while (open.size() > 1) {
    const std::size_t a = rng.below(open.size() - 1);
    candidates.push_back(joined(open[a], open.back()));
    open.pop_back();
    open[a] = static_cast<std::uint32_t>(candidates.size());
  }
  return candidates;
}

std::vector<CandidateClass> random_roles(Rng& rng, std::size_t count) {
  std::vector<CandidateClass> classes;
  for (std::size_t i = 0; i < count; ++i) {
    const double whole = rng.uniform(), part = rng.uniform(), merged = rng.uniform();
    classes.push_back(roles(0.01 + whole, 0.01 + part, 0.01 + merged));
  }
  return classes;
}

TEST(ObjectSelection, TheMostProbableCut) {
  Rng rng(7, 1);
  for (int round = 0; round < 300; ++round) {
    const std::vector<ObjectCandidate> candidates = random_tree(rng, 2 + rng.below(6));
    const std::vector<CandidateClass> classes = random_roles(rng, candidates.size());
    Taken expected(candidates.size(), 0);
    best_cut(candidates, classes, candidates.size() - 1, expected);
    EXPECT_EQ(select_objects(candidates, classes), expected);
  }
}

// Trees in one street, some of them a thing that stands alone: each is cut as if there were no other, and one that
// stands alone has no parts and is none, so it is taken whatever its role.
TEST(ObjectSelection, TreesAreCutEachByItself) {
  Rng rng(8, 1);
  for (int round = 0; round < 100; ++round) {
    std::vector<ObjectCandidate> street;
    std::vector<CandidateClass> classes;
    Taken expected;
    for (int tree = 0; tree < 4; ++tree) {
      std::vector<ObjectCandidate> candidates = random_tree(rng, 1 + rng.below(4));
      const std::vector<CandidateClass> own = random_roles(rng, candidates.size());
      const Taken alone = select_objects(candidates, own);
      if (candidates.size() == 1) {
        EXPECT_EQ(alone, Taken{1});
      }
      for (ObjectCandidate& t : candidates)
        for (std::uint32_t& part : t.parts) part += part == 0 ? 0 : static_cast<std::uint32_t>(street.size());
      street.insert(street.end(), candidates.begin(), candidates.end());
      classes.insert(classes.end(), own.begin(), own.end());
      expected.insert(expected.end(), alone.begin(), alone.end());
    }
    EXPECT_EQ(select_objects(street, classes), expected);
  }
}

TEST(ObjectSelection, PartsKnowTheirCandidate) {
  const std::vector<ObjectCandidate> candidates{{}, {}, {}, joined(1, 2), joined(4, 3)};
  EXPECT_EQ(candidate_of_part(candidates, Taken{0, 0, 1, 1, 0}), (std::vector<std::uint32_t>{0, 4, 4, 3}));
  EXPECT_EQ(candidate_of_part(candidates, Taken{0, 0, 0, 0, 1}), (std::vector<std::uint32_t>{0, 5, 5, 5}));
}

}  // namespace
}  // namespace ilot
