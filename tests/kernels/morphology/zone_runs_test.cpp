// SPDX-License-Identifier: Apache-2.0
#include "kernels/morphology/zone_runs.h"

#include <gtest/gtest.h>

#include "tests/support/flooded_zones.h"

namespace ilot {
namespace {

using test::kAdjacencies;

std::vector<std::uint8_t> flags_of(const Image& image, const std::function<bool(Height)>& flagged) {
  std::vector<std::uint8_t> flags;
  for (const Height v : image.values) flags.push_back(flagged(v) ? 1 : 0);
  return flags;
}

PixelLabels flooded_flags(const Image& image, const std::vector<std::uint8_t>& flags, Adjacency adjacency) {
  return test::flooded(
      image.width, image.height, adjacency, [&](std::size_t p) { return flags[p] != 0; },
      [](std::size_t, std::size_t) { return true; });
}

// Runs lie row by row, left to right, apart from each other, and each pixel of a zone is in one.
void expect_painted(const ZoneRuns& runs, const PixelLabels& want, const std::string& name) {
  ASSERT_EQ(runs.first.size(), std::size_t{runs.height} + 1) << name;
  EXPECT_EQ(runs.count, want.count) << name;
  PixelLabels got{runs.width, runs.height, runs.count, std::vector<std::uint32_t>(want.of.size(), 0)};
  for (std::uint32_t y = 0; y < runs.height; ++y) {
    std::uint32_t end = 0;
    for (std::uint32_t r = runs.first[y]; r < runs.first[y + 1]; ++r) {
      const PixelRun run = runs.runs[r];
      ASSERT_TRUE(end <= run.from && run.from < run.to && run.to <= runs.width) << name;
      end = run.to;
      for (std::uint32_t x = run.from; x < run.to; ++x) got.of[std::size_t{y} * runs.width + x] = runs.zone[r];
    }
  }
  EXPECT_EQ(got.of, want.of) << name;
  EXPECT_EQ(painted(runs).of, want.of) << name;
}

TEST(ZoneRuns, TwoRowsByHand) {
  const ZoneRuns runs = zone_runs({4,
                                   2,
                                   {3, 3, 9, 3,  //
                                    8, 9, 3, 3}},
                                  1, Adjacency::four);
  EXPECT_EQ(runs.first, (std::vector<std::uint32_t>{0, 3, 5}));
  EXPECT_EQ(runs.zone, (std::vector<std::uint32_t>{1, 2, 3, 4, 3}));
  EXPECT_EQ(runs.runs[0].to, 2u);
  EXPECT_EQ(runs.runs[4].from, 2u);
  EXPECT_EQ(zones_on_border(runs), (std::vector<std::uint8_t>{0, 1, 1, 1, 1}));
}

TEST(ZoneRuns, EqualTheFlood) {
  for (const auto& [name, image] : test::small_images())
    for (const Adjacency adjacency : kAdjacencies)
      for (const Height lambda : {0, 1, 40}) {
        const std::string message = name + " lambda " + std::to_string(lambda);
        expect_painted(zone_runs(image, lambda, adjacency), test::flooded_zones(image, lambda, adjacency), message);
      }
}

TEST(ZoneRuns, FlaggedAndMissingEqualTheFlood) {
  for (const auto& [name, image] : test::small_images())
    for (const Adjacency adjacency : kAdjacencies) {
      const auto odd = flags_of(image, [](Height v) { return v != kNoHeight && v % 2 != 0; });
      expect_painted(flagged_runs(image.width, image.height, odd, adjacency), flooded_flags(image, odd, adjacency),
                     name);
      const auto missing = flags_of(image, [](Height v) { return v == kNoHeight; });
      expect_painted(missing_runs(image, adjacency), flooded_flags(image, missing, adjacency), name);
    }
}

TEST(ZoneRuns, OnTheBorderIsWhatHasAPixelThere) {
  std::size_t inner = 0;
  for (const auto& [name, image] : test::small_images()) {
    const ZoneRuns runs = zone_runs(image, 0, Adjacency::eight);
    const PixelLabels zones = test::flooded_zones(image, 0, Adjacency::eight);
    std::vector<std::uint8_t> want(zones.count + 1, 0);
    for (std::size_t p = 0; p < image.size(); ++p)
      if (zones.of[p] != 0 && test::neighbours_of(image.width, image.height, p, Adjacency::eight).size() < 8)
        want[zones.of[p]] = 1;
    EXPECT_EQ(zones_on_border(runs), want) << name;
    inner += static_cast<std::size_t>(std::count(want.begin() + 1, want.end(), 0));
  }
  EXPECT_GT(inner, 50u);
}

}  // namespace
}  // namespace ilot
