// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/e57/e57.h"

#include <cmath>

#include "engine/formats/e57/pages.h"
#include "tests/engine/formats/e57/opened_e57.h"
#include "tests/support/e57_writer.h"

namespace ilot {
namespace {

using namespace test;

E57Scan small_scan(const std::string& name, double x) {
  return {name,
          "",
          {double_field("cartesianX", {x, x + 1}), double_field("cartesianY", {2, 20}),
           double_field("cartesianZ", {3, 30})}};
}

// Scaled integers of 17 bits, colours and a state of 2 bits, over many packets.
E57Scan large_scan(std::size_t points) {
  Rng rng(5);
  std::vector<std::int64_t> x, y, z, red, state, time;
  for (std::size_t i = 0; i < points; ++i) {
    for (auto* axis : {&x, &y, &z}) axis->push_back(static_cast<std::int64_t>(rng.below(100001)) - 50000);
    red.push_back(static_cast<std::int64_t>(rng.below(256)));
    state.push_back(i % 10 == 3 ? 2 : 0);
    time.push_back(static_cast<std::int64_t>(i) * 1000003);
  }
  const std::string scale = "scale=\"0.001\" offset=\"10\"";
  return {
      "large",
      "",
      {integer_field("cartesianX", -50000, 50000, x, scale), integer_field("colorRed", 0, 255, red),
       integer_field("cartesianInvalidState", 0, 2, state), integer_field("cartesianY", -50000, 50000, y, scale),
       integer_field("colorGreen", 7, 7, std::vector<std::int64_t>(points, 7)), integer_field("colorBlue", 0, 255, red),
       integer_field("timeStamp", INT64_MIN, INT64_MAX, time), integer_field("cartesianZ", -50000, 50000, z, scale)}};
}

void expect_large(const OpenedE57& o, const E57Scan& scan, std::size_t points) {
  ASSERT_EQ(o.rows.valid.size(), points);
  for (std::size_t i = 0; i < points; ++i) {
    ASSERT_EQ(o.rows.valid[i], i % 10 == 3 ? 0 : 1);
    if (!o.rows.valid[i]) continue;
    const auto at = [&](std::size_t f) { return (static_cast<double>(scan.fields[f].stored[i]) - 50000) * 0.001 + 10; };
    ASSERT_NEAR(o.point(i).x, at(0), 1e-9);
    ASSERT_NEAR(o.point(i).y, at(3), 1e-9);
    ASSERT_NEAR(o.point(i).z, at(7), 1e-9);
    ASSERT_EQ(o.colour(i)[0], static_cast<int>(scan.fields[1].stored[i]) * 257);
    ASSERT_EQ(load<double>(o.extra(i, "timeStamp")), static_cast<double>(i) * 1000003);
  }
}

TEST(E57, ChecksumIsCastagnoli) {
  EXPECT_EQ(e57::crc32c(std::as_bytes(std::span("123456789", 9))), 0xE3069283u);
  EXPECT_EQ(e57::crc32c({}), 0u);
}

TEST(E57, ScansFollowEachOtherAndCarryTheirNumber) {
  const Folder folder;
  E57Writer writer;
  writer.add(small_scan("one", 1));
  writer.add(small_scan("two", 100));
  const OpenedE57 o = open_bytes(folder, writer.finish(), 1);
  EXPECT_EQ(o.reader->info().format, "e57");
  EXPECT_EQ(o.reader->info().points, 4u);
  ASSERT_EQ(o.reader->info().scans.size(), 2u);
  EXPECT_EQ(o.reader->info().scans[1].name, "two");
  EXPECT_EQ(o.reader->info().scans[1].points, 2u);
  EXPECT_TRUE(o.reader->info().stations.empty()) << "no pose: nobody says where the scanner stood";
  EXPECT_NEAR(o.point(1).y, 20, 1e-9);
  EXPECT_NEAR(o.point(3).x, 101, 1e-9);
  EXPECT_EQ(o.fields(1).source_id, 1);
  EXPECT_EQ(o.fields(2).source_id, 2);
  EXPECT_EQ(read_all(*o.reader, 3).bytes, o.rows.bytes) << "a second reading gives the same";
}

TEST(E57, PosesTurnAndMovePointsAndNormals) {
  const Folder folder;
  E57Scan scan{
      "s",
      e57_pose("0.70710678118654752", "0", "0", "0.70710678118654752", "1000", "2000", "50"),
      {double_field("cartesianX", {1, 0}), double_field("cartesianY", {0, 1}), double_field("cartesianZ", {0, 5}),
       single_field("nor:normalX", {1, 0}), single_field("nor:normalY", {0, 1}), single_field("nor:normalZ", {0, 0})}};
  E57Writer writer;
  writer.add(scan);
  const OpenedE57 o = open_bytes(folder, writer.finish());
  EXPECT_NEAR(o.point(0).x, 1000, 1e-9) << "a quarter turn to the left about z";
  EXPECT_NEAR(o.point(0).y, 2001, 1e-9);
  EXPECT_NEAR(o.point(1).x, 999, 1e-9);
  EXPECT_NEAR(o.point(1).z, 55, 1e-9);
  EXPECT_NEAR(load<float>(o.extra(0, "NormalY")), 1, 1e-6);
  EXPECT_NEAR(load<float>(o.extra(1, "NormalX")), -1, 1e-6);
  ASSERT_EQ(o.reader->info().stations.size(), 1u);
  EXPECT_EQ(o.reader->info().stations[0].name, "s");
  EXPECT_EQ(o.reader->info().stations[0].source_id, 1);
  EXPECT_EQ(o.reader->info().stations[0].position.y, 2000);
  EXPECT_TRUE(o.reader->info().warnings.empty());
}

// A wall at x = 10 m in steps of 2 mrad about the scanner's axis and 1 mrad along it, by a scanner that lies on its
// side.
std::string scanned_wall(bool with_grid) {
  std::vector<double> x, y, z;
  std::vector<std::int64_t> row, column;
  for (int c = 0; c < 40; ++c)
    for (int r = 0; r < 60; ++r) {
      const double a = 0.002 * c - 0.03, e = 0.001 * r - 0.02;
      if ((c * 7 + r) % 9 == 0) continue;
      x.push_back(10);
      y.push_back(10 * std::tan(a));
      z.push_back(10 / std::cos(a) * std::tan(e));
      row.push_back(r);
      column.push_back(c);
    }
  E57Scan scan{"s",
               e57_pose("0.70710678118654752", "0.70710678118654752", "0", "0", "5", "6", "7"),
               {double_field("cartesianX", x), double_field("cartesianY", y), double_field("cartesianZ", z)}};
  if (with_grid) {
    scan.fields.push_back(integer_field("rowIndex", 0, 59, row));
    scan.fields.push_back(integer_field("columnIndex", 0, 39, column));
  }
  E57Writer writer;
  writer.add(scan);
  return writer.finish();
}

TEST(E57, RowsAndColumnsOrTheOrderOfPointsGiveTheAngularSteps) {
  for (const bool with_grid : {true, false}) {
    SCOPED_TRACE(with_grid);
    const Folder folder;
    const OpenedE57 o = open_bytes(folder, scanned_wall(with_grid));
    ASSERT_EQ(o.reader->info().stations.size(), 1u);
    const Station& s = o.reader->info().stations[0];
    EXPECT_NEAR(s.azimuth_step, 0.002, 2e-5);
    EXPECT_NEAR(s.elevation_step, 0.001, 1e-5);
    EXPECT_NEAR(s.axis.y, -1, 1e-12);
    EXPECT_NEAR(s.axis.z, 0, 1e-12);
    EXPECT_EQ(s.position.x, 5);
  }
}

TEST(E57, SphericalCoordinatesBecomeCartesian) {
  const Folder folder;
  const std::vector<double> range{10, 20, 5, 1}, azimuth{0, 0.7, -2.5, NAN}, elevation{0, 0.3, -1.1, 0};
  E57Scan scan{
      "s",
      "",
      {double_field("sphericalRange", range), double_field("sphericalAzimuth", azimuth),
       double_field("sphericalElevation", elevation), integer_field("sphericalInvalidState", 0, 2, {0, 0, 0, 0})}};
  E57Writer writer;
  writer.add(scan);
  const OpenedE57 o = open_bytes(folder, writer.finish());
  for (std::size_t i = 0; i < 3; ++i) {
    EXPECT_NEAR(o.point(i).x, range[i] * std::cos(elevation[i]) * std::cos(azimuth[i]), 5.1e-5);
    EXPECT_NEAR(o.point(i).y, range[i] * std::cos(elevation[i]) * std::sin(azimuth[i]), 5.1e-5);
    EXPECT_NEAR(o.point(i).z, range[i] * std::sin(elevation[i]), 5.1e-5);
  }
  EXPECT_EQ(o.rows.valid[3], 0);
  EXPECT_EQ(o.reader->info().stations.size(), 1u);
}

TEST(E57, PackedIntegersContinueOverPacketsWhateverTheirCut) {
  const Folder folder;
  constexpr std::size_t kPoints = 5000;
  for (const std::size_t piece : {std::size_t{3}, std::size_t{600}, std::size_t{8000}}) {
    for (const bool uneven : {false, true}) {
      E57Scan scan = large_scan(kPoints);
      scan.piece = piece;
      scan.uneven = scan.other_packets = uneven;
      E57Writer writer(uneven ? 512 : 1024);
      writer.add(scan);
      expect_large(open_bytes(folder, writer.finish()), scan, kPoints);
    }
  }
}

TEST(E57, LimitsStretchIntensityAndColourToSixteenBits) {
  const Folder folder;
  E57Scan scan = small_scan("s", 1);
  scan.xml =
      "<intensityLimits type=\"Structure\"><intensityMinimum type=\"Float\">-10</intensityMinimum>"
      "<intensityMaximum type=\"Float\">30</intensityMaximum></intensityLimits>"
      "<colorLimits type=\"Structure\"><colorRedMinimum type=\"Integer\"/>"
      "<colorRedMaximum type=\"Integer\">1023</colorRedMaximum></colorLimits>";
  scan.fields.push_back(single_field("intensity", {0, 99}));
  scan.fields.push_back(integer_field("colorRed", 0, 4095, {1023, 0}));
  scan.fields.push_back(integer_field("colorGreen", 0, 255, {255, 1}));
  scan.fields.push_back(integer_field("colorBlue", 0, 255, {128, 0}));
  scan.fields.push_back(integer_field("isColorInvalid", 0, 1, {0, 1}));
  scan.fields.push_back(integer_field("returnIndex", 0, 3, {0, 2}));
  scan.fields.push_back(integer_field("returnCount", 0, 3, {1, 3}));
  scan.fields.push_back(integer_field("rowIndex", 0, 100000, {7, 99999}));
  scan.fields.push_back({"myNote", "type=\"String\"", 8, {5, 9}});
  E57Writer writer;
  writer.add(scan);
  writer.add(small_scan("without colour", 50));
  const OpenedE57 o = open_bytes(folder, writer.finish());
  EXPECT_EQ(o.fields(0).intensity, 16384);
  EXPECT_EQ(o.fields(1).intensity, 65535);
  EXPECT_EQ(o.colour(0), (std::array<int, 3>{65535, 65535, 128 * 257}));
  EXPECT_EQ(o.colour(1), (std::array<int, 3>{0, 0, 0}));
  EXPECT_EQ(o.fields(1).return_number, 3);
  EXPECT_EQ(o.fields(1).return_count, 3);
  EXPECT_EQ(load<std::int32_t>(o.extra(1, "rowIndex")), 99999);
  EXPECT_EQ(o.colour(2), (std::array<int, 3>{0, 0, 0}));
  EXPECT_TRUE(mentions(o.reader->info().warnings, "not kept: myNote"));
}

TEST(E57, CoordinateMetadataNamesTheCrs) {
  const Folder folder;
  E57Writer writer;
  writer.add(small_scan("s", 1));
  const std::string text = writer.finish("<coordinateMetadata type=\"String\">EPSG:2154</coordinateMetadata>");
  EXPECT_EQ(open_bytes(folder, text).reader->info().crs.epsg, 2154);
}

TEST(E57, DamagedPagesEndTheirScanOnly) {
  const Folder folder;
  E57Writer writer;
  const E57Scan scan = large_scan(5000);
  writer.add(scan);
  writer.add(small_scan("after", 4));
  std::string bytes = writer.finish();
  const std::string sound = bytes;
  bytes[40 * 1024 + 100] = static_cast<char>(bytes[40 * 1024 + 100] ^ 1);
  const OpenedE57 o = open_bytes(folder, bytes);
  const CloudInfo& info = o.reader->info();
  EXPECT_EQ(info.declared_points, 5002u);
  EXPECT_GT(info.points, 500u);
  EXPECT_LT(info.points, 5000u);
  ASSERT_EQ(o.rows.valid.size(), info.points);
  EXPECT_TRUE(mentions(info.warnings, "the page at byte 40960 is damaged"));
  EXPECT_EQ(o.fields(o.rows.valid.size() - 1).source_id, 2);
  const OpenedE57 whole = open_bytes(folder, sound);
  const std::size_t kept = (info.points - 2) * info.layout.record_length;
  const auto end = o.rows.bytes.begin() + static_cast<std::ptrdiff_t>(kept);
  EXPECT_TRUE(std::equal(o.rows.bytes.begin(), end, whole.rows.bytes.begin()));
}

TEST(E57, RefusesWithASentence) {
  const Folder folder;
  E57Writer writer;
  writer.add(small_scan("s", 1));
  const std::string sound = writer.finish();
  EXPECT_NE(message_of(folder, sound.substr(0, 40)).find("no ASTM-E57"), std::string::npos);
  EXPECT_NE(message_of(folder, sound.substr(0, 1000)).find("cut off"), std::string::npos);
  std::string xml_hit = sound;
  xml_hit[900] = 'x';
  EXPECT_NE(message_of(folder, xml_hit).find("checksum of the page at byte 0"), std::string::npos);
  std::string page_size = sound;
  page_size[41] = 5;
  EXPECT_NE(message_of(folder, E57Writer::resealed(page_size)).find("page size"), std::string::npos);
  E57Writer empty;
  EXPECT_NE(message_of(folder, empty.finish()).find("contains no scans"), std::string::npos);
  E57Scan flat = small_scan("flat", 1);
  flat.fields.pop_back();
  E57Writer unusable;
  unusable.add(flat);
  EXPECT_NE(message_of(folder, unusable.finish()).find("neither cartesianX"), std::string::npos);
}

TEST(E57, AFileWithoutPointsNeedsTheSectionOfNone) {
  const Folder folder;
  E57Scan none = small_scan("none", 1);
  for (E57Field& field : none.fields) field.stored.clear();
  E57Writer sound;
  sound.add(none);
  const std::string bytes = sound.finish();
  EXPECT_EQ(open_bytes(folder, bytes).reader->info().points, 0u);
  constexpr std::size_t kSection = 48;  // behind the header
  std::string headless = bytes;
  headless[kSection] = '\0';
  EXPECT_NE(message_of(folder, E57Writer::resealed(headless)).find("contains no points"), std::string::npos);

  E57Writer beside;
  beside.add(none);
  beside.add(small_scan("s", 1));
  headless = beside.finish();
  headless[kSection] = '\0';
  const OpenedE57 o = open_bytes(folder, E57Writer::resealed(headless));
  EXPECT_EQ(o.reader->info().points, 2u);
  EXPECT_TRUE(o.reader->info().warnings.empty());
}

TEST(E57, LyingCountsAndOverlapsAreBounded) {
  const Folder folder;
  E57Writer writer;
  E57Scan scan = small_scan("s", 1);
  scan.records = 1'000'000'000'000;
  writer.add(scan);
  EXPECT_EQ(open_bytes(folder, writer.finish()).reader->info().points, 2u);
  E57Writer overlapping;
  overlapping.add(large_scan(5000));
  for (int i = 0; i < 1000; ++i) overlapping.claim_again();
  const OpenedE57 o = open_bytes(folder, overlapping.finish());
  EXPECT_EQ(o.reader->info().declared_points, 5000u * 1001);
  EXPECT_LT(o.rows.valid.size(), 5000u * 1001 / 20) << "as much as the file could hold, not as it claims";
  EXPECT_TRUE(mentions(o.reader->info().warnings, "where those of other scans do"));
  E57Scan constant{"c",
                   "",
                   {integer_field("cartesianX", 4, 4, {4, 4}), integer_field("cartesianY", 4, 4, {4, 4}),
                    integer_field("cartesianZ", 4, 4, {4, 4})}};
  E57Writer few;
  few.add(constant);
  EXPECT_EQ(open_bytes(folder, few.finish()).rows.valid.size(), 2u);
  constant.records = 1'000'000'000'000;
  E57Writer many;
  many.add(constant);
  EXPECT_NE(message_of(folder, many.finish()).find("the same"), std::string::npos);
}

// Every byte changed with right checksums, so that nothing but the parsers stands in the way; and without.
TEST(E57, MutationsNeverCrash) {
  const Folder folder;
  E57Scan scan = large_scan(60);
  scan.piece = 40;
  scan.uneven = scan.other_packets = true;
  scan.xml = e57_pose("1", "0", "0", "0", "5", "6", "7");
  E57Writer writer(256);
  writer.add(scan);
  const std::string sound = writer.finish();
  Rng rng(11);
  std::size_t read = 0, refused = 0;
  for (std::size_t round = 0; round < 1500; ++round) {
    std::string bytes = sound;
    const std::size_t changes = 1 + rng.below(3);
    const bool front = rng.below(2) == 0;
    for (std::size_t c = 0; c < changes; ++c)
      bytes[rng.below(front ? 1500 : static_cast<std::uint32_t>(bytes.size()))] = static_cast<char>(rng.below(256));
    if (rng.below(8) == 0) bytes.resize(rng.below(static_cast<std::uint32_t>(bytes.size())));
    if (rng.below(8) != 0) bytes = E57Writer::resealed(bytes, 256);
    try {
      const OpenedE57 o = open_bytes(folder, bytes);
      ASSERT_EQ(o.rows.valid.size(), o.reader->info().points);
      ASSERT_LE(o.rows.valid.size(), bytes.size() * 8);
      ++read;
    } catch (const Error& error) {
      ASSERT_EQ(std::string(error.what()).rfind((folder / "t.").string(), 0), 0u) << error.what();
      ++refused;
    }
  }
  EXPECT_GT(read, 100u);
  EXPECT_GT(refused, 100u);
}

TEST(E57, RealFiles) {
  ILOT_DATA_OR_SKIP(data);
  const std::filesystem::path folder = data / "conformance/pdal/e57";
  struct Known {
    const char* name;
    std::size_t points, scans;
    Vec3 min, max;
  };
  const Known all[] = {{"A4.e57", 4, 1, {-44.9522, -1.3493, -0.6077}, {-44.3001, -0.8860, 0.3694}},
                       {"A4_moved.e57", 4, 1, {-44.1194, 0.7053, -0.6077}, {-43.4673, 1.1686, 0.3694}},
                       {"B2.e57", 2, 1, {-42.6423, 1.8726, 0.5101}, {-42.6395, 2.0578, 0.6667}},
                       {"A_B.e57", 6, 2, {-44.9522, -1.3493, -0.6077}, {-42.6395, 2.0578, 0.6667}},
                       {"A_moved_B.e57", 6, 2, {-44.1194, 0.7053, -0.6077}, {-42.6395, 2.0578, 0.6667}},
                       {"A_merged_B.e57", 6, 1, {-44.9522, -1.3493, -0.6077}, {-42.6395, 2.0578, 0.6667}},
                       {"A_B_different_dims.e57", 2, 2, {83.1978, 537.2703, 4.5903}, {84.1740, 538.4684, 4.6287}}};
  for (const Known& known : all) {
    OpenedE57 o{open_cloud(folder / known.name), {}};
    o.rows = read_all(*o.reader);
    ASSERT_EQ(o.rows.valid.size(), known.points) << known.name;
    EXPECT_EQ(o.reader->info().scans.size(), known.scans) << known.name;
    Vec3 low{1e9, 1e9, 1e9}, high{-1e9, -1e9, -1e9};
    for (std::size_t i = 0; i < known.points; ++i) {
      ASSERT_EQ(o.rows.valid[i], 1);
      const Vec3 p = o.point(i);
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    EXPECT_LT(norm(low - known.min), 2e-4) << known.name;
    EXPECT_LT(norm(high - known.max), 2e-4) << known.name;
  }
}

}  // namespace
}  // namespace ilot
