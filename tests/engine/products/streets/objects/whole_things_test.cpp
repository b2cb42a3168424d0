// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/whole_things.h"

#include <gtest/gtest.h>

#include <cmath>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

Thing joined(std::uint32_t a, std::uint32_t b) {
  Thing t;
  t.parts[0] = a, t.parts[1] = b;
  return t;
}

ThingClass roles(double whole, double part, double several) {
  return {PointLabel::other, 1, whole, part, several};
}

using Taken = std::vector<std::uint8_t>;

TEST(WholeThings, PartsOfOneAndTwoThatTouch) {
  const std::vector<Thing> things{{}, {}, joined(1, 2)};
  const ThingClass part = roles(0.2, 0.8, 0), whole = roles(0.8, 0.2, 0);
  EXPECT_EQ(whole_things(things, std::vector{part, part, roles(0.9, 0, 0.1)}), (Taken{0, 0, 1}));
  EXPECT_EQ(whole_things(things, std::vector{whole, whole, roles(0.1, 0, 0.9)}), (Taken{1, 1, 0}));
  // The parts tell where the whole does not, and the other way round.
  EXPECT_EQ(whole_things(things, std::vector{whole, whole, roles(0.5, 0, 0.5)}), (Taken{1, 1, 0}));
  EXPECT_EQ(whole_things(things, std::vector{roles(0.5, 0.5, 0), part, roles(0.5, 0, 0.5)}), (Taken{0, 0, 1}));
  EXPECT_EQ(whole_things(things, std::vector<ThingClass>(3, roles(1, 1, 1))), (Taken{0, 0, 1}));
}

TEST(WholeThings, WhoStandsUnderACrownIsNotLostInIt) {
  // A crown of three tops, which may have any role, and a person who is whole.
  const ThingClass crown = roles(0.95, 0.95, 0.95), person = roles(0.9, 0.1, 0), both = roles(0.5, 0.3, 0.95);
  const std::vector<Thing> things{{}, {}, {}, {}, joined(1, 2), joined(5, 3), joined(6, 4)};
  EXPECT_EQ(whole_things(things, std::vector{crown, crown, crown, person, crown, crown, both}),
            (Taken{0, 0, 0, 1, 0, 1, 0}));
}

// The cut of a tree under which all roles are most probable, by trying all.
double best_cut(const std::vector<Thing>& things, const std::vector<ThingClass>& classes, std::size_t root,
                Taken& taken) {
  const auto all_parts = [&](auto&& self, std::size_t i) -> double {
    double p = classes[i].part;
    for (const std::uint32_t q : things[i].parts)
      if (q != 0) p *= self(self, q - 1);
    return p;
  };
  double whole = classes[root].whole;
  for (const std::uint32_t q : things[root].parts)
    if (q != 0) whole *= all_parts(all_parts, q - 1);
  if (things[root].parts[0] == 0) {
    taken[root] = 1;
    return whole;
  }
  Taken below = taken;
  double apart = classes[root].several;
  for (const std::uint32_t q : things[root].parts) apart *= best_cut(things, classes, q - 1, below);
  if (whole >= apart) {
    taken[root] = 1;
    return whole;
  }
  taken = below;
  return apart;
}

// Things without parts, joined at random until one is left.
std::vector<Thing> random_tree(Rng& rng, std::size_t parts) {
  std::vector<Thing> things(parts);
  std::vector<std::uint32_t> open;
  for (std::uint32_t i = 1; i <= things.size(); ++i) open.push_back(i);
  while (open.size() > 1) {
    const std::size_t a = rng.below(open.size() - 1);
    things.push_back(joined(open[a], open.back()));
    open.pop_back();
    open[a] = static_cast<std::uint32_t>(things.size());
  }
  return things;
}

std::vector<ThingClass> random_roles(Rng& rng, std::size_t count) {
  std::vector<ThingClass> classes;
  for (std::size_t i = 0; i < count; ++i) {
    const double whole = rng.uniform(), part = rng.uniform(), several = rng.uniform();
    classes.push_back(roles(0.01 + whole, 0.01 + part, 0.01 + several));
  }
  return classes;
}

TEST(WholeThings, TheMostProbableCut) {
  Rng rng(7, 1);
  for (int round = 0; round < 300; ++round) {
    const std::vector<Thing> things = random_tree(rng, 2 + rng.below(6));
    const std::vector<ThingClass> classes = random_roles(rng, things.size());
    Taken expected(things.size(), 0);
    best_cut(things, classes, things.size() - 1, expected);
    EXPECT_EQ(whole_things(things, classes), expected);
  }
}

// Trees in one street, some of them a thing that stands alone: each is cut as if there were no other, and one that
// stands alone has no parts and is none, so it is taken whatever its role.
TEST(WholeThings, TreesAreCutEachByItself) {
  Rng rng(8, 1);
  for (int round = 0; round < 100; ++round) {
    std::vector<Thing> street;
    std::vector<ThingClass> classes;
    Taken expected;
    for (int tree = 0; tree < 4; ++tree) {
      std::vector<Thing> things = random_tree(rng, 1 + rng.below(4));
      const std::vector<ThingClass> own = random_roles(rng, things.size());
      const Taken alone = whole_things(things, own);
      if (things.size() == 1) {
        EXPECT_EQ(alone, Taken{1});
      }
      for (Thing& t : things)
        for (std::uint32_t& part : t.parts) part += part == 0 ? 0 : static_cast<std::uint32_t>(street.size());
      street.insert(street.end(), things.begin(), things.end());
      classes.insert(classes.end(), own.begin(), own.end());
      expected.insert(expected.end(), alone.begin(), alone.end());
    }
    EXPECT_EQ(whole_things(street, classes), expected);
  }
}

TEST(WholeThings, PartsKnowTheirThing) {
  const std::vector<Thing> things{{}, {}, {}, joined(1, 2), joined(4, 3)};
  EXPECT_EQ(thing_of_part(things, Taken{0, 0, 1, 1, 0}), (std::vector<std::uint32_t>{0, 4, 4, 3}));
  EXPECT_EQ(thing_of_part(things, Taken{0, 0, 0, 0, 1}), (std::vector<std::uint32_t>{0, 5, 5, 5}));
}

}  // namespace
}  // namespace ilot
