// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <array>
#include <filesystem>
#include <memory>
#include <vector>

#include "engine/pass/context.h"
#include "engine/store/partition.h"

namespace ilot {

struct IndexParams {
  double unit = 0.001;  // CRS units per lattice step
  IndexFilter filter;
  std::uint64_t block_points = 1u << 20;
  std::uint64_t run_points = 1u << 20;  // most of one sorted run
  ClassColumns classes = ClassColumns::none;
};

struct IndexResult {
  Store store;
  std::array<std::uint64_t, kRejections> rejected{};
};

// One lattice step for all inputs: their finest scale, but not below 0.01 mm. In CRS units.
double common_unit(const std::vector<std::unique_ptr<PointReader>>& inputs, double metres_per_unit);

// Inputs to blocks, reading each input once. With an area to keep, rows that an octree in the file places beyond it are
// not read: they count as outside it, whatever else may be wrong with them. Work that an earlier start finished is
// found in the folder and kept. Memory: about 64 bytes per point of a run or a block, per thread.
IndexResult build_index(const std::vector<std::unique_ptr<PointReader>>& inputs, const IndexParams& params,
                        const std::filesystem::path& folder, const PassContext& context);

}  // namespace ilot
