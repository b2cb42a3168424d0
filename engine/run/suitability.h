// SPDX-License-Identifier: Apache-2.0
// Which products a cloud suits, as far as its own measures show.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/products/product.h"

namespace ilot {

// Of all products in their order. What `run` refuses is "no" here.
std::vector<CloudSuitability> suitability(const CloudInfo& info, const CloudMeasure& measure);

// What is odd about the distance between points: 0, above 10 m or below 0.1 mm; the unit is probably wrong then.
std::optional<std::string> step_warning(const CloudMeasure& measure);

// All that is odd about a cloud: what its reader found, what its points do not bear out, what a run would leave out.
std::vector<std::string> cloud_warnings(const CloudInfo& info, const CloudMeasure& measure);

// The CRS that `run` works with: unknown where the cloud says degrees and its places cannot be any.
Crs assumed_crs(const CloudInfo& info, const CloudMeasure& measure);

}  // namespace ilot
