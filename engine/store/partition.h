// SPDX-License-Identifier: Apache-2.0
// Second half of the index: makes octree nodes with a bounded number of points, each merged from the sorted runs.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/store/sorted_run.h"
#include "engine/store/store.h"
#include "engine/store/strays.h"

namespace ilot {

struct RunRange {
  std::uint32_t run = 0;
  std::uint64_t first = 0, end = 0;
};

struct PlannedBlock {
  Node node;
  std::uint64_t points = 0;
  std::vector<RunRange> ranges;  // ascending by run and then by place in the run
};

// Returns the leaves of the octrees of all tiles in global order. Each leaf has at most `block_points` points (more
// only when that many coincide in one lattice point). Counts are exact. Strays are left out; the blocks are those of
// the other points. Reads a page of codes for each run and split.
std::vector<PlannedBlock> plan_blocks(std::span<const SortedRun> runs, std::uint64_t block_points,
                                      const Strays& strays = {});

enum class ClassColumns : std::uint8_t { none, written };

// Merges the ranges and writes the columns "codes", "order" and "chunks" and, on request, "class" and "echoes". 64
// bytes of memory a point.
Block build_block(const PlannedBlock& plan, std::span<const SortedRun> runs, ClassColumns classes,
                  const std::filesystem::path& folder);

}  // namespace ilot
