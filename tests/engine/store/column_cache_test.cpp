// SPDX-License-Identifier: Apache-2.0
#include "engine/store/column_cache.h"

#include <gtest/gtest.h>

#include <numeric>

#include "engine/error.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/resident.h"
#include "engine/store/column_file.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

using Values = std::vector<std::uint32_t>;

// The cache is that of the process, so each test leaves it as it was.
struct ColumnCache : testing::Test {
  ~ColumnCache() override {
    set_memory_limit(0);
    set_column_cache(0);
  }
  fs::path path(const char* name) const { return folder.path() / name; }
  Values read(const char* name) const { return read_column<std::uint32_t>(path(name)); }
  void write(const char* name, const Values& values) const { write_column<std::uint32_t>(path(name), values); }

  TemporaryFolder folder;
};

Values ascending(std::size_t count, std::uint32_t first) {
  Values values(count);
  std::iota(values.begin(), values.end(), first);
  return values;
}

TEST_F(ColumnCache, ReadsAFileOnce) {
  set_column_cache(1 << 20);
  const Values values = ascending(50000, 7);
  write("a", values);
  EXPECT_EQ(column_cache_bytes(), 0u) << "what nobody reads is not kept";
  EXPECT_EQ(read("a"), values);
  EXPECT_EQ(column_cache_bytes(), 200000u);
  fs::remove(path("a"));
  EXPECT_EQ(read("a"), values);
  const ColumnReader<std::uint32_t> reader(path("a"));
  EXPECT_EQ(reader.size(), 50000u);
  EXPECT_EQ(reader.at(49999), 50006u);
  Values part(2);
  EXPECT_THROW(reader.read(49999, part), Error);
  EXPECT_THROW(ColumnReader<std::int32_t>(path("a")), Error) << "of another type";
}

TEST_F(ColumnCache, IsOffAtFirst) {
  write("a", ascending(1000, 1));
  EXPECT_EQ(read("a").size(), 1000u);
  EXPECT_EQ(column_cache_bytes(), 0u);
  fs::remove(path("a"));
  EXPECT_THROW(read("a"), Error);
}

TEST_F(ColumnCache, KeepsNoMoreThanItMay) {
  set_column_cache(100000);
  for (const char* name : {"a", "b", "c", "empty"}) {
    const Values values = ascending(name == std::string("empty") ? 0 : 10000, 1);
    write(name, values);
    EXPECT_EQ(read(name), values) << name;
    EXPECT_EQ(read(name), values) << name;
  }
  EXPECT_EQ(column_cache_bytes(), 80000u);
}

TEST_F(ColumnCache, AFileWrittenAgainIsTheNewOne) {
  set_column_cache(100000);
  write("a", ascending(1000, 1));
  EXPECT_EQ(read("a").size(), 1000u);
  write("a", ascending(10, 5));
  EXPECT_EQ(read("a"), ascending(10, 5));
  write("a", {});
  EXPECT_TRUE(read("a").empty());
}

TEST_F(ColumnCache, GivesWayInTheOrderOfUse) {
  set_column_cache(1 << 20);
  for (const char* name : {"a", "b", "c"}) {
    write(name, ascending(10000, 1));
    EXPECT_EQ(read(name).size(), 10000u);
    fs::remove(path(name));
  }
  ColumnReader<std::uint32_t> held(path("b"));
  for (const char* name : {"c", "a"}) EXPECT_EQ(read(name).size(), 10000u);
  set_column_cache(column_cache_bytes() - 1);
  EXPECT_THROW(read("b"), Error) << "it was not used for the longest time";
  const ColumnReader<std::uint32_t> moved(std::move(held));
  EXPECT_EQ(moved.at(9999), 10000u) << "a reader keeps what it reads";
  EXPECT_EQ(read("c").size(), 10000u);
  set_column_cache(0);
  EXPECT_THROW(read("a"), Error);
  EXPECT_EQ(column_cache_bytes(), 40000u) << "of the reader";
}

TEST_F(ColumnCache, ForgetsAFolder) {
  set_column_cache(1 << 20);
  for (const char* name : {"runs/a", "runs2/a"}) {
    fs::create_directories(path(name).parent_path());
    write(name, ascending(1000, 1));
    EXPECT_EQ(read(name).size(), 1000u);
    fs::remove(path(name));
  }
  forget_folder(path("runs"));
  EXPECT_THROW(read("runs/a"), Error);
  EXPECT_EQ(read("runs2/a").size(), 1000u);
  forget_file(path("runs2/a"));
  EXPECT_EQ(column_cache_bytes(), 0u);
}

// What tasks may take, and what is in use already, is never given to columns.
TEST_F(ColumnCache, HasTheRoomThatTasksLeave) {
  const auto kept_beside = [&](std::uint64_t limit, std::uint64_t reserved) {
    set_memory_limit(limit);
    write("a", ascending(1 << 20, 1));
    const ColumnRoom room(reserved);
    EXPECT_EQ(read("a").size(), 1u << 20);
    return column_cache_bytes();
  };
  constexpr std::uint64_t kLimit = std::uint64_t{64} << 30;
  EXPECT_EQ(kept_beside(96u << 20, 0), 0u) << "little memory is for tasks alone";
  EXPECT_EQ(kept_beside(0, 0), 0u) << "without a limit nobody says what is free";
  EXPECT_EQ(kept_beside(kLimit, 0), 4u << 20);
  EXPECT_EQ(kept_beside(kLimit, kLimit), 0u);
  EXPECT_EQ(kept_beside(kLimit, 0), 4u << 20);
  {
    const ColumnRoom all(kLimit);
    EXPECT_EQ(column_cache_bytes(), 0u) << "columns that are there give way";
  }
  EXPECT_EQ(kept_beside(kLimit, 0), 4u << 20);
  write("b", ascending(1000, 1));
  EXPECT_EQ(read("b").size(), 1000u);
  EXPECT_EQ(column_cache_bytes(), 4u << 20) << "no more are kept when the pass has ended";
  set_memory_limit(4u << 20);
  EXPECT_EQ(free_memory(), 0u);
  EXPECT_LE(column_cache_bytes(), 3u << 20) << "a quarter of the limit is to be free";
}

}  // namespace
}  // namespace ilot
