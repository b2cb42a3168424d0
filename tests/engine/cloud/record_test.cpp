// SPDX-License-Identifier: Apache-2.0
#include "engine/cloud/record.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TEST(Record, StandardSizesAreThoseOfTheSpecification) {
  const std::size_t sizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  for (std::uint8_t format = 0; format <= 10; ++format) EXPECT_EQ(standard_size(format), sizes[format]);
  EXPECT_EQ(standard_size(11), 0u);
}

TEST(Record, OptionalFieldsStandWhereTheSpecificationPutsThem) {
  EXPECT_FALSE(gps_time_offset(0));
  EXPECT_EQ(gps_time_offset(1), 20u);
  EXPECT_FALSE(gps_time_offset(2));
  EXPECT_EQ(gps_time_offset(10), 22u);
  EXPECT_EQ(rgb_offset(2), 20u);
  EXPECT_EQ(rgb_offset(3), 28u);
  EXPECT_FALSE(rgb_offset(4));
  EXPECT_EQ(rgb_offset(7), 30u);
  EXPECT_FALSE(rgb_offset(9));
  EXPECT_EQ(nir_offset(8), 36u);
  EXPECT_FALSE(nir_offset(7));
  EXPECT_FALSE(rgb_offset(200));
}

PointFields some_fields() {
  PointFields f;
  f.x = -2147483647 - 1;
  f.y = 2147483647;
  f.z = 1;
  f.intensity = 65535;
  f.return_number = 5;
  f.return_count = 7;
  f.classification = 31;
  f.withheld = f.key_point = f.edge_of_flight_line = true;
  f.user_data = 200;
  f.scan_angle_deg = -18;
  f.source_id = 40000;
  return f;
}

TEST(Record, FieldsSurviveEveryFormat) {
  for (std::uint8_t format = 0; format <= 10; ++format) {
    std::vector<std::byte> record(standard_size(format) + 4, std::byte{0x5A});
    const PointFields f = some_fields();
    encode_fields(f, record, format);
    const PointFields g = decode_fields(record, format);
    EXPECT_EQ(g.x, f.x);
    EXPECT_EQ(g.y, f.y);
    EXPECT_EQ(g.z, f.z);
    EXPECT_EQ(g.intensity, f.intensity);
    EXPECT_EQ(g.return_number, f.return_number);
    EXPECT_EQ(g.return_count, f.return_count);
    EXPECT_EQ(g.classification, f.classification);
    EXPECT_TRUE(g.withheld && g.key_point && g.edge_of_flight_line);
    EXPECT_FALSE(g.synthetic || g.overlap || g.scan_direction);
    EXPECT_EQ(g.user_data, f.user_data);
    EXPECT_NEAR(g.scan_angle_deg, f.scan_angle_deg, 1e-12);
    EXPECT_EQ(g.source_id, f.source_id);
    for (std::size_t i = format < 6 ? 20 : 22; i < record.size(); ++i) EXPECT_EQ(record[i], std::byte{0x5A});
  }
}

TEST(Record, DecodingThenEncodingKeepsEveryByte) {
  for (std::uint8_t format = 0; format <= 10; ++format) {
    for (int seed = 0; seed < 256; ++seed) {
      std::vector<std::byte> record(standard_size(format));
      for (std::size_t i = 0; i < record.size(); ++i)
        record[i] = static_cast<std::byte>(seed * 37 + static_cast<int>(i) * seed);
      const std::vector<std::byte> before = record;
      encode_fields(decode_fields(record, format), record, format);
      EXPECT_EQ(record, before) << "format " << int{format} << " seed " << seed;
    }
  }
}

TEST(Record, ValuesAFormatCannotHoldFollowTheRule) {
  PointFields f;
  f.return_number = 9;
  f.return_count = 15;
  f.classification = 67;
  f.scan_angle_deg = 1000;
  f.scanner_channel = 3;
  f.overlap = true;
  std::vector<std::byte> record(30);
  encode_fields(f, record, 1);
  PointFields g = decode_fields(record, 1);
  EXPECT_EQ(g.return_number, 7);
  EXPECT_EQ(g.return_count, 7);
  EXPECT_EQ(g.classification, 1);
  EXPECT_EQ(g.scan_angle_deg, 127);
  EXPECT_FALSE(g.overlap);
  encode_fields(f, record, 6);
  g = decode_fields(record, 6);
  EXPECT_EQ(g.return_number, 9);
  EXPECT_EQ(g.classification, 67);
  EXPECT_EQ(g.scanner_channel, 3);
  EXPECT_TRUE(g.overlap);
  EXPECT_NEAR(g.scan_angle_deg, 32767 * 0.006, 1e-9);
}

}  // namespace
}  // namespace ilot
