// SPDX-License-Identifier: Apache-2.0
#include "engine/store/scratch_column.h"

#include <gtest/gtest.h>

#include <numeric>

#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

TEST(ScratchColumn, FewValuesStayInMemoryAndManyAreInAFileWithoutAName) {
  const TemporaryFolder folder;
  for (const std::uint64_t count : {0u, 1u, 99u, 100u, 101u, 5000u}) {
    ScratchColumn<std::uint64_t> column(folder.path(), 100);
    for (std::uint64_t i = 0; i < count; ++i) column.add(i * i);
    column.finish();
    ASSERT_EQ(column.size(), count);
    EXPECT_EQ(column.in_memory() != nullptr, count < 100 && count > 0) << count;
    std::vector<std::uint64_t> read(count);
    column.read(0, read);
    for (std::uint64_t i = 0; i < count; ++i) ASSERT_EQ(read[i], i * i);
    EXPECT_TRUE(std::filesystem::is_empty(folder.path()));
  }
}

TEST(ScratchColumn, WrittenInAnyOrder) {
  const TemporaryFolder folder;
  for (const std::size_t most : {10u, 100000u}) {
    ScratchColumn<int> column(folder.path(), most);
    column.resize(1000);
    for (int first = 900; first >= 0; first -= 100) {
      std::vector<int> values(100);
      std::iota(values.begin(), values.end(), first);
      column.write(static_cast<std::uint64_t>(first), values);
    }
    std::vector<int> read(1000), expected(1000);
    std::iota(expected.begin(), expected.end(), 0);
    column.read(0, read);
    EXPECT_EQ(read, expected);
  }
}

TEST(ScratchColumn, AFolderThatIsNotThereIsNamed) {
  ScratchColumn<int> column("/nowhere/at/all", 1);
  try {
    column.add(1);
    FAIL();
  } catch (const std::exception& fault) {
    EXPECT_NE(std::string(fault.what()).find("/nowhere/at/all"), std::string::npos) << fault.what();
  }
}

}  // namespace
}  // namespace ilot
