// SPDX-License-Identifier: Apache-2.0
// What run.json says of the result that is in a folder.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/run_record.h"

namespace ilot {

struct FinishedResult {
  std::string request;              // as run_request(); empty: not recorded
  std::vector<ResultRecord> files;  // of the result, without run.json
  bool listed = false;              // false: an older version did not record its files
};

// nullopt when there is no run.json or none that can be read.
std::optional<FinishedResult> read_finished(const std::filesystem::path& out);

// The files of the result that is in OUT, relative to it; none without a run.json. Throws a usage Error when they are
// not recorded: then nothing tells them from somebody's own.
std::vector<std::string> files_to_replace(const std::filesystem::path& out);

// Throws a usage Error that names the first file which is gone or has another size than the run gave it.
void check_whole(const std::filesystem::path& out, const FinishedResult& result);

}  // namespace ilot
