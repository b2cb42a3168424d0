// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <optional>
#include <vector>

#include "engine/formats/rows_in_box.h"
#include "engine/pass/context.h"
#include "engine/pass/input_lattice.h"
#include "engine/store/partition.h"

namespace ilot {

struct IndexParams {
  double unit = 0.001;               // CRS units per lattice step
  double finest_step = kFinestStep;  // metres; no lattice is finer
  std::int64_t multiple = 1;         // of the finest steps of the inputs (InputLattice)
  IndexFilter filter;
  std::uint64_t block_points = 1u << 20;
  std::uint64_t run_points = 1u << 20;  // greatest size of one sorted run
  ClassColumns classes = ClassColumns::none;
  std::vector<std::vector<RowRange>> rows;  // of each input that may be kept, whole chunks; none: found in the files
  bool keep_places = false;      // keeps places of rows in memory for the labelled clouds (engine/store/row_places.h)
  bool keep_strays = false;      // keeps points that are isolated and far from all others (engine/store/strays.h)
  std::optional<Strays> strays;  // known from all inputs of a plan; none: found among the points of these inputs
};

struct IndexResult {
  Store store;
  std::array<std::uint64_t, kRejections> rejected{};
  InputLattice lattice;  // when finer than asked for, the other fields are empty: the inputs must be read again with it
  Index3 corner;         // least corner of the coarse cells with points, without strays; independent of the area
  Strays strays;         // what was left out as far from all other points
};

// Makes blocks from the inputs and reads each input once. With an area to keep, rows are not read when `rows` or an
// octree in the file says that they are outside it; they count as outside, whatever other faults they have. Results
// that an earlier start finished are found in the folder and kept. Memory: about 64 bytes per point of a run or a
// block, per thread.
IndexResult build_index(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params,
                        const std::filesystem::path& folder, const PassContext& context);

// The second half of build_index: makes the blocks of a store from runs that are there. Files of blocks that are in the
// folder already are kept. `params` gives block_points and classes.
std::vector<Block> build_blocks(const std::vector<SortedRun>& runs, const IndexParams& params, const Strays& strays,
                                const std::filesystem::path& folder, const PassContext& context);

// Returns the index that an earlier build_index left in the folder, without reading the inputs; nothing is written.
// `first` is the lattice that the run asked for first (common_lattice). Throws Error when the folder has no index.
IndexResult open_index(const std::filesystem::path& folder, const InputLattice& first);

}  // namespace ilot
