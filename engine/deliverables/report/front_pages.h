// SPDX-License-Identifier: Apache-2.0
// The sections of a report that every run has. Each returns HTML.
#pragma once
#include <string>

#include "engine/deliverables/report/result_folder.h"

namespace ilot {

std::string made_section(const ResultFolder& result);        // what was made, and each file with its use
std::string left_out_section(const ResultFolder& result);    // skipped, rejected and warned of: one line a reason
std::string inputs_section(const ResultFolder& result);      // clouds, footprints, stations
std::string parameters_section(const ResultFolder& result);  // values chosen for `auto` and why, then all
std::string lineage_section(const ResultFolder& result);     // versions, hashes, CRS
std::string stages_section(const ResultFolder& result);      // seconds and memory: the only part that two equal runs
                                                             // may differ in

// A reason without its numbers and names of units, so that equal reasons count together:
// "facade-012: 3 of 4 edges" -> "facade-#: # of # edges".
std::string reason_kind(const std::string& reason);

}  // namespace ilot
