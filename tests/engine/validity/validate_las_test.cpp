// SPDX-License-Identifier: Apache-2.0
#include "engine/validity/validate_las.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <set>

#include "engine/formats/las/extra_bytes.h"
#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

// A valid file by our own writer, to be damaged: three points of two pulses, far from the origin.
class ValidateLas : public ::testing::Test {
 protected:
  void write(std::uint8_t format, std::vector<ExtraField> extra = {}) {
    CloudSpec spec;
    spec.like.layout.point_format = format;
    spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(format));
    spec.like.layout.scale = {0.001, 0.01, 0.001};
    spec.like.layout.offset = {870000.123, 6618000, 0};
    if (format >= 6) spec.like.crs = crs_of_file();
    spec.appended = std::move(extra);
    const auto writer = create_cloud(path(), spec);
    std::vector<std::byte> rows(3 * writer->record_length());
    for (std::size_t i = 0; i < 3; ++i) {
      PointFields fields;
      fields.x = static_cast<int>(1000 * i) - 7, fields.y = 31, fields.z = 5 - static_cast<int>(i);
      fields.return_number = i == 2 ? 2 : 1, fields.return_count = i == 0 ? 1 : 2;
      encode_fields(fields, std::span(rows).subspan(i * writer->record_length(), writer->record_length()), format);
    }
    writer->write(rows);
    writer->finish();
    bytes_ = slurp(path());
    points_ = load<std::uint32_t>(&bytes_[las::kPointOffset]);
    length_ = writer->record_length();
  }

  static Crs crs_of_file() {
    Crs crs;
    crs.wkt = "LOCAL_CS[\"yard\",UNIT[\"metre\",1]]";
    return crs;
  }

  std::filesystem::path path() const { return folder_ / "cloud.las"; }

  // Rules broken, severe ones with a "!" before.
  std::set<std::string> rules() {
    spill(path(), bytes_);
    const auto reader = open_cloud(path());
    std::set<std::string> result;
    for (const Finding& f : validate_las(*reader)) result.insert((f.severe ? "!" : "") + f.rule);
    result.erase("reader");
    return result;
  }

  template <class T>
  std::set<std::string> rules_with(std::size_t place, T value) {
    const std::vector<std::byte> kept = bytes_;
    store(&bytes_[place], value);
    auto result = rules();
    bytes_ = kept;
    return result;
  }

  using Rules = std::set<std::string>;
  Folder folder_;
  std::vector<std::byte> bytes_;
  std::size_t points_ = 0, length_ = 0;
};

TEST_F(ValidateLas, WhatWeWriteIsValid) {
  for (const std::uint8_t format : {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10}) {
    write(format);
    EXPECT_EQ(rules(), Rules{}) << "point format " << int{format};
  }
}

TEST_F(ValidateLas, BoxWithinHalfAStep) {
  write(3);
  const auto max_x = load<double>(&bytes_[las::kBounds]);
  EXPECT_EQ(rules_with(las::kBounds, max_x + 0.00049), Rules{});
  EXPECT_EQ(rules_with(las::kBounds, max_x + 0.00051), Rules{"!box"});
  EXPECT_EQ(rules_with(las::kBounds, max_x - 0.00051), Rules{"!box"});
  EXPECT_EQ(rules_with(las::kBounds + 24, load<double>(&bytes_[las::kBounds + 24]) + 0.0049), Rules{})
      << "y has steps of a centimetre";
  EXPECT_EQ(rules_with(las::kBounds, std::numeric_limits<double>::quiet_NaN()), (Rules{"!box", "!box-range"}));
  EXPECT_EQ(rules_with(las::kBounds, 1e300), (Rules{"!box", "!box-range"}));
}

TEST_F(ValidateLas, BoxAllZero) {
  write(6);
  std::fill_n(&bytes_[las::kBounds], 48, std::byte{0});
  EXPECT_EQ(rules(), Rules{"!box"});
  const auto reader = open_cloud(path());
  EXPECT_NE(validate_las(*reader).front().text.find("all zero"), std::string::npos);
}

TEST_F(ValidateLas, Counts) {
  write(1);
  EXPECT_EQ(rules_with(las::kCount, std::uint64_t{2}), (Rules{"!legacy-count", "!returns-count", "!box"}))
      << "what is read ends where the header says";
  EXPECT_EQ(rules_with(las::kCount, std::uint64_t{1} << 60), Rules{"!point-count"});
  EXPECT_EQ(rules_with(las::kLegacyCount, 4u), Rules{"!legacy-count"});
  EXPECT_EQ(rules_with(las::kReturns, std::uint64_t{9}), Rules{"!returns-count"});
  EXPECT_EQ(rules_with(las::kLegacyReturns + 4, 9u), Rules{"!returns-count"});
  bytes_.resize(bytes_.size() - 1);
  EXPECT_TRUE(rules().count("!point-count"));
  write(6);
  EXPECT_EQ(rules_with(las::kLegacyCount, 3u), (Rules{"legacy-count", "!returns-count"}));
  EXPECT_EQ(rules_with(las::kLegacyCount, 5u), (Rules{"!legacy-count", "!returns-count"}));
}

