// SPDX-License-Identifier: Apache-2.0
// The section of the facades, and what the scripts draw of them.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "engine/deliverables/report/report_limits.h"
#include "engine/deliverables/report/result_folder.h"

namespace ilot {

struct FacadePages {
  std::string html;              // empty without facades
  nlohmann::ordered_json scene;  // a list of scene_facade(), with `image` where there is one in the page
};

// Reads facades/facade-NNN.json in the order of numbers. Images and drawings are embedded up to a bound; the others
// have links to their files.
FacadePages facade_pages(const ResultFolder& result, const SceneFrame& frame, const ReportLimits& limits);

}  // namespace ilot
