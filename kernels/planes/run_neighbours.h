// SPDX-License-Identifier: Apache-2.0
// Dependencies between labels of points, by runs of consecutive points. Points are in the order of a space-filling
// curve, so most runs are within one surface, with all points around them. Where labels follow neighbours, nothing
// changes in such runs.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/planes/region_growing.h"

namespace ilot {

// For each run the other runs that contain neighbours of its points.
class RunNeighbours {
 public:
  static constexpr std::uint32_t kRun = 8;  // points

  // O(points k). Keeps no reference to the lists.
  RunNeighbours(std::size_t points, const NeighbourLists& neighbours);

  std::size_t count() const { return runs_; }
  // Returns the other runs, in no order.
  std::span<const std::uint32_t> around(std::size_t run) const {
    return std::span(others_).subspan(first_[run], first_[run + 1] - first_[run]);
  }

 private:
  std::size_t runs_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> others_;
};

// Returns 1 for each run whose points all have one label that all points of the runs around it have too. O(points).
std::vector<std::uint8_t> uniform_runs(const RunNeighbours& runs, std::span<const std::uint32_t> label);

// Returns 1 for each run where neither it nor the runs around it contain a point of the set. O(set + runs).
std::vector<std::uint8_t> unaffected_runs(const RunNeighbours& runs, std::span<const std::uint32_t> set);

}  // namespace ilot