TEST_F(ValidateLas, PointsThatContradictThemselves) {
  write(1);
  const std::size_t second = points_ + length_;
  EXPECT_EQ(rules_with(second + 14, std::uint8_t{0b00'001'001}), Rules{}) << "one of one";
  EXPECT_EQ(rules_with(second + 14, std::uint8_t{0b00'000'001}), Rules{"!return-number"}) << "one of none";
  EXPECT_EQ(rules_with(second + 14, std::uint8_t{0}), (Rules{"return-number", "!returns-count"}));
  EXPECT_EQ(rules_with(second + 20, std::numeric_limits<double>::infinity()), Rules{"!gps-time"});
  EXPECT_EQ(rules_with(second + 20, -std::numeric_limits<double>::quiet_NaN()), Rules{"!gps-time"});
}

TEST_F(ValidateLas, WktFlag) {
  write(7);
  EXPECT_EQ(rules_with(las::kGlobalEncoding, std::uint16_t{1}), Rules{"!wkt-flag"});
  EXPECT_EQ(rules_with(las::kGlobalEncoding, std::uint16_t{17}), Rules{});
  bytes_[las::header_size(4) + 18] ^= std::byte{1};  // no longer a record of a CRS
  EXPECT_EQ(rules_with(las::kGlobalEncoding, std::uint16_t{1}), Rules{"wkt-flag"});
}

TEST_F(ValidateLas, VersionHeaderAndRecords) {
  write(6);
  EXPECT_TRUE(rules_with(las::kMinor, std::uint8_t{2}).count("!version"));
  EXPECT_EQ(rules_with(las::kVlrCount, 40u), Rules{"!vlr-count"});
  ExtraField field;
  field.name = "height";
  field.type = FieldType::f32;
  write(3, {field});
  EXPECT_EQ(rules(), Rules{});
  const std::size_t type = las::header_size(4) + las::kVlrHeader + 2;
  EXPECT_EQ(rules_with(type, std::uint8_t{10}), Rules{"!extra-bytes"}) << "eight bytes do not fit";
  EXPECT_EQ(rules_with(type, std::uint8_t{1}), Rules{"extra-bytes"}) << "three bytes of four untold";
}

TEST_F(ValidateLas, EmptyCloudsAndOtherFormats) {
  CloudSpec spec;
  create_cloud(path(), spec)->finish();
  bytes_ = slurp(path());
  EXPECT_EQ(rules(), Rules{});
  spill_text(folder_ / "a.xyz", "1 2 3\n");
  const auto reader = open_cloud(folder_ / "a.xyz");
  try {
    validate_las(*reader);
    FAIL();
  } catch (const Error& fault) {
    EXPECT_EQ(fault.code(), ExitCode::usage);
  }
}

// Whatever stands in the header: a list of findings or one Error, never more findings than rules and warnings.
TEST_F(ValidateLas, AnyByteOfTheHeader) {
  write(8);
  const std::vector<std::byte> good = bytes_;
  for (std::size_t at = 0; at < las::header_size(4); ++at) {
    for (const unsigned bit : {1u, 0x40u, 0x80u}) {
      bytes_ = good;
      bytes_[at] ^= static_cast<std::byte>(bit);
      spill(path(), bytes_);
      try {
        const auto reader = open_cloud(path());
        EXPECT_LE(validate_las(*reader).size(), 14 + reader->info().warnings.size());
      } catch (const Error&) {
      }
    }
  }
}

std::set<std::string> severe_rules_of(const std::filesystem::path& path) {
  const auto reader = open_cloud(path);
  std::set<std::string> rules;
  for (const Finding& finding : validate_las(*reader)) {
    if (finding.severe) rules.insert(finding.rule);
  }
  return rules;
}

TEST(ValidateRealLas, KnownLies) {
  ILOT_DATA_OR_SKIP(data);
  EXPECT_TRUE(severe_rules_of(data / "minimalhouse/minimal_house_12.laz").count("box"));
  EXPECT_TRUE(severe_rules_of(data / "minimalhouse/minimal_house_13.laz").count("box"));
  EXPECT_TRUE(severe_rules_of(data / "conformance/pdal/las/gps-time-nan.las").count("gps-time"));
  EXPECT_TRUE(severe_rules_of(data / "conformance/pdal/las/bad_vlr_count.las").count("vlr-count"));
}

TEST(ValidateRealLas, ConformanceFilesAreJudgedOrRefused) {
  ILOT_DATA_OR_SKIP(data);
  std::size_t judged = 0, valid = 0;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(data / "conformance")) {
    const auto extension = entry.path().extension();
    if (extension != ".las" && extension != ".laz") continue;
    try {
      valid += severe_rules_of(entry.path()).empty();
      ++judged;
    } catch (const Error&) {
    }
  }
  EXPECT_GT(judged, 60u);
  EXPECT_GT(valid, 20u);
}

}  // namespace
}  // namespace ilot
