// SPDX-License-Identifier: Apache-2.0
// Numbers of things in messages, with the noun in the right form.
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "engine/report/progress.h"

namespace ilot {

// Returns for example "1 building" or "1,234 buildings". `many` is the plural if it is not `one` with an s.
inline std::string counted(std::uint64_t number, std::string_view one, std::string_view many = {}) {
  const std::string noun = number == 1 ? std::string(one) : many.empty() ? std::string(one) + "s" : std::string(many);
  return grouped(number) + " " + noun;
}

}  // namespace ilot
