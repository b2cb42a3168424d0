// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/survey/survey_points.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <functional>

#include "engine/pass/measure_store.h"
#include "engine/scale/plan_areas.h"
#include "kernels/core/parallel.h"
#include "tests/support/cloud_store.h"

namespace ilot {
namespace {

constexpr Index3 kTown{651000000, 661000000, 50000};
constexpr std::uint8_t kNoise = 7;

struct Cloud {
  std::vector<Index3> points;
  std::vector<std::uint8_t> classes;

  void add(Index3 p, std::uint8_t code) {
    points.push_back(p);
    classes.push_back(code);
  }
};

// Quarters of a town 2 km apart.
Cloud town(std::size_t points, std::uint64_t key) {
  Cloud cloud;
  Rng rng(key);
  const auto within = [&](std::uint64_t reach) { return static_cast<std::int64_t>(rng.below(reach)); };
  for (std::size_t i = 0; i < points; ++i) {
    const std::int64_t quarter = static_cast<std::int64_t>(i * 5 / points) * 2000000;
    cloud.add({kTown.x + quarter + within(300000), kTown.y + within(200000), kTown.z + within(9000)},
              static_cast<std::uint8_t>(2 + rng.below(3) * 2));
  }
  return cloud;
}

// Rays without an echo in the middle of the rows and a bird high above the town.
void add_strays(Cloud& cloud) {
  for (std::size_t i = 0; i < 300; ++i) {
    cloud.points.insert(cloud.points.begin() + static_cast<std::ptrdiff_t>(i * 7), Index3{});
    cloud.classes.insert(cloud.classes.begin() + static_cast<std::ptrdiff_t>(i * 7), 0);
  }
  cloud.add({kTown.x + 150000, kTown.y, kTown.z + 3000000}, 1);
}

struct Files {
  TemporaryFolder folder;
  std::vector<std::unique_ptr<PointReader>> inputs;
  IndexParams params;
  PassContext context;

