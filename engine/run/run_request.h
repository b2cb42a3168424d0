// SPDX-License-Identifier: Apache-2.0
// What a run was asked for, as far as its result depends on it. It is kept with the store while the run works and in
// run.json afterwards, so that --resume can tell in every state whether it is asked for the same.
#pragma once
#include <string>

#include "engine/run/open_inputs.h"

namespace ilot {

// JSON, one line. Files are known by path, size, time of their last change and their first and last 4 KiB.
std::string run_request(const RunOptions& options, const RunInputs& inputs);

enum class Compare {
  store,  // all that the content of the store depends on
  result  // and whether clouds are written
};

// Names of what differs, with commas; empty when nothing does.
std::string request_differences(const std::string& before, const std::string& now, Compare what);

}  // namespace ilot
