// SPDX-License-Identifier: Apache-2.0
// The products for which a cloud is suitable, as far as its own measures show it.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/columns/run_inputs.h"
#include "engine/pass/context.h"
#include "engine/products/product.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/store/store.h"

namespace ilot {

// Returns all products in their order. A product that `run` refuses, or warns of, has the answer "no" here.
std::vector<CloudSuitability> suitability(const CloudInfo& info, const CloudMeasure& measure);

// Warns of each of these products for which the points of a run, or of a plan, are not suitable: the answers "no" of
// suitability() over what the run uses. Such a product is made nevertheless.
void warn_of_unsuited(const std::vector<std::string>& products, const RunInputs& inputs, const CloudMeasure& measure,
                      Progress& progress, RunRecord& record);

// Returns a warning about the distance between points when it is 0, above 10 m or below 0.1 mm; then the unit is
// probably wrong.
std::optional<std::string> step_warning(const CloudMeasure& measure);

// Returns all warnings about a cloud: what its reader found, what its points contradict, and what a run would leave
// out.
std::vector<std::string> cloud_warnings(const CloudInfo& info, const CloudMeasure& measure);

// Returns the CRS with which `run` works: unknown when the cloud declares degrees and its places cannot be degrees.
Crs assumed_crs(const CloudInfo& info, const CloudMeasure& measure);

}  // namespace ilot
