// SPDX-License-Identifier: Apache-2.0
// What labels of points depend on, by runs of consecutive points. Points lie along a space-filling curve, so most runs
// lie within one surface, with all that is around them, and where labels follow neighbours nothing happens there.
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "kernels/planes/region_growing.h"

namespace ilot {

// Which runs the neighbours of each run's points lie in.
class RunNeighbours {
 public:
  static constexpr std::uint32_t kRun = 32;  // points

  // O(points k). Keeps no reference to the lists.
  RunNeighbours(std::size_t points, const NeighbourLists& neighbours);

  std::size_t count() const { return runs_; }
  // Other runs, in no order.
  std::span<const std::uint32_t> around(std::size_t run) const {
    return std::span(others_).subspan(first_[run], first_[run + 1] - first_[run]);
  }

 private:
  std::size_t runs_;
  std::vector<std::size_t> first_;
  std::vector<std::uint32_t> others_;
};

// Per run 1 where all its points have one label, as all points of the runs around it have. O(points).
std::vector<std::uint8_t> uniform_runs(const RunNeighbours& runs, std::span<const std::uint32_t> label);

// Per run 1 where no point of the set lies in it nor in the runs around it. O(set + runs).
std::vector<std::uint8_t> unaffected_runs(const RunNeighbours& runs, std::span<const std::uint32_t> set);

}  // namespace ilot
