// SPDX-License-Identifier: Apache-2.0
#include "engine/store/column_file.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/error.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

std::ptrdiff_t entries(const fs::path& folder) {
  return std::distance(fs::directory_iterator(folder), {});
}

TEST(ColumnFile, WhatIsWrittenIsRead) {
  const TemporaryFolder folder;
  std::vector<std::uint32_t> values(100000);
  std::iota(values.begin(), values.end(), 5u);
  write_column<std::uint32_t>(folder.path() / "c", values);
  EXPECT_EQ(read_column<std::uint32_t>(folder.path() / "c"), values);
  std::vector<std::uint32_t> part(3);
  const ColumnReader reader(folder.path() / "c");
  EXPECT_EQ(reader.size(), 400000u);
  reader.read<std::uint32_t>(99997, part);
  EXPECT_EQ(part, (std::vector<std::uint32_t>{100002, 100003, 100004}));
  reader.read<std::uint32_t>(100000, std::span<std::uint32_t>());
}

TEST(ColumnFile, NothingAppearsBeforeCommitAndNothingStaysWithoutIt) {
  const TemporaryFolder folder;
  const std::uint64_t value = 7;
  {
    ColumnWriter writer(folder.path() / "c");
    writer.append(std::span(&value, 1));
    EXPECT_FALSE(fs::exists(folder.path() / "c"));
  }
  EXPECT_EQ(entries(folder.path()), 0);
  ColumnWriter writer(folder.path() / "c");
  writer.append(std::span(&value, 1));
  writer.commit();
  EXPECT_EQ(read_column<std::uint64_t>(folder.path() / "c"), std::vector<std::uint64_t>{7});
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(ColumnFile, AnOlderFileStaysWholeUntilTheNewOneIs) {
  const TemporaryFolder folder;
  const auto path = folder.put("c", "old");
  ColumnWriter writer(path);
  writer.append(std::span("newer", 5));
  EXPECT_EQ(fs::file_size(path), 3u);
  writer.commit();
  EXPECT_EQ(fs::file_size(path), 5u);
}

TEST(ColumnFile, AFailedCommitLeavesNothingBehind) {
  const TemporaryFolder folder;
  folder.put("c/inside", "a folder that is not empty cannot be replaced");
  {
    ColumnWriter writer(folder.path() / "c");
    EXPECT_THROW(writer.commit(), Error);
  }
  EXPECT_EQ(entries(folder.path()), 1);
}

TEST(ColumnFile, ShortAndMissingFilesAreErrorsThatNameThem) {
  const TemporaryFolder folder;
  const auto path = folder.put("short", "1234567");
  std::vector<std::uint32_t> two(2);
  try {
    ColumnReader(path).read<std::uint32_t>(0, two);
    FAIL() << "read beyond the end";
  } catch (const Error& e) {
    EXPECT_NE(std::string(e.what()).find(path.string()), std::string::npos);
  }
  EXPECT_THROW(ColumnReader(path).read<std::uint32_t>(1000, two), Error);
  EXPECT_THROW(ColumnReader(folder.path() / "none"), Error);
  EXPECT_THROW(ColumnWriter(folder.path() / "none" / "c"), Error);
  EXPECT_THROW(read_column<std::uint32_t>(folder.path()), Error);
}

TEST(ColumnFile, AReaderMoves) {
  const TemporaryFolder folder;
  ColumnReader a(folder.put("c", "x"));
  const ColumnReader b(std::move(a));
  EXPECT_EQ(b.size(), 1u);
}

}  // namespace
}  // namespace ilot
