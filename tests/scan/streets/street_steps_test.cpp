// SPDX-License-Identifier: Apache-2.0
// The steps of engine/streets on the scene `street`, against its truth.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "engine/products/streets/ground/artefacts.h"
#include "engine/products/streets/objects/separation.h"
#include "kernels/core/parallel.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/morphology/profile.h"
#include "kernels/rasters/hough_lines.h"
#include "scan/scanners/scan_record.h"
#include "scan/streets/street_scan.h"
#include "tests/oracles/range_image.h"
#include "tests/oracles/whole_street.h"
#include "tests/support/scan_records.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kStepsRecord = 45;

// Millimetres in the scene, where the street lies aslant.
struct StreetCloud : PaddedPoints {
  std::vector<RecordTruth> truth;
};

StreetCloud scanned(std::initializer_list<const char*> settings) {
  SceneValues values(street_options());
  for (const char* setting : settings) values.set(setting);
  StreetScan scan = plan_street_scan(values, 0);
  const StreetStage stage = set_stage(scan);
  const RecordLayout layout = coloured_layout(0.001);
  StreetCloud cloud;
  with_threads(2, [&] {
    scan_street(scan, stage, [&](std::span<const std::byte> records) {
      for (std::size_t at = 0; at < records.size(); at += kStepsRecord) {
        const Vec3 p = place_of(&records[at], layout);
        cloud.add(static_cast<float>(std::floor(1000 * p.x)), static_cast<float>(std::floor(1000 * p.y)),
                  static_cast<float>(std::floor(1000 * p.z)));
        cloud.truth.push_back(truth_of(&records[at]));
      }
    });
  });
  cloud.pad();
  return cloud;
}

bool is_object(std::uint8_t true_class) {
  return true_class >= static_cast<std::uint8_t>(StreetClass::car) &&
         true_class <= static_cast<std::uint8_t>(StreetClass::other);
}

std::uint32_t most_common(const std::map<std::uint32_t, std::size_t>& counts) {
  return std::max_element(counts.begin(), counts.end(), [](auto& a, auto& b) { return a.second < b.second; })->first;
}

// One block without trees, whose crowns hide the ground from above.
TEST(StreetSteps, GroundAndObjectsOfOneBlock) {
  const StreetCloud cloud = scanned({"scene.blocks=1", "scene.trees=0"});
  const test::RangeImage image = test::range_image(cloud.points(), 50);
  const test::Ground ground = test::find_ground(image.range, {});
  const test::Artefacts artefacts = test::find_artefacts(ground, {});
  const PixelLabels objects = separate_artefacts(artefacts.height, {});

  const std::vector<std::uint32_t>& pixels = image.pixel_of;
  std::size_t ground_points = 0, found_ground = 0, facade_points = 0, facade_off_ground = 0;
  std::map<std::uint32_t, std::map<std::uint32_t, std::size_t>> labels_of, objects_of;  // points by the other
  std::map<std::uint32_t, std::size_t> points_of;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const RecordTruth& truth = cloud.truth[i];
    const bool on_ground = truth.true_class == static_cast<std::uint8_t>(StreetClass::ground);
    const bool on_facade = truth.true_class == static_cast<std::uint8_t>(StreetClass::facade);
    ground_points += on_ground;
    found_ground += on_ground && artefacts.ground[pixels[i]] != 0;
    facade_points += on_facade;
    facade_off_ground += on_facade && ground.mask[pixels[i]] == 0;
    if (!is_object(truth.true_class)) continue;
    ++points_of[truth.true_element];
    if (const std::uint32_t label = objects.of[pixels[i]]; label != 0) {
      ++labels_of[truth.true_element][label];
      ++objects_of[label][truth.true_element];
    }
  }
  EXPECT_GT(static_cast<double>(found_ground), 0.99 * static_cast<double>(ground_points));
  EXPECT_GT(static_cast<double>(facade_off_ground), 0.98 * static_cast<double>(facade_points));
  ASSERT_EQ(points_of.size(), 15u);
  for (const auto& [object, points] : points_of) {
    ASSERT_EQ(labels_of.count(object), 1u) << object;
    EXPECT_EQ(most_common(objects_of[most_common(labels_of[object])]), object) << "shares its label";
  }
}

// City blocks at 5 pixels a metre: both facades' lines, and on each the streets between three blocks.
TEST(StreetSteps, StreetsBetweenBlocks) {
  const StreetCloud cloud = scanned({"scene.blocks=3", "scene.profiles=3", "scene.slope=5"});
  const test::RangeImage image = test::range_image(cloud.points(), 200);
  const auto lines = hough_lines(image.range, {.max_lines = 2});
  ASSERT_EQ(lines.size(), 2u);
  EXPECT_GT(lines[0].line.nx * lines[1].line.nx + lines[0].line.ny * lines[1].line.ny, 0.9999);
  for (const HoughLine& line : lines) {
    const LineProfile profile = profile_along(image.range, line.line, 5);
    const auto cuts = profile_cuts(running_median(profile.heights, 5), 5000);
    EXPECT_EQ(cuts.size(), 2u);
    for (const ProfileCut& cut : cuts) EXPECT_NEAR(0.2 * (cut.to - cut.from + 1), 11, 3);  // metres
  }
}

}  // namespace
}  // namespace ilot::scan
