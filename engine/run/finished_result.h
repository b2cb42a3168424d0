// SPDX-License-Identifier: Apache-2.0
// What run.json records of the result in a folder.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/run_record.h"

namespace ilot {

struct FinishedResult {
  std::string request;              // as from run_request(); empty: not recorded
  std::vector<ResultRecord> files;  // files of the result, without run.json
  bool listed = false;              // false: an older version did not record its files
};

// Returns nullopt when there is no readable run.json.
std::optional<FinishedResult> read_finished(const std::filesystem::path& out);

// Returns the files of the result in OUT, relative to it; none without a run.json. Throws a usage Error when they are
// not recorded, because then they cannot be distinguished from the user's own files.
std::vector<std::string> files_to_replace(const std::filesystem::path& out);

// Throws a usage Error that names the first file that is missing or has another size than the run recorded.
void check_whole(const std::filesystem::path& out, const FinishedResult& result);

}  // namespace ilot