  explicit Files(const std::vector<Cloud>& clouds) {
    for (std::size_t i = 0; i < clouds.size(); ++i) {
      const auto path = folder.path() / ("cloud" + std::to_string(i) + (i % 2 == 0 ? ".laz" : ".las"));
      test::write_cloud(path, clouds[i].points, clouds[i].classes);
      inputs.push_back(open_cloud(path));
    }
    params.unit = test::kUnit;
    params.run_points = params.block_points = 20000;
    params.classes = ClassColumns::written;
    params.filter.coarse_bits = coarse_bits(test::kUnit);
    params.filter.noise.set(kNoise);
  }
  PointSurvey survey() const { return survey_points(inputs, params, context); }
  IndexResult index() const { return build_index(inputs, params, folder.path() / "store", context); }
};

std::uint64_t count(const PointSurvey& survey) {
  std::uint64_t points = 0;
  for (const auto& [square, n] : survey.map.squares()) points += n;
  return points;
}

void expect_as_indexed(const Files& files, bool as_stated) {
  const PointSurvey survey = files.survey();
  const IndexResult index = files.index();
  EXPECT_EQ(survey.lattice, index.lattice);
  EXPECT_EQ(survey.rejected, index.rejected);
  EXPECT_EQ(survey.corner, index.corner);
  EXPECT_EQ(survey.strays.cells(), index.strays.cells());
  EXPECT_EQ(survey.strays.bits(), index.strays.bits());
  EXPECT_EQ(survey.points, index.store.points());
  EXPECT_EQ(survey.box, index.store.box());
  EXPECT_EQ(count(survey), index.store.points());
  const CloudMeasure stored = measure_store(index.store, files.context);
  EXPECT_EQ(survey.classes, stored.classes);
  ASSERT_EQ(survey.measure.has_value(), as_stated);
  const CloudMeasure measure =
      as_stated ? *survey.measure : measure_points(files.inputs, files.params, survey, files.context);
  EXPECT_EQ(measure.points, stored.points);
  EXPECT_EQ(measure.classes, stored.classes);
  EXPECT_EQ(measure.density, stored.density);
  EXPECT_EQ(measure.sampling_step, stored.sampling_step);
  EXPECT_EQ(measure.last_returns, stored.last_returns);
}

TEST(SurveyPoints, DecidesAsTheIndexOfARun) {
  expect_as_indexed(Files({town(60000, 1), town(90000, 2)}), true);
}

TEST(SurveyPoints, LeavesOutStraysAndNoise) {
  Cloud with = town(70000, 3);
  add_strays(with);
  expect_as_indexed(Files({with, town(60000, 4)}), false);
  for (std::size_t i = 0; i < with.classes.size(); i += 5) with.classes[i] = kNoise;
  expect_as_indexed(Files({town(60000, 5), with}), false);
}

TEST(SurveyPoints, KeepsStraysWhereAsked) {
  Cloud with = town(70000, 3);
  add_strays(with);
  Files files({with});
  files.params.keep_strays = true;
  expect_as_indexed(files, true);
}

TEST(SurveyPoints, KnowsWhereChunksLie) {
  Cloud with = town(120000, 6);
  add_strays(with);
  const Files files({with});
  const PointSurvey survey = files.survey();
  const ChunkBoxes& chunks = survey.chunks.at(0);
  ASSERT_GT(chunks.boxes.size(), 2u);
  std::vector<IndexBox> expected(chunks.boxes.size(), IndexBox::none());
  for (std::size_t row = 0; row < with.points.size(); ++row)
    if (!survey.strays.contains(with.points[row])) expected[chunks.chunk_of(row)].add(with.points[row]);
  EXPECT_EQ(chunks.boxes, expected);
  EXPECT_GT(chunks.boxes[0].min.x, kTown.x - 1);
}

// The points of a cloud in so many files, one after the other.
std::vector<Cloud> parts_of(const Cloud& cloud, std::size_t files) {
  std::vector<Cloud> parts(files);
  for (std::size_t i = 0; i < cloud.points.size(); ++i)
    parts[i * files / cloud.points.size()].add(cloud.points[i], cloud.classes[i]);
  return parts;
}

TEST(SurveyPoints, DoesNotDependOnFilesOrThreads) {
  Cloud with = town(150000, 7);
  add_strays(with);
  const Files one({with}), many(parts_of(with, 7));
  const PointSurvey whole = one.survey(), parts = many.survey();
  PointSurvey threads;
  with_threads(3, [&] { threads = many.survey(); });
  for (const auto& each : {std::cref(parts), std::cref<PointSurvey>(threads)}) {
    const PointSurvey& other = each.get();
    EXPECT_EQ(other.map.squares(), whole.map.squares());
    EXPECT_EQ(other.strays.cells(), whole.strays.cells());
    EXPECT_EQ(other.classes, whole.classes);
    EXPECT_EQ(other.box, whole.box);
    EXPECT_EQ(other.rejected, whole.rejected);
    EXPECT_EQ(other.tiles, whole.tiles);
  }
}

TEST(SurveyPoints, BelievesNoHead) {
  const Files files({town(60000, 1)});
  const auto path = files.folder.path() / "cloud0.laz";
  std::fstream file(path, std::ios::binary | std::ios::in | std::ios::out);
  constexpr std::streamoff kMaxX = 179;  // of a LAS header
  const double less = 0.001 * static_cast<double>(kTown.x + 200000);
  file.seekp(kMaxX).write(reinterpret_cast<const char*>(&less), sizeof less);
  file.close();
  Files again({town(60000, 1)});
  again.inputs[0] = open_cloud(path);
  expect_as_indexed(again, false);
}

TEST(SurveyPoints, ReadsTextFrontToBack) {
  const Cloud cloud = town(3000, 2);
  Files files({town(60000, 3)});
  const auto path = files.folder.path() / "text.xyz";
  std::ofstream text(path);
  for (const Index3& p : cloud.points)
    text << fmt::format("{:.3f} {:.3f} {:.3f}\n", 0.001 * p.x, 0.001 * p.y, 0.001 * p.z);
  text.close();
  files.inputs.push_back(open_cloud(path));
  expect_as_indexed(files, false);
}

// A cloud that is so wide that strays are found in larger cells.
TEST(SurveyPoints, ManyCoarseCells) {
  Cloud wide;
  constexpr std::int64_t kSide = 100, kApart = 600000;
  for (std::int64_t i = 0; i < kSide * kSide; ++i)
    for (std::int64_t k = 0; k < 12; ++k) wide.add({i % kSide * kApart + k * 900, i / kSide * kApart, 10 * k}, 2);
  wide.add({0, 0, 30000000}, 1);
  const Files files({wide});
  expect_as_indexed(files, false);
  const PointSurvey survey = files.survey();
  EXPECT_GT(survey.strays.bits(), coarse_bits(test::kUnit));
  EXPECT_EQ(survey.rejected[static_cast<std::size_t>(Rejection::stray)], 1u);
}

TEST(SurveyPoints, MeasuresTheSameInAnyOrder) {
  Cloud cloud = town(200000, 9);  // more points in a window than are kept
  const double step = Files({cloud}).survey().measure->sampling_step;
  std::reverse(cloud.points.begin(), cloud.points.end());
  std::reverse(cloud.classes.begin(), cloud.classes.end());
  EXPECT_EQ(Files({cloud}).survey().measure->sampling_step, step);
}

TEST(SurveyPoints, AsksForAFinerLattice) {
  const Files millimetres({town(60000, 1)});
  IndexParams coarse = millimetres.params;
  coarse.unit = 0.01;
  coarse.multiple = 10;
  const PointSurvey survey = survey_points(millimetres.inputs, coarse, millimetres.context);
  EXPECT_EQ(survey.lattice, InputLattice(0.001));
  EXPECT_EQ(survey.points, 0u);
}

TEST(PointMap, CountsLargerSquaresWhereThereAreTooMany) {
  PointMap falling(0), parts(0);
  constexpr std::int64_t kSide = 1200;  // more than kMostSquares in all
  for (std::int64_t half = 1; half >= 0; --half) {
    PointMap part(0);
    for (std::int64_t i = kSide * kSide / 2; i-- > 0;) {
      const std::int64_t at = i + half * kSide * kSide / 2;
      falling.add({(at / kSide - 300) >> falling.bits(), (at % kSide) >> falling.bits()}, 2);
      part.add({(at / kSide - 300) >> part.bits(), (at % kSide) >> part.bits()}, 2);
    }
    parts.add(part);
  }
  EXPECT_EQ(falling.bits(), 1);
  EXPECT_EQ(parts.squares(), falling.squares());
  EXPECT_EQ(falling.in({{0, -300, 0}, {kSide, kSide, 0}}), static_cast<std::uint64_t>(2 * kSide * kSide));
  EXPECT_EQ(falling.in({{0, 0, 0}, {1, 1, 0}}), 8u);
}

// A square in which points are counted may be larger than an area: no area of its points may be forgotten.
TEST(PlanAreas, ALargeSquareLiesInSeveralAreas) {
  PointMap map(6);
  map.add({1, -1}, 10);  // y 64 to 127, x -64 to -1
  const std::vector<PlanArea> areas = cut_cell_areas(map, {32, 1, 3});
  ASSERT_EQ(areas.size(), 4u);
  EXPECT_EQ(areas[0].row, 2);
  EXPECT_EQ(areas[0].column, -2);
  EXPECT_EQ(areas[3].row, 3);
  EXPECT_EQ(areas[3].column, -1);
}

}  // namespace
}  // namespace ilot
