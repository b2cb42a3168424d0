// SPDX-License-Identifier: Apache-2.0
#include "engine/store/column_file.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/error.h"
#include "tests/support/file_bytes.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

// What opening the file says; empty: it opens.
template <class T>
std::string error_of(const fs::path& path) {
  try {
    const ColumnReader<T> reader(path);
    return "";
  } catch (const Error& e) {
    return e.what();
  }
}

TEST(ColumnFile, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  std::vector<std::uint32_t> values(100000);
  std::iota(values.begin(), values.end(), 5u);
  write_column<std::uint32_t>(folder.path() / "c", values);
  EXPECT_EQ(read_column<std::uint32_t>(folder.path() / "c"), values);
  std::vector<std::uint32_t> part(3);
  const ColumnReader<std::uint32_t> reader(folder.path() / "c");
  EXPECT_EQ(reader.size(), 100000u);
  EXPECT_EQ(reader.at(1), 6u);
  reader.read(99997, part);
  EXPECT_EQ(part, (std::vector<std::uint32_t>{100002, 100003, 100004}));
  reader.read(100000, std::span<std::uint32_t>());
}

TEST(ColumnFile, NothingAppearsBeforeCommitAndNothingStaysWithoutIt) {
  const TemporaryFolder folder;
  const std::uint64_t value = 7;
  {
    ColumnWriter<std::uint64_t> writer(folder.path() / "c");
    writer.append(std::span(&value, 1));
    EXPECT_FALSE(fs::exists(folder.path() / "c"));
  }
  EXPECT_EQ(entries(folder.path()), 0);
  ColumnWriter<std::uint64_t> writer(folder.path() / "c");
  writer.append(std::span(&value, 1));
  writer.commit();
  EXPECT_EQ(read_column<std::uint64_t>(folder.path() / "c"), std::vector<std::uint64_t>{7});
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(ColumnFile, AnOlderFileStaysWholeUntilTheNewOneIs) {
  const TemporaryFolder folder;
  const auto path = folder.put("c", "old");
  ColumnWriter<char> writer(path);
  writer.append(std::span("newer", 5));
  EXPECT_EQ(fs::file_size(path), 3u);
  writer.commit();
  EXPECT_EQ(fs::file_size(path), sizeof(ColumnHeader) + 5u);
}

TEST(ColumnFile, AFailedCommitLeavesNothingBehind) {
  const TemporaryFolder folder;
  folder.put("c/inside", "a folder that is not empty cannot be replaced");
  {
    ColumnWriter<char> writer(folder.path() / "c");
    EXPECT_THROW(writer.commit(), Error);
  }
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(ColumnFile, ShortAndMissingFilesAreErrorsThatNameThem) {
  const TemporaryFolder folder;
  const auto path = folder.put("short", "1234567");
  EXPECT_NE(error_of<std::uint32_t>(path).find(path.string()), std::string::npos);
  EXPECT_THROW(ColumnReader<char>(folder.path() / "none"), Error);
  EXPECT_THROW(ColumnWriter<char>(folder.path() / "none" / "c"), Error);
  EXPECT_THROW(read_column<std::uint32_t>(folder.path()), Error);
}

TEST(ColumnFile, AReaderMoves) {
  const TemporaryFolder folder;
  const char value = 'x';
  write_column<char>(folder.path() / "c", std::span(&value, 1));
  ColumnReader<char> a(folder.path() / "c");
  const ColumnReader<char> b(std::move(a));
  EXPECT_EQ(b.size(), 1u);
  EXPECT_EQ(b.at(0), 'x');
}

enum class Small : std::uint8_t { one = 1 };
struct Pair {
  std::uint16_t a = 0, b = 0;
};

TEST(ColumnFile, ValuesOfAnotherTypeAreRefused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "c";
  write_column<std::uint32_t>(path, std::vector<std::uint32_t>{1, 2, 3});
  EXPECT_NE(error_of<std::uint64_t>(path).find("has unsigned whole numbers of 4 bytes where"), std::string::npos);
  EXPECT_NE(error_of<std::int32_t>(path).find("whole numbers of 4 bytes were expected"), std::string::npos);
  EXPECT_NE(error_of<float>(path).find("real numbers of 4 bytes were expected"), std::string::npos);
  EXPECT_NE(error_of<Pair>(path).find("records of 4 bytes were expected"), std::string::npos);
  EXPECT_NE(error_of<std::byte>(path).find("bytes of 1 bytes were expected"), std::string::npos);
  EXPECT_EQ(error_of<std::uint32_t>(path), "");
  write_column<Small>(path, std::vector<Small>{Small::one});
  EXPECT_EQ(error_of<std::uint8_t>(path), "") << "an enum is what it is made of";
}

TEST(ColumnFile, ADamagedHeaderIsRefusedBitByBit) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "c";
  write_column<std::uint32_t>(path, std::vector<std::uint32_t>{1, 2, 3});
  const std::string good = test::file_bytes(path);
  ASSERT_EQ(good.size(), 28u);
  for (std::size_t bit = 0; bit < 8 * sizeof(ColumnHeader); ++bit) {
    std::string bad = good;
    bad[bit / 8] = static_cast<char>(bad[bit / 8] ^ 1 << bit % 8);
    folder.put("bad", bad);
    EXPECT_NE(error_of<std::uint32_t>(folder.path() / "bad"), "") << "bit " << bit;
  }
  folder.put("bad", std::string(good.size(), '\0'));
  EXPECT_NE(error_of<std::uint32_t>(folder.path() / "bad").find("damaged"), std::string::npos);
}

TEST(ColumnFile, AFileMustBeAsLongAsItsValues) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "c";
  write_column<std::uint32_t>(path, std::vector<std::uint32_t>{1, 2, 3});
  const std::string good = test::file_bytes(path);
  for (const std::size_t length : {0u, 15u, 16u, 24u, 27u}) {
    folder.put("bad", good.substr(0, length));
    EXPECT_NE(error_of<std::uint32_t>(folder.path() / "bad"), "") << length;
  }
  folder.put("bad", good + "x");
  EXPECT_NE(error_of<std::uint32_t>(folder.path() / "bad").find("has 29 bytes where its 3 values take 28"),
            std::string::npos);
  std::vector<std::uint32_t> two(2);
  EXPECT_THROW(ColumnReader<std::uint32_t>(path).read(2, two), Error);
}

TEST(ColumnFile, AnotherVersionIsRefused) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "c";
  write_column<char>(path, std::span("x", 1));
  std::string other = test::file_bytes(path);
  ++other[0];
  std::uint32_t hash = 2166136261u;  // FNV-1a of all bytes of the header but the check's
  for (const std::size_t i : {0, 1, 2, 3, 8, 9, 10, 11, 12, 13, 14, 15})
    hash = (hash ^ static_cast<unsigned char>(other[i])) * 16777619u;
  for (std::size_t i = 0; i < 4; ++i) other[4 + i] = static_cast<char>(hash >> 8 * i & 0xff);
  folder.put("bad", other);
  EXPECT_NE(error_of<char>(folder.path() / "bad").find("in format 3 of another version"), std::string::npos);
}

}  // namespace
}  // namespace ilot
