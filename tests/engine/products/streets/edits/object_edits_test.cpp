// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/edits/object_edits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/error.h"
#include "engine/products/streets/objects/object_selection.h"

namespace ilot {
namespace {

constexpr double kPixelOfEdits = 0.1;

// A bar of pixels along x whose first pixel is at x0, one pixel wide.
ObjectCandidate bar(double x0, std::uint32_t pixels, double height) {
  ObjectCandidate c;
  c.pixels = pixels;
  c.points = 10 * pixels;
  c.x = c.middle_x = x0 + (pixels - 1) / 2.0;
  const double variance = (static_cast<double>(pixels) * pixels - 1) / 12;
  c.length = kPixelOfEdits * std::sqrt(12 * variance + 1);
  c.width = kPixelOfEdits;
  c.features[static_cast<std::size_t>(ComponentFeature::area)] = 0.01 * pixels;
  c.features[static_cast<std::size_t>(ComponentFeature::max_height)] = height;
  c.features[static_cast<std::size_t>(CandidateFeature::low_share)] = 1;
  return c;
}

// Four bars side by side: 1 and 2 are joined as 5, and 5 and 3 as 6. Bar 4 stands alone. 6 and 4 are taken, as a car
// and as vegetation.
SelectedObjects selection() {
  SelectedObjects o;
  o.candidates = {bar(0, 10, 1), bar(10, 10, 2), bar(20, 10, 1), bar(100, 10, 3)};
  for (const auto& [a, b] : {std::pair{1u, 2u}, std::pair{5u, 3u}}) {
    ObjectCandidate join = bar(0, a == 1 ? 20 : 30, 2);
    join.parts[0] = a, join.parts[1] = b;
    o.candidates.push_back(join);
  }
  o.classes.resize(6);
  for (CandidateClass& c : o.classes) c.label = PointLabel::none, c.probability = 0.7;
  o.classes[5].label = PointLabel::car;
  o.classes[3].label = PointLabel::vegetation;
  o.taken = {0, 0, 0, 1, 0, 1};
  o.by_hand.assign(6, 0);
  return o;
}

// The parts lie at x = 0, 10, 20 and 100 of the places.
std::uint32_t part_of_place(Vec3 p) {
  if (p.x == 100) return 4;
  return p.x >= 0 && p.x < 30 ? 1 + static_cast<std::uint32_t>(p.x / 10) : 0;
}

Edit edit_at(EditAction action, std::vector<double> x, std::string kind = "", std::string to_kind = "") {
  Edit e;
  e.product = "streets";
  e.action = action;
  for (const double v : x) e.at.push_back({v, 0, 0});
  e.kind = std::move(kind), e.to_kind = std::move(to_kind);
  e.where = "edits.csv:" + std::to_string(static_cast<int>(x[0]));
  return e;
}

std::vector<EditResult> made(const std::vector<Edit>& edits, SelectedObjects& objects) {
  std::vector<const Edit*> list;
  for (const Edit& e : edits) list.push_back(&e);
  return edit_objects(list, part_of_place, kPixelOfEdits, objects);
}

TEST(ObjectEdits, AClassIsSetAddedAndTakenAway) {
  SelectedObjects o = selection();
  const auto results = made({edit_at(EditAction::kind, {0}, "", "van"), edit_at(EditAction::added, {100}, "bench"),
                             edit_at(EditAction::kind, {20}, "", "van"), edit_at(EditAction::kind, {50}, "", "van")},
                            o);
  EXPECT_EQ(results[0].outcome, EditOutcome::made);
  EXPECT_EQ(results[1].outcome, EditOutcome::made);
  EXPECT_EQ(results[2].outcome, EditOutcome::repeated) << "the same object at another place";
  EXPECT_EQ(results[3].outcome, EditOutcome::without_partner);
  EXPECT_EQ(o.classes[5].label, PointLabel::van);
  EXPECT_EQ(o.classes[3].label, PointLabel::bench);
  EXPECT_EQ(o.by_hand, (std::vector<std::uint8_t>{0, 0, 0, 1, 0, 1}));
  SelectedObjects other = selection();
  EXPECT_EQ(made({edit_at(EditAction::deleted, {10})}, other)[0].outcome, EditOutcome::made);
  EXPECT_EQ(other.classes[5].label, PointLabel::none);
  SelectedObjects third = selection();
  EXPECT_EQ(made({edit_at(EditAction::deleted, {100})}, third)[0].outcome, EditOutcome::without_partner);
  EXPECT_EQ(made({edit_at(EditAction::added, {0}, "car")}, third)[0].outcome, EditOutcome::repeated);
}

TEST(ObjectEdits, SplitTakesThePartsThatAreApart) {
  SelectedObjects o = selection();
  EXPECT_EQ(made({edit_at(EditAction::split, {0, 20})}, o)[0].outcome, EditOutcome::made);
  EXPECT_EQ(o.taken, (std::vector<std::uint8_t>{0, 0, 1, 1, 1, 0}));
  EXPECT_EQ(o.classes[4].label, PointLabel::car) << "what the whole was, where the part is nothing by itself";
  SelectedObjects deep = selection();
  const auto results = made({edit_at(EditAction::split, {0, 10}), edit_at(EditAction::split, {0, 10}),
                             edit_at(EditAction::split, {0, 1}), edit_at(EditAction::kind, {0}, "", "bin")},
                            deep);
  EXPECT_EQ(deep.taken, (std::vector<std::uint8_t>{1, 1, 1, 1, 0, 0}));
  EXPECT_EQ(results[1].outcome, EditOutcome::repeated);
  EXPECT_EQ(results[2].outcome, EditOutcome::without_partner) << "one part";
  EXPECT_EQ(results[3].outcome, EditOutcome::made);
  EXPECT_EQ(deep.classes[0].label, PointLabel::bin);
  EXPECT_EQ(deep.classes[1].label, PointLabel::car);
  EXPECT_EQ(candidate_of_part(deep.candidates, deep.taken), (std::vector<std::uint32_t>{0, 1, 2, 3, 4}));
}

TEST(ObjectEdits, MergedObjectsAreOneWithTheMomentsOfBoth) {
  SelectedObjects o = selection();
  const auto results = made({edit_at(EditAction::split, {0, 20}), edit_at(EditAction::merged, {20, 100}),
                             edit_at(EditAction::merged, {100, 20}), edit_at(EditAction::kind, {100}, "", "fence")},
                            o);
  EXPECT_EQ(results[1].outcome, EditOutcome::made) << results[1].reason;
  EXPECT_EQ(results[2].outcome, EditOutcome::repeated);
  ASSERT_EQ(o.candidates.size(), 7u);
  EXPECT_EQ(o.taken, (std::vector<std::uint8_t>{0, 0, 0, 0, 1, 0, 1}));
  EXPECT_EQ(o.classes[6].label, PointLabel::fence);
  EXPECT_EQ(candidate_of_part(o.candidates, o.taken), (std::vector<std::uint32_t>{0, 5, 5, 7, 7}));
  const ObjectCandidate& join = o.candidates[6];
  EXPECT_EQ(join.pixels, 20u);
  EXPECT_EQ(join.points, 200u);
  EXPECT_NEAR(join.middle_x, (24.5 + 104.5) / 2, 1e-9);
  // Two bars of ten pixels, 80 pixels apart: the variance is that of one bar and of the two middles.
  EXPECT_NEAR(join.length, kPixelOfEdits * std::sqrt(12 * ((100 - 1) / 12.0 + 1600) + 1), 1e-9);
  EXPECT_NEAR(join.width, kPixelOfEdits, 1e-9);
  EXPECT_NEAR(join.heading_deg, 0, 1e-9);
  EXPECT_EQ(join.features[static_cast<std::size_t>(ComponentFeature::max_height)], 3);
}

TEST(ObjectEdits, EditsOfWhatAPersonNamedKeepTheName) {
  SelectedObjects o = selection();
  o.classes[0].label = PointLabel::bin;
  made({edit_at(EditAction::kind, {0}, "", "van"), edit_at(EditAction::split, {0, 20})}, o);
  EXPECT_EQ(o.classes[4].label, PointLabel::van);
  EXPECT_EQ(o.classes[2].label, PointLabel::van);
  SelectedObjects p = selection();
  EXPECT_EQ(made({edit_at(EditAction::merged, {0, 20}, "", "fence")}, p)[0].outcome, EditOutcome::made);
  EXPECT_EQ(p.classes[5].label, PointLabel::fence) << "both places are in one object already";
  SelectedObjects q = selection();
  EXPECT_EQ(made({edit_at(EditAction::added, {0}, "car")}, q)[0].outcome, EditOutcome::repeated);
  EXPECT_EQ(q.by_hand[5], 1) << "however long it is";
  SelectedObjects r = selection();
  EXPECT_EQ(made({edit_at(EditAction::deleted, {0}), edit_at(EditAction::split, {0, 20})}, r)[1].outcome,
            EditOutcome::without_partner);
}

TEST(ObjectEdits, AJoinThatIsThereIsTaken) {
  SelectedObjects o = selection();
  made({edit_at(EditAction::split, {0, 20}), edit_at(EditAction::merged, {0, 20})}, o);
  EXPECT_EQ(o.candidates.size(), 6u);
  EXPECT_EQ(o.taken, (std::vector<std::uint8_t>{0, 0, 0, 1, 0, 1}));
  EXPECT_EQ(o.classes[5].label, PointLabel::car);
}

TEST(ObjectEdits, TwoClassesOfOneObjectAreAContradiction) {
  SelectedObjects o = selection();
  EXPECT_THROW(made({edit_at(EditAction::kind, {0}, "", "van"), edit_at(EditAction::deleted, {10})}, o), Error);
  SelectedObjects p = selection();
  EXPECT_THROW(made({edit_at(EditAction::kind, {0}, "", "van"), edit_at(EditAction::kind, {10}, "", "car")}, p), Error);
}

}  // namespace
}  // namespace ilot
