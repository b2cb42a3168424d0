// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/measure.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstring>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

struct TestPoint {
  std::int32_t x, y, z;
  std::uint8_t classification = 2, return_number = 1, return_count = 1;
  bool valid = true;
};

// A cloud in memory, millimetres.
class MemoryReader : public PointReader {
 public:
  explicit MemoryReader(std::vector<TestPoint> points, double metres_per_unit = 1) : points_(std::move(points)) {
    info_.points = info_.declared_points = points_.size();
    info_.crs.metres_per_unit = info_.crs.metres_per_unit_z = metres_per_unit;
  }
  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return true; }
  std::vector<std::uint64_t> boundaries() const override { return {0, points_.size()}; }
  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    const std::size_t length = info_.layout.record_length;
    std::size_t i = 0;
    for (; i < valid.size() && first + i < points_.size(); ++i) {
      const TestPoint& p = points_[first + i];
      PointFields fields;
      fields.x = p.x, fields.y = p.y, fields.z = p.z;
      fields.classification = p.classification;
      fields.return_number = p.return_number, fields.return_count = p.return_count;
      encode_fields(fields, records.subspan(i * length, length), 0);
      valid[i] = p.valid;
    }
    return i;
  }

 private:
  std::vector<TestPoint> points_;
  CloudInfo info_;
};

CloudMeasure measure(std::vector<TestPoint> points, double metres_per_unit = 1) {
  MemoryReader reader(std::move(points), metres_per_unit);
  return measure_cloud(reader);
}

std::vector<TestPoint> grid(int columns, int rows, int step) {
  std::vector<TestPoint> points;
  for (int i = 0; i < columns; ++i) {
    for (int j = 0; j < rows; ++j) points.push_back({i * step, j * step, 0});
  }
  return points;
}

TEST(Measure, AGrid) {
  const CloudMeasure m = measure(grid(200, 100, 500));
  EXPECT_EQ(m.points, 20000u);
  EXPECT_EQ(m.classes[2], 20000u);
  EXPECT_EQ(m.max.x, 99.5);
  EXPECT_NEAR(m.sampling_step, 0.5, 1e-9);
  EXPECT_NEAR(m.density, 4, 0.4);
}

TEST(Measure, FeetAreConverted) {
  const CloudMeasure m = measure(grid(200, 100, 500), 0.3048);
  EXPECT_NEAR(m.sampling_step, 0.1524, 1e-9);
  EXPECT_NEAR(m.density, 4 / (0.3048 * 0.3048), 4.3);
  EXPECT_EQ(m.max.x, 99.5) << "the box stays in units of the CRS";
}

TEST(Measure, CountsWhatIsRejectedAndWhatIsLast) {
  const CloudMeasure m =
      measure({{0, 0, 0, 6, 1, 2}, {0, 0, 9, 6, 2, 2}, {1, 1, 1, 2, 0, 0}, {7, 7, 7, 2, 1, 1, false}});
  EXPECT_EQ(m.points, 3u);
  EXPECT_EQ(m.rejected, 1u);
  EXPECT_EQ(m.last_returns, 2u);
  EXPECT_EQ(m.classes[6], 2u);
  EXPECT_DOUBLE_EQ(m.max.z, 0.009);
}

TEST(Measure, StepIgnoresRepeatedPointsAndMatchesBruteForce) {
  Rng rng(3);
  std::vector<TestPoint> points;
  for (int i = 0; i < 1500; ++i) {
    points.push_back({static_cast<std::int32_t>(rng.below(40000)), static_cast<std::int32_t>(rng.below(40000)),
                      static_cast<std::int32_t>(rng.below(3000))});
  }
  std::vector<double> steps;
  for (const TestPoint& a : points) {
    double best = 1e300;
    for (const TestPoint& b : points) {
      const Vec3 d{0.001 * a.x - 0.001 * b.x, 0.001 * a.y - 0.001 * b.y, 0.001 * a.z - 0.001 * b.z};
      if (norm(d) > 0) best = std::min(best, norm(d));
    }
    steps.push_back(best);
  }
  std::sort(steps.begin(), steps.end());
  const std::vector<TestPoint> once = points;
  points.insert(points.end(), once.begin(), once.end());
  EXPECT_NEAR(measure(points).sampling_step, steps[steps.size() / 2], 0.05 * steps[steps.size() / 2]);
}

// What stands alone changes nothing but its own account, wherever in the file it is.
TEST(Measure, StraysAreMeasuredApart) {
  const auto cloud = grid(200, 100, 500);
  const CloudMeasure clean = measure(cloud);
  EXPECT_EQ(clean.strays, 0u);
  EXPECT_EQ(clean.all_max.x, clean.max.x);
  for (const bool in_front : {true, false}) {
    auto points = cloud;
    const std::vector<TestPoint> zeros(3000, TestPoint{-2000000000, -2000000000, 0});
    points.insert(in_front ? points.begin() : points.end(), zeros.begin(), zeros.end());
    const CloudMeasure m = measure(points);
    EXPECT_EQ(m.strays, 3000u);
    EXPECT_EQ(m.points, 23000u);
    EXPECT_EQ(m.min.x, clean.min.x);
    EXPECT_EQ(m.max.y, clean.max.y);
    EXPECT_EQ(m.all_min.x, -2000000.0);
    EXPECT_EQ(m.occupied_area, clean.occupied_area);
    EXPECT_EQ(m.density, clean.density);
    EXPECT_EQ(m.last_return_density, clean.last_return_density);
    EXPECT_EQ(m.sampling_step, clean.sampling_step);
  }
}

TEST(Measure, DegenerateClouds) {
  EXPECT_EQ(measure({}).points, 0u);
  EXPECT_EQ(measure({}).density, 0);
  EXPECT_EQ(measure({{1, 1, 1, 2, 1, 1, false}}).rejected, 1u);
  const CloudMeasure same = measure(std::vector<TestPoint>(1000, TestPoint{5, 5, 5}));
  EXPECT_EQ(same.sampling_step, 0);
  EXPECT_EQ(same.points, 1000u);
  const CloudMeasure line = measure(grid(5000, 1, 100));
  EXPECT_NEAR(line.sampling_step, 0.1, 1e-9);
  EXPECT_GT(line.density, 0);
  const CloudMeasure far = measure({{-2147483647 - 1, -2147483647 - 1, 0}, {2147483647, 2147483647, 0}});
  EXPECT_EQ(far.points, 2u);
  EXPECT_GT(far.occupied_area, 0);
}

TEST(Measure, ReportsProgressTwiceOverThePoints) {
  MemoryReader reader(grid(300, 300, 10));
  std::uint64_t seen = 0;
  measure_cloud(reader, [&](std::uint64_t n) { seen += n; });
  EXPECT_EQ(seen, 180000u);
}

}  // namespace
}  // namespace ilot
