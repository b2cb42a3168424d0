// SPDX-License-Identifier: Apache-2.0
#include "engine/products/product.h"

#include <fmt/format.h>

namespace ilot {

void skip_product(ProductRun& run, const Product& product, const std::string& reason) {
  run.progress.unit_skipped(product.name, reason);
  run.record.skipped.push_back({"product", product.name, reason});
}

std::string step_text(const CloudMeasure& measure) {
  return fmt::format("{:.3g} m between points", measure.sampling_step);
}

}  // namespace ilot
