// SPDX-License-Identifier: Apache-2.0
// The request of a run, as far as its result depends on it. It is kept with the store while the run works and in
// run.json afterwards. So --resume can test at any time whether the new request is the same.
#pragma once
#include <string>

#include "engine/run/inputs/open_inputs.h"

namespace ilot {

// Returns JSON on one line. Files are identified by path, size, time of their last change and their first and last 4
// KiB.
std::string run_request(const RunOptions& options, const RunInputs& inputs);

enum class Compare {
  store,  // everything on which the content of the store depends
  result  // and also whether clouds are written
};

// Returns the names of the differences, separated by commas; empty when there are none.
std::string request_differences(const std::string& before, const std::string& now, Compare what);

// Hashes the first and the last 4 KiB of a file: what a header declares and how the file ends, without reading all of
// it.
std::string ends_of(const std::filesystem::path& path);

}  // namespace ilot
