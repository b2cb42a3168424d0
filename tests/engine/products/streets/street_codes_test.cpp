// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_codes.h"

#include <gtest/gtest.h>

#include "engine/products/streets/make_streets.h"
#include "engine/products/streets/objects/object_selection.h"
#include "tests/engine/products/streets/street_runs.h"

namespace ilot {
namespace {

using test::run_cloud;
using test::street_points;

CandidateClass named(PointLabel label, double probability) {
  CandidateClass c;
  c.label = label;
  c.probability = probability;
  return c;
}

// Two sure cars, an unsure one, a bin that is sure, something that is none, and a car that is not taken.
SelectedObjects some_objects() {
  SelectedObjects s;
  s.classes = {named(PointLabel::car, 0.95), named(PointLabel::van, 0.9),  named(PointLabel::car, 0.8),
               named(PointLabel::bin, 0.99), named(PointLabel::none, 0.9), named(PointLabel::car, 0.99)};
  s.taken = {1, 1, 1, 1, 1, 0};
  s.by_hand.assign(6, 0);
  return s;
}

TEST(StreetCodes, HalfOfThePointsOfAnObjectDecide) {
  EXPECT_FALSE((CodedPoints{0, 0}.is_vegetation()));
  EXPECT_FALSE((CodedPoints{9, 4}.is_vegetation()));
  EXPECT_TRUE((CodedPoints{8, 4}.is_vegetation()));
}

TEST(StreetCodes, CodedObjectsBecomeVegetation) {
  SelectedObjects s = some_objects();
  s.by_hand[3] = 1;
  const std::vector<CodedPoints> counts{{}, {10, 0}, {10, 9}, {10, 9}, {10, 10}, {10, 10}, {10, 10}};
  RunRecord record;
  name_by_codes(counts, s, record);
  const std::vector<PointLabel> want{PointLabel::car, PointLabel::vegetation, PointLabel::vegetation,
                                     PointLabel::bin, PointLabel::vegetation, PointLabel::car};
  for (std::size_t i = 0; i < want.size(); ++i) EXPECT_EQ(s.classes[i].label, want[i]) << i;
  ASSERT_EQ(record.chosen.size(), 1u);
  EXPECT_EQ(record.chosen[0].key, "streets.trust_classes");
  EXPECT_EQ(std::get<std::string>(record.chosen[0].value), "true");
  EXPECT_NE(record.chosen[0].why.find("1 of 2 objects that are sure by their form have"), std::string::npos)
      << record.chosen[0].why;
  EXPECT_NE(record.chosen[0].why.find("2 objects"), std::string::npos) << record.chosen[0].why;
}

TEST(StreetCodes, CodesOfHeightsAreNotUsed) {
  SelectedObjects s = some_objects();
  RunRecord record;
  name_by_codes(std::vector<CodedPoints>{{}, {10, 10}, {10, 9}, {10, 9}, {10, 10}, {10, 10}, {10, 10}}, s, record);
  for (std::size_t i = 0; i < s.classes.size(); ++i) EXPECT_EQ(s.classes[i].label, some_objects().classes[i].label);
  EXPECT_EQ(std::get<std::string>(record.chosen.at(0).value), "false");
}

// Without an object that is sure nobody can tell.
TEST(StreetCodes, CodesAreNotUsedWithoutSureObjects) {
  SelectedObjects s = some_objects();
  for (CandidateClass& c : s.classes) c.probability = 0.8;
  RunRecord record;
  name_by_codes(std::vector<CodedPoints>(7, {10, 10}), s, record);
  EXPECT_EQ(s.classes[0].label, PointLabel::car);
  EXPECT_EQ(std::get<std::string>(record.chosen.at(0).value), "false");
}

TEST(StreetCodes, NothingIsSaidWithoutCodes) {
  SelectedObjects s = some_objects();
  RunRecord record;
  name_by_codes(std::vector<CodedPoints>(7, {10, 0}), s, record);
  name_by_codes({}, s, record);
  EXPECT_TRUE(record.chosen.empty());
}

// The points of a candidate above the ground, counted over all tiles.
TEST(StreetCodes, PointsAreCountedByCandidate) {
  const std::vector<Index3> points = street_points(2, 3);
  std::vector<std::uint8_t> codes(points.size(), 1);
  const auto on_first_box = [](Index3 p) {
    const std::int64_t x = p.x - 700000000, y = p.y - 660000000;
    return x >= 3000 && x < 7000 && y >= 3000 && y < 4700;
  };
  std::uint64_t coded = 0;
  for (std::size_t i = 0; i < points.size(); ++i)
    if (on_first_box(points[i])) codes[i] = 4, ++coded;
  const TemporaryFolder folder;
  test::write_cloud(folder.path() / "a.las", points, codes);
  std::vector<std::unique_ptr<PointReader>> inputs;
  inputs.push_back(open_cloud(folder.path() / "a.las"));
  IndexParams params;
  params.unit = test::kUnit;
  params.classes = ClassColumns::written;
  const Store store = build_index(inputs, params, folder.path() / "store", {}).store;
  const FoundStreet street = find_street(store, {}, {});
  const std::vector<std::uint8_t> taken(street.candidates.size(), 1);
  const std::vector<std::uint32_t> of = candidate_of_part(street.candidates, taken);
  const std::vector<CodedPoints> counts = coded_points(store, *street.tiles, of, std::vector<int>{3, 4, 5}, 0.1);
  std::uint64_t all = 0, vegetation = 0, objects = 0;
  for (const CodedPoints& c : counts) all += c.all, vegetation += c.vegetation, objects += c.is_vegetation();
  EXPECT_EQ(vegetation, coded);
  EXPECT_EQ(objects, 1u);
  EXPECT_GE(all, 3 * coded);
  const test::CloudStore without(points);
  EXPECT_TRUE(coded_points(without.store(), *street.tiles, of, std::vector<int>{3}, 0.1).empty());
}

}  // namespace
}  // namespace ilot
