// SPDX-License-Identifier: Apache-2.0
// Manages OUT from the first check to the finished result. One run at a time works there. Its output is collected in
// OUT/.new and replaces an older result when it is complete.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/run_record.h"
#include "engine/run/folder_lock.h"
#include "engine/run/inputs/open_inputs.h"
#include "engine/run/run_estimate.h"

namespace ilot {

enum class Opened { fresh, resumed, finished };

class OutputFolder {
 public:
  // Locks OUT and the folder of the store. Throws a usage Error when a run works there, when OUT exists and no option
  // says what to do with it, or when one of them contains other files. Finishes a swap that an earlier run began.
  OutputFolder(const RunOptions& options, Progress& progress);

  // Prepares the store and the staging folder, or finds that nothing is left to do. --resume compares the request with
  // the earlier one and throws a usage Error that names the differences. An input inside OUT is a usage Error too.
  Opened open(const RunInputs& inputs);

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& store() const { return store_; }
  std::filesystem::path staging() const { return path_ / ".new"; }
  std::uint64_t block_points() const { return block_points_; }  // of the run that is resumed, or of this one

  // Throws Error when the disk has too little space for the store and the results.
  void check_space(const RunEstimate& needs);

  // Completes the record with the staged files and their hash, and swaps the result in.
  void publish(RunRecord& record) const;

  // Called after a failure that --resume cannot repair: removes the store, the staging folder and empty folders.
  void discard();

  // Called after publish(): the store and the staging folder are no longer needed.
  void finish(bool keep_store);

 private:
  Opened open_resumed();

  const RunOptions& options_;
  std::filesystem::path path_, store_;
  std::uint64_t block_points_;
  std::string request_;                 // what is asked for (run_request)
  std::vector<std::string> old_files_;  // files of the result that is replaced
  bool resumed_ = false;
  std::optional<FolderLock> lock_, store_lock_;
};

}  // namespace ilot
