// SPDX-License-Identifier: Apache-2.0
#include "engine/cloud/record.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

TEST(Record, StandardSizesAreThoseOfTheSpecification) {
  const std::size_t sizes[] = {20, 28, 26, 34, 57, 63, 30, 36, 38, 59, 67};
  for (std::uint8_t format = 0; format <= 10; ++format) EXPECT_EQ(standard_size(format), sizes[format]);
  EXPECT_EQ(standard_size(11), 0u);
}

}  // namespace
}  // namespace ilot
