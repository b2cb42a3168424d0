// SPDX-License-Identifier: Apache-2.0
// Which products a cloud suits, as far as its own measures show.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/products/product.h"

namespace ilot {

struct ProductSuitability {
  const char* product = "";
  Suitability suits;
};

// Of all products in their order. What `run` refuses is "no" here.
std::vector<ProductSuitability> suitability(const CloudInfo& info, const CloudMeasure& measure);

// What is odd about the distance between points: 0, above 10 m or below 0.1 mm; the unit is probably wrong then.
std::optional<std::string> doubt_about_step(const CloudMeasure& measure);

// The CRS that `run` works with: unknown where the cloud says degrees and its places cannot be any.
Crs believed_crs(const CloudInfo& info, const CloudMeasure& measure);

}  // namespace ilot
