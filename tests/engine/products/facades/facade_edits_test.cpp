// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/facade_edits.h"

#include <gtest/gtest.h>

#include <cmath>

#include "engine/error.h"
#include "engine/products/facades/elements/edited_element.h"

namespace ilot {
namespace {

// A wall that runs along (0.6, 0.8) from (100, 200, 5), in a CRS of feet.
constexpr double kFoot = 0.3048;

Facade wall() {
  Facade f;
  f.id = 1;
  f.origin = {100, 200, 5};
  f.right = {0.6, 0.8, 0};
  f.up = {0, 0, 1};
  f.out = cross(f.right, f.up);
  f.width_m = 10;
  f.height_m = 8;
  return f;
}

Vec3 on_wall(const Facade& f, double u, double v) {
  return f.origin + (u / kFoot) * f.right + (v / kFoot) * f.up;
}

FacadeElement opening(const Facade& f, const std::string& kind, const Box2& box) {
  FacadeElement e;
  e.kind = kind;
  e.opening = kind == "window" || kind == "door";
  e.ring = {on_wall(f, box.u0, box.v0), on_wall(f, box.u1, box.v0), on_wall(f, box.u1, box.v1),
            on_wall(f, box.u0, box.v1)};
  e.edges.resize(4);
  for (FacadeEdge& edge : e.edges) edge.error_m = 0.004;
  e.width_m = box.width(), e.height_m = box.height();
  e.width_error_m = e.height_error_m = 0.006;
  e.depth_m = -0.2;
  return e;
}

// A wall with an outline, two windows, a door and a place that nobody saw.
Facade front() {
  Facade f = wall();
  f.elements.push_back(opening(f, "outline", {0, 10, 0, 8}));
  f.elements.push_back(opening(f, "window", {1, 2, 3, 5}));
  f.elements.push_back(opening(f, "window", {3, 4, 3, 5}));
  f.elements.push_back(opening(f, "door", {6, 7, 0, 2.2}));
  f.elements.push_back(opening(f, "possible opening", {8, 9, 3, 5}));
  for (std::uint32_t i = 0; i < f.elements.size(); ++i) f.elements[i].id = i + 1;
  return f;
}

Edit edit(EditAction action, const Box2& at, const std::string& kind = "window") {
  const Facade f = wall();
  Edit e;
  e.product = "facades";
  e.action = action;
  e.kind = kind;
  e.at = {on_wall(f, at.u0, at.v0), on_wall(f, at.u1, at.v1)};
  static int line = 1;
  e.where = "edits.csv:" + std::to_string(++line);
  return e;
}

Edit moved(const Box2& at, const Box2& to) {
  Edit e = edit(EditAction::moved, at);
  e.to = {on_wall(wall(), to.u0, to.v0), on_wall(wall(), to.u1, to.v1)};
  return e;
}

Edit renamed(const Box2& at, const std::string& kind, const std::string& to_kind) {
  Edit e = edit(EditAction::kind, at, kind);
  e.to_kind = to_kind;
  return e;
}

struct Edited {
  Facade facade;
  std::vector<EditResult> results;
};

Edited make(const std::vector<Edit>& edits, Facade facade = front()) {
  FacadeEditParams params;
  params.metres_per_unit = kFoot;
  std::vector<const Edit*> given;
  for (const Edit& e : edits) given.push_back(&e);
  Facade* one = &facade;
  auto results = edit_facades(given, std::span(&one, 1), params);
  return {facade, results};
}

Box2 box(const Facade& f, std::size_t i) {
  return box_in(f, f.elements[i], kFoot);
}

std::string fault_of(const std::vector<Edit>& edits) {
  std::string at_once;
  try {
    check_facade_edits(edits, kFoot);
  } catch (const Error& fault) {
    EXPECT_EQ(fault.code(), ExitCode::usage);
    at_once = fault.what();
  }
  try {
    make(edits);
  } catch (const Error& fault) {
    EXPECT_FALSE(at_once.empty()) << "the contradiction is found before the run begins";
    return fault.what();
  }
  EXPECT_EQ(at_once, "");
  return "";
}

TEST(FacadeEdits, AMovedOpeningKeepsItsFormAndWhatWasMeasuredOfSidesThatStay) {
  const Edited done = make({moved({1.02, 2.02, 3, 5}, {1.3, 2.3, 3, 5})});
  ASSERT_EQ(done.results[0].outcome, EditOutcome::made);
  const FacadeElement& e = done.facade.elements[1];
  EXPECT_NEAR(box(done.facade, 1).u0, 1.3, 1e-9);
  EXPECT_NEAR(box(done.facade, 1).u1, 2.3, 1e-9);
  EXPECT_EQ(e.status, DrawnStatus::by_hand);
  EXPECT_EQ(e.edges[0].status, DrawnStatus::seen);  // the bottom
  EXPECT_EQ(e.edges[0].error_m, 0.004);
  EXPECT_EQ(e.edges[1].status, DrawnStatus::by_hand);
  EXPECT_EQ(e.edges[1].error_m, 0);
  EXPECT_EQ(e.edges[3].status, DrawnStatus::by_hand);
  EXPECT_EQ(e.width_error_m, 0);
  EXPECT_EQ(e.height_error_m, 0.006);
  EXPECT_EQ(e.depth_m, -0.2);
}

TEST(FacadeEdits, AResizedOpeningHasOneSideByHand) {
  const Edited done = make({moved({1, 2, 3, 5}, {1, 2, 3, 5.4})});
  const FacadeElement& e = done.facade.elements[1];
  EXPECT_NEAR(e.height_m, 2.4, 1e-9);
  EXPECT_EQ(e.edges[2].status, DrawnStatus::by_hand);
  for (const std::size_t i : {0u, 1u, 3u}) EXPECT_EQ(e.edges[i].status, DrawnStatus::seen) << i;
}

TEST(FacadeEdits, OthersStayAsTheyAre) {
  const Facade before = front();
  const Edited done = make({edit(EditAction::deleted, {1, 2, 3, 5})});
  ASSERT_EQ(done.facade.elements.size(), 4u);
  for (std::uint32_t i = 0; i < 4; ++i) EXPECT_EQ(done.facade.elements[i].id, i + 1);
  EXPECT_NEAR(box(done.facade, 1).u0, 3, 1e-9);
  EXPECT_EQ(done.facade.elements[1].status, DrawnStatus::seen);
  EXPECT_EQ(done.facade.elements[2].kind, "door");
}

TEST(FacadeEdits, AnAddedOpeningTakesThePlaceOfWhatNobodySaw) {
  const Edited done = make({edit(EditAction::added, {8.1, 9, 3, 5}, "window")});
  ASSERT_EQ(done.facade.elements.size(), 5u);
  const FacadeElement& e = done.facade.elements[4];
  EXPECT_EQ(e.kind, "window");
  EXPECT_TRUE(e.opening);
  EXPECT_EQ(e.status, DrawnStatus::by_hand);
  ASSERT_EQ(e.ring.size(), 4u);
  EXPECT_NEAR(dot(cross(e.ring[1] - e.ring[0], e.ring[2] - e.ring[1]), done.facade.out), 0.9 * 2 / kFoot / kFoot, 1e-6);
}

TEST(FacadeEdits, AnAddedOpeningThatTheRunFoundByItselfIsOne) {
  const Edited done = make({edit(EditAction::added, {1.1, 2.1, 3, 5}, "door")});
  ASSERT_EQ(done.facade.elements.size(), 5u);
  EXPECT_EQ(done.facade.elements[1].kind, "door");
  EXPECT_NEAR(box(done.facade, 1).u0, 1.1, 1e-9);
  EXPECT_EQ(done.facade.elements[1].depth_m, -0.2);
}

TEST(FacadeEdits, AKindIsSetAlsoWhereNobodySaw) {
  const Edited done =
      make({renamed({6, 7, 0, 2.2}, "door", "window"), renamed({8, 9, 3, 5}, "possible opening", "window")});
  EXPECT_EQ(done.facade.elements[3].kind, "window");
  EXPECT_EQ(done.facade.elements[3].status, DrawnStatus::by_hand);
  EXPECT_EQ(done.facade.elements[3].edges[0].error_m, 0.004);  // its sides were measured
  EXPECT_TRUE(done.facade.elements[4].opening);
  EXPECT_EQ(done.facade.elements[4].edges[0].status, DrawnStatus::by_hand);
}

TEST(FacadeEdits, WithoutAPartnerNothingChanges) {
  Edit beside = moved({5, 5.8, 3, 5}, {5.1, 5.9, 3, 5});
  Edit before = edit(EditAction::deleted, {1, 2, 3, 5});
  for (Vec3& p : before.at) p = p + (0.4 / kFoot) * wall().out;
  Edit across = edit(EditAction::deleted, {1, 2, 3, 5});
  across.at[1] = across.at[0] + (1 / kFoot) * wall().out + (2 / kFoot) * wall().up;
  Edit far = edit(EditAction::added, {12, 13, 3, 5});
  const Edited done = make({beside, before, across, far, edit(EditAction::deleted, {1, 2, 3, 5}, "balcony")});
  for (const EditResult& result : done.results) {
    EXPECT_EQ(result.outcome, EditOutcome::without_partner);
    EXPECT_NE(result.reason, "");
  }
  EXPECT_EQ(done.facade.elements.size(), 5u);
  for (const FacadeElement& e : done.facade.elements) EXPECT_EQ(e.status, DrawnStatus::seen);
}

TEST(FacadeEdits, EditsOfEditsFollowOneAnother) {
  const Edited done = make({moved({1, 2, 3, 5}, {1.3, 2.3, 3, 5}), moved({1.3, 2.3, 3, 5}, {1.7, 2.7, 3, 5}),
                            renamed({1, 2, 3, 5}, "window", "door"), edit(EditAction::added, {4.5, 5.5, 3, 5}),
                            edit(EditAction::deleted, {4.5, 5.5, 3, 5}), moved({1.3, 2.3, 3, 5}, {1.7, 2.7, 3, 5})});
  EXPECT_NEAR(box(done.facade, 1).u0, 1.7, 1e-9);
  EXPECT_EQ(done.facade.elements[1].kind, "door");
  EXPECT_EQ(done.facade.elements.size(), 5u);
  EXPECT_EQ(done.results[5].outcome, EditOutcome::repeated);
}

TEST(FacadeEdits, ContradictionsNameBothLines) {
  const Box2 one{1, 2, 3, 5};
  const std::vector<std::vector<Edit>> pairs{
      {moved(one, {1.3, 2.3, 3, 5}), moved(one, {0.6, 1.6, 3, 5})},
      {edit(EditAction::deleted, one), moved(one, {1.3, 2.3, 3, 5})},
      {moved(one, {1.3, 2.3, 3, 5}), edit(EditAction::deleted, one)},
      {renamed(one, "window", "door"), renamed(one, "window", "shop")},
      {edit(EditAction::added, {4.5, 5.5, 3, 5}), edit(EditAction::added, {4.6, 5.6, 3, 5})}};
  for (const auto& pair : pairs) {
    const std::string fault = fault_of(pair);
    EXPECT_NE(fault.find(pair[0].where), std::string::npos) << fault;
    EXPECT_EQ(fault.find(pair[1].where), 0u) << fault;
  }
  EXPECT_EQ(fault_of({moved(one, {1.3, 2.3, 3, 5}), moved(one, {1.3, 2.3, 3, 5})}), "");
  EXPECT_EQ(fault_of({edit(EditAction::deleted, one), edit(EditAction::deleted, one)}), "");
}

// Drawn as two openings once, one on each sheet of a wall, and found as one now: each has half in common with it, but
// not with the other.
TEST(FacadeEdits, TwoOpeningsThatAreOneNowContradictNothing) {
  const Box2 low{1, 2, 3, 4.1}, high{1, 2, 3.9, 5};
  for (const std::vector<Edit>& edits :
       {std::vector<Edit>{edit(EditAction::deleted, low), moved(high, {1.3, 2.3, 3.9, 5})},
        std::vector<Edit>{renamed(low, "window", "door"), renamed(high, "window", "shop")},
        std::vector<Edit>{moved(low, {1.3, 2.3, 3, 4.1}), edit(EditAction::deleted, high)}}) {
    EXPECT_EQ(fault_of(edits), "");
    const Edited done = make(edits);
    EXPECT_EQ(done.results[0].outcome, EditOutcome::made);
    EXPECT_EQ(done.results[1].outcome, EditOutcome::without_partner);
    EXPECT_EQ(done.results[1].reason, "it was one opening with that of " + edits[0].where);
  }
}

TEST(FacadeEdits, ASideIsAPlaceOnTheStreet) {
  WallGroup group;
  const Facade f = wall();
  group.axes = {f.origin, f.right, f.up, f.out};
  group.width = 10, group.height = 8;
  Edit same = edit(EditAction::side, {5, 6, 2, 3}, "");
  same.at[1] = same.at[0] + (4 / kFoot) * f.out;
  Edit other = same;
  other.at[1] = same.at[0] - (4 / kFoot) * f.out;
  FacadeEditParams params;
  params.metres_per_unit = kFoot;
  std::vector<WallGroup> walls{group};
  const Edit* edits[] = {&same};
  EXPECT_EQ(edit_sides(edits, walls, params)[0], std::size_t{0});
  EXPECT_NEAR(dot(walls[0].axes.out, f.out), 1, 1e-12);
  edits[0] = &other;
  EXPECT_EQ(edit_sides(edits, walls, params)[0], std::size_t{0});
  EXPECT_NEAR(dot(walls[0].axes.out, f.out), -1, 1e-12);
  const Vec3 left = walls[0].axes.origin - on_wall(f, 10, 0);
  EXPECT_NEAR(norm(left), 0, 1e-9);
  EXPECT_NO_THROW(edit_sides(edits, walls, params)) << "the same edit finds the wall as it should be";
  const Edit* both[] = {&same, &other};
  EXPECT_THROW(edit_sides(both, walls, params), Error);
}

}  // namespace
}  // namespace ilot
