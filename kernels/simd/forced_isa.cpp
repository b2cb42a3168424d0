// SPDX-License-Identifier: Apache-2.0
#include "kernels/simd/forced_isa.h"

#include <algorithm>
#include <cstdlib>

#include "kernels/simd/variants.h"

namespace ilot::simd {

std::vector<std::string> available_isas() {
  std::vector<std::string> names;
  for (const Isa isa : kIsas)
    if (has_isa(isa)) names.emplace_back(name_of(isa));
  return names;
}

std::string unavailable_forced_isa() {
  const char* forced = std::getenv("ILOT_FORCE_ISA");
  if (forced == nullptr || *forced == '\0') return {};
  const std::vector<std::string> names = available_isas();
  return std::find(names.begin(), names.end(), forced) == names.end() ? forced : "";
}

}  // namespace ilot::simd
