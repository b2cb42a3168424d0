// SPDX-License-Identifier: Apache-2.0
// OUT appears piece by piece only behind the scenes: products are written in a staging folder and move in together.
#pragma once
#include <filesystem>
#include <string>

#include "engine/run/open_inputs.h"

namespace ilot {

class OutputFolder {
 public:
  // Applies the policy for an existing folder. Starting afresh removes what an earlier run left; resuming checks that
  // the manifest tells of the same inputs, settings and area, and throws a usage Error that names what differs. So does
  // a folder, of results or of the store, that holds something else, and an input that lies in the output folder.
  OutputFolder(const RunOptions& options, const RunInputs& inputs);

  const std::filesystem::path& path() const { return path_; }
  const std::filesystem::path& store() const { return store_; }
  std::filesystem::path staging() const { return path_ / ".new"; }
  std::uint64_t block_points() const { return block_points_; }  // of the run that is resumed, or this one's

  // Throws when the disk cannot hold the store and the products of so many points with records of so many bytes.
  void check_space(std::uint64_t points, std::uint64_t output_bytes) const;

  // Moves the staged products into place.
  void publish() const;

  // After a failure that --resume could not mend: no store, no staging folder, no empty folder stays.
  void discard() const;

  // After run.json: the run is complete; staging folder and store are no longer needed.
  void finish(bool keep_store) const;

 private:
  std::filesystem::path path_, store_;
  std::uint64_t block_points_;
};

// Does the folder hold the complete result of a run over these inputs with these settings?
bool is_finished(const RunOptions& options, const RunInputs& inputs);

// What a finished run left of its store when it was stopped while clearing up.
void clear_finished_store(const RunOptions& options);

// How much of --memory work may fill: without what estimates of the work leave out, the stacks of the threads and what
// the allocator keeps between blocks. An eighth at 96M, where 16 threads were seen to take 4 MiB of it.
std::uint64_t memory_to_fill(const RunOptions& options);

// Bytes of the store a point, all products together at most so many at a time: what runs are estimated by. Measured
// below by tests/run/memory.py.
constexpr std::uint64_t kStoreBytesPerPoint = 76;

// What --memory leaves for blocks in work, beside the program, its libraries and tables.
std::uint64_t memory_for_blocks(const RunOptions& options);

// Largest number of points in a block that the memory budget allows, at most the setting.
std::uint64_t affordable_block_points(const RunOptions& options, int threads);

}  // namespace ilot
