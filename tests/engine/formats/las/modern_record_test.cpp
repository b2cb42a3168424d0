// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/las/modern_record.h"

#include <tuple>

#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

TEST(ModernRecord, FormatsKeepTheirColours) {
  const std::uint8_t expected[11]{6, 6, 7, 7, 6, 7, 6, 7, 8, 6, 8};
  for (std::uint8_t format = 0; format <= 10; ++format) EXPECT_EQ(modern_format(format), expected[format]);
}

TEST(ModernRecord, ModernRowsStayAsTheyAre) {
  for (const std::uint8_t format : {6, 7, 8}) {
    const auto rows = test::random_bytes(500 * (standard_size(format) + 3), format);
    std::vector<std::byte> out(rows.size());
    modernise(rows, format, 3, out);
    EXPECT_TRUE(out == rows) << int(format);
  }
}

TEST(ModernRecord, EveryFieldOfOldRowsIsThere) {
  for (const std::uint8_t format : {0, 1, 2, 3, 4, 5, 9, 10}) {
    SCOPED_TRACE(int(format));
    constexpr std::size_t kExtra = 5;
    const std::uint8_t to = modern_format(format);
    const std::size_t before = standard_size(format), after = standard_size(to);
    const auto rows = test::random_bytes(500 * (before + kExtra), 20u + format);
    std::vector<std::byte> out(500 * (after + kExtra));
    modernise(rows, format, kExtra, out);
    for (std::size_t i = 0; i < 500; ++i) {
      const std::byte *a = &rows[i * (before + kExtra)], *b = &out[i * (after + kExtra)];
      const PointFields f = decode_fields({a, before}, format), g = decode_fields({b, after}, to);
      EXPECT_EQ(std::tie(f.x, f.y, f.z, f.intensity, f.return_number, f.return_count, f.classification, f.user_data),
                std::tie(g.x, g.y, g.z, g.intensity, g.return_number, g.return_count, g.classification, g.user_data));
      EXPECT_EQ(std::tie(f.withheld, f.synthetic, f.key_point, f.overlap, f.scan_direction, f.edge_of_flight_line),
                std::tie(g.withheld, g.synthetic, g.key_point, g.overlap, g.scan_direction, g.edge_of_flight_line));
      EXPECT_EQ(std::tie(f.scanner_channel, f.source_id), std::tie(g.scanner_channel, g.source_id));
      EXPECT_NEAR(f.scan_angle_deg, g.scan_angle_deg, 0.003000001);
      const auto same = [&](std::optional<std::size_t> from, std::optional<std::size_t> place, std::size_t bytes) {
        return !from || (place && std::equal(a + *from, a + *from + bytes, b + *place));
      };
      EXPECT_TRUE(same(gps_time_offset(format), gps_time_offset(to), 8));
      EXPECT_TRUE(same(rgb_offset(format), rgb_offset(to), 6));
      EXPECT_TRUE(same(nir_offset(format), nir_offset(to), 2));
      EXPECT_TRUE(std::equal(a + before, a + before + kExtra, b + after));
      if (!gps_time_offset(format)) {
        EXPECT_EQ(load<std::uint64_t>(b + *gps_time_offset(to)), 0u);
      }
    }
  }
}

TEST(ModernRecord, ExtraFieldsMoveAndALongRecordIsRefused) {
  CloudSpec spec;
  spec.like.layout.point_format = 1;
  spec.like.layout.record_length = 30;
  ExtraField field;
  field.name = "amplitude";
  field.type = FieldType::u16;
  field.offset = 28;
  field.size = 2;
  spec.like.layout.extra.push_back(field);
  const CloudSpec modern = modern_spec(spec);
  EXPECT_EQ(modern.like.layout.record_length, 32);
  EXPECT_EQ(modern.like.layout.extra[0].offset, 30);
  spec.like.layout.record_length = 65535;
  EXPECT_THROW(modern_spec(spec), Error);
}

}  // namespace
}  // namespace ilot
