// SPDX-License-Identifier: Apache-2.0
// OUT from the first check to the finished result. One run works there at a time; what it makes is staged in OUT/.new
// and takes the place of an older result when it is whole.
#pragma once
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/report/run_record.h"
#include "engine/run/folder_lock.h"
#include "engine/run/open_inputs.h"
#include "engine/run/run_estimate.h"

namespace ilot {

enum class Opened { fresh, resumed, finished };

class OutputFolder {
 public:
  // Locks OUT and the folder of the store. Throws a usage Error when a run works there, when OUT exists and nothing
  // says what to do with it, or when one of them contains something else. Finishes a swap that an earlier run began.
  OutputFolder(const RunOptions& options, Progress& progress);

  // Prepares store and staging folder, or finds that nothing is left to do. --resume compares what is asked with what
  // was asked and throws a usage Error that names the differences. An input inside of OUT is one too.
  Opened open(const RunInputs& inputs);

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& store() const { return store_; }
  std::filesystem::path staging() const { return path_ / ".new"; }
  std::uint64_t block_points() const { return block_points_; }  // of the run that is resumed, or this one's

  // Throws when the disk cannot hold the store and the results.
  void check_space(const RunEstimate& needs);

  // Completes the record with the staged files and their hash, and swaps the result in.
  void publish(RunRecord& record) const;

  // After a failure that --resume could not mend: no store, no staging folder, no empty folder stays.
  void discard();

  // After publish(): store and staging folder are no longer needed.
  void finish(bool keep_store);

 private:
  Opened open_resumed();

  const RunOptions& options_;
  std::filesystem::path path_, store_;
  std::uint64_t block_points_;
  std::string request_;                 // what is asked (run_request)
  std::vector<std::string> old_files_;  // of the result that is replaced
  bool resumed_ = false;
  std::optional<FolderLock> lock_, store_lock_;
};

// How much of --memory work may fill: without what estimates of the work leave out, the stacks of the threads and what
// the allocator keeps between blocks. An eighth at 96M, where 16 threads were seen to take 4 MiB of it.
std::uint64_t memory_to_fill(const RunOptions& options);

// What --memory leaves for blocks in work, beside the program, its libraries and tables.
std::uint64_t memory_for_blocks(const RunOptions& options);

// Largest number of points in a block that the memory budget allows, at most the setting.
std::uint64_t affordable_block_points(const RunOptions& options, int threads);

}  // namespace ilot
