// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/join/label_pass.h"

#include <gtest/gtest.h>

#include "kernels/planes/plane_fit.h"
#include "tests/support/plane_store.h"

namespace ilot {
namespace {

using test::PlaneStore;

constexpr std::int64_t kRoofRidge = 16000, kRoofStep = 60;

// A gable roof, 27 degrees, the ridge at x = kRoofRidge: the bisector of its faces is that vertical plane.
std::vector<Index3> roof_gable() {
  std::vector<Index3> points;
  test::add_surface(points, {kRoofRidge - 3000, 4000, 5000}, {6000, 6000, 0}, kRoofStep, 6,
                    [](double x, double) { return -0.5 * std::abs(x - static_cast<double>(kRoofRidge)); });
  return points;
}

std::vector<PlaneTally> label(const PlaneStore& s, const PassContext& context = {}) {
  label_pass(s.cloud.store(), s.cells, s.found, s.joined, context);
  std::vector<PlaneTally> tallies;
  each_tally(s.cloud.store(), s.joined.planes.size(), [&](std::size_t i, const PlaneTally& tally) {
    EXPECT_EQ(i, tallies.size());
    tallies.push_back(tally);
  });
  return tallies;
}

double distance(const JoinedPlane& j, Index3 p) {
  return signed_distance(j.plane, {static_cast<double>(p.x - j.anchor.x), static_cast<double>(p.y - j.anchor.y),
                                   static_cast<double>(p.z - j.anchor.z)});
}

TEST(LabelPass, TheBisectorPartsTheFacesOfARidge) {
  const PlaneStore s(roof_gable());
  ASSERT_EQ(s.joined.planes.size(), 2u);
  label(s);
  const auto where = test::positions(s.cloud.store());
  const auto plane = test::whole_column(s.cloud.store(), columns::kPlane);
  const std::uint32_t left = s.joined.planes[0].plane.n.x < 0 ? 1 : 2;
  std::size_t wrong = 0, none = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    none += plane[i] == 0;
    if (plane[i] == 0 || (plane[i] == left) == (where[i].x < kRoofRidge)) continue;
    ++wrong;
    EXPECT_LT(std::abs(where[i].x - kRoofRidge), 2 * kRoofStep) << i;
  }
  EXPECT_LT(wrong, 20u) << "of 200 within a step of the ridge";
  EXPECT_LT(none, where.size() / 200);
}

TEST(LabelPass, EpsilonMeansEpsilonAndTheTalliesAgree) {
  const PlaneStore s(roof_gable());
  const auto tallies = label(s);
  const Store& store = s.cloud.store();
  const auto where = test::positions(store);
  const auto plane = test::whole_column(store, columns::kPlane);
  std::vector<Moments> wanted(s.joined.planes.size());
  for (std::size_t i = 0; i < where.size(); ++i) {
    if (plane[i] == 0) {
      continue;
    }
    const JoinedPlane& j = s.joined.planes[plane[i] - 1];
    ASSERT_LE(std::abs(distance(j, where[i])), j.epsilon);
    wanted[plane[i] - 1].add_point({where[i].x - j.anchor.x, where[i].y - j.anchor.y, where[i].z - j.anchor.z});
    ASSERT_TRUE(tallies[plane[i] - 1].box.contains(where[i]));
  }
  ASSERT_EQ(tallies.size(), wanted.size());
  for (std::size_t p = 0; p < wanted.size(); ++p) EXPECT_EQ(tallies[p].moments, wanted[p]);
  const auto again = label(s);  // from what is on disk
  for (std::size_t p = 0; p < wanted.size(); ++p) EXPECT_EQ(again[p].content_id, tallies[p].content_id);
}

TEST(LabelPass, DoesNotKnowTheBlocks) {
  const auto points = roof_gable();
  const PlaneStore whole(points), cut(points, {500, 2000, 1});
  const auto a = label(whole), b = label(cut);
  EXPECT_EQ(test::whole_column(whole.cloud.store(), columns::kPlane),
            test::whole_column(cut.cloud.store(), columns::kPlane));
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t p = 0; p < a.size(); ++p) EXPECT_EQ(a[p].content_id, b[p].content_id);
}

TEST(LabelPass, PointsThatAreNotWantedGetNone) {
  const PlaneStore s(roof_gable());
  PassContext context;
  context.wanted = [](Index3 p) { return p.x < kRoofRidge; };
  const auto tallies = label(s, context);
  const auto where = test::positions(s.cloud.store());
  const auto plane = test::whole_column(s.cloud.store(), columns::kPlane);
  std::int64_t labelled = 0;
  for (std::size_t i = 0; i < where.size(); ++i) {
    ASSERT_TRUE(where[i].x < kRoofRidge || plane[i] == 0);
    labelled += plane[i] != 0;
  }
  EXPECT_EQ(tallies[0].moments.n + tallies[1].moments.n, labelled);
}

}  // namespace
}  // namespace ilot
