// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/packed.h"

#include <gtest/gtest.h>

#include <limits>

namespace ilot {
namespace {

TEST(Packed, Base64IsThatOfTheStandard) {  // RFC 4648, section 10
  EXPECT_EQ(base64(""), "");
  EXPECT_EQ(base64("f"), "Zg==");
  EXPECT_EQ(base64("fo"), "Zm8=");
  EXPECT_EQ(base64("foo"), "Zm9v");
  EXPECT_EQ(base64("foob"), "Zm9vYg==");
  EXPECT_EQ(base64("fooba"), "Zm9vYmE=");
  EXPECT_EQ(base64("foobar"), "Zm9vYmFy");
  EXPECT_EQ(base64("\xff\xfe\xfd"), "//79");
}

TEST(Packed, EqualBytesAreEqualTextAndSmallWhereTheyRepeat) {
  const std::string bytes(100000, 'a');
  EXPECT_EQ(packed(bytes), packed(bytes));
  EXPECT_LT(packed(bytes).size(), 1000u);
  EXPECT_FALSE(packed("").empty());
}

TEST(Packed, NumbersComeBack) {
  const std::int64_t values[] = {0,
                                 1,
                                 -1,
                                 63,
                                 -64,
                                 64,
                                 1000000,
                                 -1000000,
                                 std::numeric_limits<std::int64_t>::max(),
                                 std::numeric_limits<std::int64_t>::min()};
  std::string bytes;
  for (const std::int64_t v : values) put_signed(bytes, v);
  put_whole(bytes, 127), put_whole(bytes, 128), put_whole(bytes, ~std::uint64_t{0});
  std::size_t at = 0;
  for (const std::int64_t v : values) EXPECT_EQ(take_signed(bytes, at), v);
  EXPECT_EQ(take_whole(bytes, at), 127u);
  EXPECT_EQ(take_whole(bytes, at), 128u);
  EXPECT_EQ(take_whole(bytes, at), ~std::uint64_t{0});
  EXPECT_EQ(at, bytes.size());
  EXPECT_EQ(take_whole(bytes, at), 0u);  // behind the end
}

}  // namespace
}  // namespace ilot
