// SPDX-License-Identifier: Apache-2.0
// Which products a cloud suits, as far as its own measures show.
#pragma once
#include <array>
#include <optional>
#include <string>

#include "engine/run/measure.h"

namespace ilot {

struct Suitability {
  const char* product = "";
  bool yes = false;
  std::string reason;  // half a sentence
};

// planes, roofs, facades, streets, in this order. What `run` refuses is "no" here.
std::array<Suitability, 4> suitability(const CloudInfo& info, const CloudMeasure& measure);

// What is odd about the distance between points: 0, above 10 m or below 0.1 mm; the unit is probably wrong then.
std::optional<std::string> doubt_about_step(const CloudMeasure& measure);

// The CRS that `run` works with: unknown where the cloud says degrees and its places cannot be any.
Crs believed_crs(const CloudInfo& info, const CloudMeasure& measure);

}  // namespace ilot
