// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/file_date.h"

#include <fmt/format.h>

#include <array>

#include "engine/cloud/record.h"
#include "engine/formats/las/las_header.h"

namespace ilot {

std::string file_date(const CloudInfo& info) {
  if (info.header.size() < las::kYear + 2) return {};
  int day = load<std::uint16_t>(info.header.data() + las::kDayOfYear);
  const int year = load<std::uint16_t>(info.header.data() + las::kYear);
  const bool leap = (year % 4 == 0 && year % 100 != 0) || year % 400 == 0;
  const std::array<int, 12> lengths{31, leap ? 29 : 28, 31, 30, 31, 30, 31, 31, 30, 31, 30, 31};
  if (year < 1970 || year > 9999 || day < 1) return {};
  for (std::size_t month = 0; month < lengths.size(); day -= lengths[month++])
    if (day <= lengths[month]) return fmt::format("{}-{:02}-{:02}", year, month + 1, day);
  return {};
}

}  // namespace ilot
