// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/laz/laz_extender.h"

#include <gtest/gtest.h>

#include "engine/formats/laz/chunk_extender.h"
#include "tests/engine/formats/laz/laz_fixtures.h"

namespace ilot {
namespace {

using test::Folder;
using test::PointMaker;
using test::read_all;
using test::slurp;

std::vector<std::byte> encoded(const laz::ChunkLayout& layout, std::span<const std::byte> records) {
  std::vector<std::byte> out;
  laz::ChunkEncoder(layout).encode(records, out);
  return out;
}

// The rows cut at a byte: [0] what stands before it, [1] what stands behind.
std::array<std::vector<std::byte>, 2> cut_rows(std::span<const std::byte> records, std::size_t length, std::size_t at) {
  std::array<std::vector<std::byte>, 2> parts;
  for (std::size_t i = 0; i < records.size(); ++i) parts[i % length < at ? 0 : 1].push_back(records[i]);
  return parts;
}

// Formats with colours, near infrared and waveforms, several scanner channels, extra bytes before ours or none; bytes
// that never change, too, which have no stream.
TEST(LazExtender, ChunksAreThoseOfTheLongerRecords) {
  std::uint64_t key = 1;
  for (std::uint8_t format = 6; format <= 10; ++format) {
    for (const std::uint8_t version : {3, 4}) {
      for (const std::uint16_t extra : {0, 3}) {
        for (const std::size_t count : {1, 2, 3, 100, 3000}) {
          SCOPED_TRACE(testing::Message() << int(format) << " v" << int(version) << " +" << extra << " n " << count);
          const auto length = static_cast<std::uint16_t>(standard_size(format) + extra);
          const laz::ChunkLayout before{format, length, version};
          const laz::ChunkLayout after{format, static_cast<std::uint16_t>(length + 5), version};
          std::vector<std::byte> records = PointMaker(after, ++key).make(count);
          for (std::size_t i = 0; i < count; ++i) records[i * after.record_length + length + 2] = std::byte{7};
          const auto [rows, appended] = cut_rows(records, after.record_length, length);
          std::vector<std::byte> extended;
          ASSERT_TRUE(laz::extend_chunk(before, encoded(before, rows), rows, appended, extended));
          EXPECT_TRUE(extended == encoded(after, records));
        }
      }
    }
  }
}

TEST(LazExtender, ChunksOfOtherRowsAreRefused) {
  const laz::ChunkLayout layout{6, 30, 3}, pointwise{0, 20, 2};
  const auto rows = PointMaker(layout, 3).make(10);
  const std::vector<std::byte> appended(9);
  std::vector<std::byte> chunk = encoded(layout, rows), out;
  EXPECT_FALSE(laz::extend_chunk(layout, chunk, std::span(rows).first(9 * 30), appended, out));
  chunk.resize(chunk.size() - 1);
  EXPECT_FALSE(laz::extend_chunk(layout, chunk, rows, std::vector<std::byte>(10), out));
  const auto old_rows = PointMaker(pointwise, 3).make(10);
  EXPECT_FALSE(laz::extend_chunk(pointwise, encoded(pointwise, old_rows), old_rows, std::vector<std::byte>(10), out));
  EXPECT_TRUE(out.empty());
}

CloudSpec spec_of(const CloudInfo& like) {
  CloudSpec spec;
  spec.like = like;
  spec.software = "test";
  spec.appended = {{"ours", "", FieldType::u32}, {"more", "", FieldType::u8}};
  return spec;
}

// What stands behind row i.
std::array<std::byte, 5> ours(std::size_t i) {
  std::array<std::byte, 5> bytes{};
  for (std::size_t b = 0; b < bytes.size(); ++b) bytes[b] = static_cast<std::byte>((i * 2654435761u) >> (7 * b));
  return bytes;
}

void extend_file(PointReader& input, const std::filesystem::path& path) {
  const auto extender = LazExtender::open(input, path, spec_of(input.info()));
  ASSERT_NE(extender, nullptr);
  ASSERT_EQ(extender->appended_length(), 5u);
  input.limit_to(kFieldZ);
  const std::vector<std::uint64_t> bounds = input.boundaries();
  for (std::size_t chunk = 0; chunk + 1 < bounds.size(); ++chunk) {
    const std::uint64_t first = bounds[chunk], count = bounds[chunk + 1] - first;
    std::vector<std::byte> rows(count * input.info().layout.record_length), appended;
    std::vector<std::uint8_t> valid(count);
    ASSERT_EQ(input.read(first, rows, valid), count);
    for (std::size_t i = 0; i < count; ++i)
      for (const std::byte b : ours(first + i)) appended.push_back(b);
    extender->append(extender->extend(chunk, rows, appended));
  }
  input.limit_to(kAllFields);
  extender->finish();
}

std::vector<std::byte> joined_rows(const std::vector<std::byte>& rows, std::size_t length) {
  std::vector<std::byte> out;
  for (std::size_t i = 0; i < rows.size() / length; ++i) {
    const auto row = rows.begin() + static_cast<std::ptrdiff_t>(i * length);
    out.insert(out.end(), row, row + static_cast<std::ptrdiff_t>(length));
    for (const std::byte b : ours(i)) out.push_back(b);
  }
  return out;
}

// The whole file, header and table included, is what coding everything gives.
TEST(LazExtender, FilesAreThoseOfTheWriter) {
  const Folder folder;
  for (const std::uint8_t format : {6, 7, 10}) {
    SCOPED_TRACE(int(format));
    CloudSpec spec;
    spec.like.layout.point_format = format;
    spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(format));
    const auto rows = PointMaker({format, spec.like.layout.record_length, 3}, 8).make(2500);
    const auto first = create_laz(folder / "in.laz", spec, {1000});
    first->write(rows);
    first->finish();
    const auto input = open_cloud(folder / "in.laz");
    extend_file(*input, folder / "out.laz");
    const auto writer = create_laz(folder / "wanted.laz", spec_of(input->info()), {1000});
    writer->write(joined_rows(rows, spec.like.layout.record_length));
    writer->finish();
    EXPECT_TRUE(slurp(folder / "out.laz") == slurp(folder / "wanted.laz"));
  }
}

// Chunks of their own sizes, as in COPC files, stay as they are.
TEST(LazExtender, RealFiles) {
  ILOT_DATA_OR_SKIP(data);
  const Folder folder;
  for (const char* name : {"ign/77050_627755_pf8.laz", "ign/77050_627755.copc.laz"}) {
    SCOPED_TRACE(name);
    const auto input = open_cloud(data / name);
    extend_file(*input, folder / "out.laz");
    const auto output = open_cloud(folder / "out.laz");
    EXPECT_TRUE(output->info().warnings.empty());
    EXPECT_EQ(output->boundaries(), input->boundaries());
    const auto rows = read_all(*input, 50000).bytes;
    EXPECT_TRUE(read_all(*output, 50000).bytes == joined_rows(rows, input->info().layout.record_length));
  }
}

TEST(LazExtender, OthersAreLeftToTheWriter) {
  const Folder folder;
  const auto is_extended = [&](const char* name) {
    const auto input = open_cloud(folder / name);
    return LazExtender::open(*input, folder / "out.laz", spec_of(input->info())) != nullptr;
  };
  for (const std::uint8_t format : {1, 6}) {
    const std::uint8_t version = format < 6 ? 2 : 3;
    CloudSpec spec;
    spec.like.layout.point_format = format;
    spec.like.layout.record_length = static_cast<std::uint16_t>(standard_size(format));
    const auto rows = PointMaker({format, spec.like.layout.record_length, version}, 8).make(150'000);
    for (const char* name : {"a.las", "a.laz"}) {
      const auto writer = create_cloud(folder / name, spec);
      writer->write(rows);
      writer->finish();
      EXPECT_EQ(is_extended(name), format == 6 && std::string(name) == "a.laz") << int(format) << name;
    }
  }
  auto bytes = slurp(folder / "a.laz");
  bytes.resize(bytes.size() * 2 / 3);  // its first chunks are whole
  test::spill(folder / "a.laz", bytes);
  EXPECT_FALSE(is_extended("a.laz"));
}

}  // namespace
}  // namespace ilot
