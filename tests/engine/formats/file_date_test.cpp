// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/file_date.h"

#include <gtest/gtest.h>

#include "engine/cloud/record.h"

namespace ilot {
namespace {

std::string date_of(std::uint16_t day, std::uint16_t year) {
  CloudInfo info;
  info.header.resize(227);
  store(info.header.data() + 90, day);
  store(info.header.data() + 92, year);
  return file_date(info);
}

TEST(FileDate, DaysOfTheYear) {
  EXPECT_EQ(date_of(1, 2024), "2024-01-01");
  EXPECT_EQ(date_of(60, 2024), "2024-02-29");
  EXPECT_EQ(date_of(60, 2023), "2023-03-01");
  EXPECT_EQ(date_of(365, 2023), "2023-12-31");
  EXPECT_EQ(date_of(366, 2024), "2024-12-31");
  EXPECT_EQ(date_of(60, 2100), "2100-03-01") << "no leap year";
}

TEST(FileDate, DaysThatThereAreNot) {
  EXPECT_EQ(date_of(0, 2024), "");
  EXPECT_EQ(date_of(366, 2023), "");
  EXPECT_EQ(date_of(100, 0), "");
  EXPECT_EQ(date_of(65535, 65535), "");
  EXPECT_EQ(file_date({}), "") << "other formats have no such header";
}

}  // namespace
}  // namespace ilot
