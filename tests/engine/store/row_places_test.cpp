// SPDX-License-Identifier: Apache-2.0
#include "engine/store/row_places.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "engine/cloud/record.h"
#include "engine/formats/reader.h"

namespace ilot {
namespace {

constexpr std::size_t kLength = 20;

// Stretches of 4, 4 and 2 rows.
class Reader final : public PointReader {
 public:
  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return true; }
  std::vector<std::uint64_t> boundaries() const override { return {0, 4, 8, 10}; }
  std::size_t read(std::uint64_t, std::span<std::byte>, std::span<std::uint8_t>) override { return 0; }

 private:
  CloudInfo info_;
};

// The cache is that of the process, so each test leaves it as it was.
struct RowPlaces : testing::Test {
  RowPlaces() {
    for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = static_cast<std::byte>(i);
  }
  ~RowPlaces() override { set_column_cache(0); }

  // Adds rows [2, 10) in parts of three.
  void keep() const {
    PlaceKeeper keeper("a", 1, Reader(), 2, 8);
    for (std::size_t row = 2; row < 10; row += 3)
      keeper.add(std::span(rows).subspan(row * kLength, std::min<std::size_t>(3, 10 - row) * kLength), kLength);
  }
  bool take(std::uint64_t first, std::size_t count, std::uint32_t file = 1) {
    taken.assign(count * kLength, std::byte{0});
    return take_places("a", file, first, kLength, taken);
  }

  std::vector<std::byte> rows = std::vector<std::byte>(10 * kLength), taken;
};

TEST_F(RowPlaces, AreThoseOfWholeStretches) {
  set_column_cache(1 << 20);
  keep();
  EXPECT_FALSE(take(0, 4));  // of which two rows came
  ASSERT_TRUE(take(4, 4));
  for (std::size_t i = 0; i < 4; ++i) {
    const std::size_t at = i * kLength;
    EXPECT_TRUE(std::equal(taken.data() + at, taken.data() + at + kPlaceBytes, rows.data() + 4 * kLength + at));
    EXPECT_EQ(taken[at + kPlaceBytes], std::byte{0});
  }
  EXPECT_TRUE(take(8, 2));
  EXPECT_FALSE(take(8, 1));
  EXPECT_FALSE(take(4, 4, 2));
  forget_folder("a/places");
  EXPECT_FALSE(take(4, 4));
}

TEST_F(RowPlaces, AreNotKeptWithoutRoom) {
  set_column_cache(3 * kPlaceBytes);
  keep();
  EXPECT_FALSE(take(4, 4));
  EXPECT_TRUE(take(8, 2));
}

}  // namespace
}  // namespace ilot
