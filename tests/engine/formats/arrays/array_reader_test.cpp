// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/arrays/array_reader.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <iterator>

#include "engine/error.h"
#include "engine/formats/arrays/npy_writer.h"
#include "ilot/clouds.h"
#include "kernels/core/rng.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

struct Owned {
  std::vector<double> x, y, z;
  std::vector<std::uint16_t> intensity, red;
  std::vector<std::uint8_t> classification;

  ArrayCloud cloud() const {
    ArrayCloud cloud{"town", x, y, z, intensity, classification};
    cloud.red = red;
    return cloud;
  }
};

Owned some_points(std::size_t count) {
  Rng rng(7);
  Owned p;
  for (std::size_t i = 0; i < count; ++i) {
    p.x.push_back(651000 + 300 * rng.uniform());
    p.y.push_back(6862000 - 300 * rng.uniform());
    p.z.push_back(40 * rng.uniform() - 5);
    p.intensity.push_back(static_cast<std::uint16_t>(65535 * rng.uniform()));
    p.red.push_back(static_cast<std::uint16_t>(i));
    p.classification.push_back(static_cast<std::uint8_t>(i % 20));
  }
  return p;
}

std::vector<std::byte> rows_of(PointReader& reader) {
  std::vector<std::byte> rows(reader.info().points * reader.info().layout.record_length);
  std::vector<std::uint8_t> valid(reader.info().points);
  EXPECT_EQ(reader.read(0, rows, valid), reader.info().points);
  return rows;
}

std::string fault_of(const ArrayCloud& cloud) {
  try {
    open_arrays(cloud);
  } catch (const Error& fault) {
    EXPECT_EQ(fault.code(), ExitCode::usage);
    return fault.what();
  }
  return "none";
}

TEST(ArrayReader, GivesTheRowsOfTheFileThatIsWrittenFromTheArrays) {
  const TemporaryFolder folder;
  const Owned points = some_points(3000);
  CloudWriterOptions options;
  options.offset = {std::floor(points.x[0]), std::floor(points.y[0]), std::floor(points.z[0])};
  options.colour = true;
  CloudWriter writer(folder.path() / "town.las", options);
  PointColumns columns;
  columns.x = points.x;
  columns.y = points.y;
  columns.z = points.z;
  columns.intensity = points.intensity;
  columns.classification = points.classification;
  columns.red = points.red;
  writer.write(columns);
  writer.finish();
  const auto from_file = open_cloud(folder.path() / "town.las");
  const auto from_memory = open_arrays(points.cloud());
  EXPECT_EQ(from_file->info().layout.scale, from_memory->info().layout.scale);
  EXPECT_EQ(from_file->info().layout.offset, from_memory->info().layout.offset);
  EXPECT_EQ(rows_of(*from_file), rows_of(*from_memory));
}

TEST(ArrayReader, ReadsAnyStretch) {
  const Owned points = some_points(1000);
  const auto reader = open_arrays(points.cloud());
  const std::vector<std::byte> all = rows_of(*reader);
  const std::size_t length = reader->info().layout.record_length;
  std::vector<std::byte> some(10 * length);
  std::vector<std::uint8_t> valid(10);
  EXPECT_EQ(reader->read(995, some, valid), 5u);
  EXPECT_TRUE(std::equal(some.begin(), some.begin() + static_cast<std::ptrdiff_t>(5 * length),
                         all.end() - static_cast<std::ptrdiff_t>(5 * length)));
  EXPECT_EQ(reader->read(1000, some, valid), 0u);
  EXPECT_EQ(reader->boundaries(), (std::vector<std::uint64_t>{0, 1000}));
}

TEST(ArrayReader, RefusesWhatIsNoCloud) {
  Owned points = some_points(10);
  ArrayCloud cloud = points.cloud();
  cloud.name = "../town";
  EXPECT_NE(fault_of(cloud).find("no name"), std::string::npos);
  points.red.pop_back();
  EXPECT_NE(fault_of(points.cloud()).find("9 values for 10 points"), std::string::npos);
  points.red.clear();
  points.y[4] = std::nan("");
  EXPECT_EQ(fault_of(points.cloud()), "town: y[4] = nan is not finite");
  points.y[4] = 1e9;
  EXPECT_NE(fault_of(points.cloud()).find("y[4]"), std::string::npos);
  points.y.pop_back();
  EXPECT_NE(fault_of(points.cloud()).find("different lengths"), std::string::npos);
  EXPECT_NE(fault_of(ArrayCloud{}).find("no points"), std::string::npos);
}

TEST(ArrayReader, TheSumNoticesEveryChange) {
  Owned points = some_points(1000);
  const std::string before = content_sum(points.cloud());
  EXPECT_EQ(before, content_sum(some_points(1000).cloud()));
  std::swap(points.z[3], points.z[4]);
  EXPECT_NE(before, content_sum(points.cloud()));
  std::swap(points.z[3], points.z[4]);
  ++points.classification[999];
  EXPECT_NE(before, content_sum(points.cloud()));
  --points.classification[999];
  ArrayCloud cloud = points.cloud();
  EXPECT_EQ(before, content_sum(cloud));
  cloud.crs = "EPSG:2154";
  EXPECT_NE(before, content_sum(cloud));
}

TEST(NpyWriter, WritesWhatTheFormatSays) {
  const TemporaryFolder folder;
  CloudSpec spec;
  spec.like.layout.record_length = 20;
  spec.like.points = 2;
  spec.appended = {{"plane_id", "", FieldType::u32, 0, 4}, {"residual", "", FieldType::f32, 0, 4}};
  const auto writer = create_npy(folder.path() / "labels.npy", spec);
  ASSERT_EQ(writer->record_length(), 28u);
  std::vector<std::byte> rows(56);
  store(&rows[20], std::uint32_t{7});
  store(&rows[24], 0.5f);
  store(&rows[48], std::uint32_t{9});
  store(&rows[52], -1.0f);
  writer->write(rows);
  writer->finish();
  std::ifstream file(folder.path() / "labels.npy", std::ios::binary);
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  EXPECT_EQ(text.substr(0, 8), std::string("\x93NUMPY\x01\0", 8));
  const std::size_t head = 10 + static_cast<unsigned char>(text[8]) + 256u * static_cast<unsigned char>(text[9]);
  EXPECT_EQ(head % 64, 0u);
  EXPECT_NE(text.find("[('plane_id', '<u4'), ('residual', '<f4'), ]"), std::string::npos);
  ASSERT_EQ(text.size(), head + 16);
  EXPECT_EQ(load<std::uint32_t>(reinterpret_cast<const std::byte*>(&text[head + 8])), 9u);
  EXPECT_EQ(load<float>(reinterpret_cast<const std::byte*>(&text[head + 12])), -1.0f);
}

TEST(NpyWriter, NothingAppearsWhereRowsAreMissing) {
  const TemporaryFolder folder;
  CloudSpec spec;
  spec.like.layout.record_length = 20;
  spec.like.points = 2;
  spec.appended = {{"plane_id", "", FieldType::u32, 0, 4}};
  {
    const auto writer = create_npy(folder.path() / "labels.npy", spec);
    writer->write(std::vector<std::byte>(24));
    EXPECT_THROW(writer->finish(), Error);
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "labels.npy"));
}

}  // namespace
}  // namespace ilot
