// SPDX-License-Identifier: Apache-2.0
// Numbers of things in messages, with the noun in the right form.
#pragma once
#include <algorithm>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "engine/report/progress.h"

namespace ilot {

// Returns for example "1 building" or "1,234 buildings". `many` is the plural if it is not `one` with an s.
inline std::string counted(std::uint64_t number, std::string_view one, std::string_view many = {}) {
  const std::string noun = number == 1 ? std::string(one) : many.empty() ? std::string(one) + "s" : std::string(many);
  return grouped(number) + " " + noun;
}

// Returns the first three names, and how many there are beyond them: "a, b, c and 12 more".
inline std::string first_names(std::span<const std::string> names) {
  constexpr std::size_t kNamed = 3;
  std::string text;
  for (std::size_t i = 0; i < std::min(names.size(), kNamed); ++i) text += (i > 0 ? ", " : "") + names[i];
  return names.size() > kNamed ? text + " and " + grouped(names.size() - kNamed) + " more" : text;
}

}  // namespace ilot
