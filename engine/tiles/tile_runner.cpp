// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/tile_runner.h"

#include <fmt/format.h>
#include <algorithm>
#include <vector>

#include "engine/error.h"
#include "engine/pass/kept_columns.h"
#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/report/resources.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

// Tasks between two measurements of the memory of the process: tables of 32 KB per tile grow by 2 MB in that time.
constexpr std::size_t kRound = 64;
// Memory that is kept free for the growth of tables within a round, stacks and the allocator's pools (at most a
// sixteenth of the whole).
constexpr std::uint64_t kMargin = 6u << 20;
constexpr std::uint64_t kShareOfMargin = 24;  // a further 1/24 of --memory is kept free
constexpr double kShareOfBudget = 0.35;       // share of the pass's budget, where no limit for the process is given

}  // namespace

// The free memory. A value below 0 means that too much is already in use.
std::int64_t TileRunner::free_bytes() const {
  if (memory_ == 0) return static_cast<std::int64_t>(kShareOfBudget * static_cast<double>(budget_));
  const std::uint64_t taken = resident_bytes() + layers_.unused() + kMargin + memory_ / kShareOfMargin;
  return static_cast<std::int64_t>(memory_) - static_cast<std::int64_t>(taken);
}

// Makes memory free and returns its size: at least `least`, at most `wanted`.
std::uint64_t TileRunner::make_room(std::uint64_t least, std::uint64_t wanted) const {
  const auto want = static_cast<std::int64_t>(wanted);
  std::int64_t free = free_bytes();
  if (free < want) {
    give_up_columns(static_cast<std::uint64_t>(want - free));
    trim_memory();  // gives memory that is free between packed rows back to the system, because it counts for --memory
    free = free_bytes();
  }
  if (free < want && memory_ > 0) {
    layers_.spill(static_cast<std::uint64_t>(want - free));
    trim_memory();
    free = free_bytes();
  }
  if (free >= static_cast<std::int64_t>(least)) return static_cast<std::uint64_t>(std::min(free, want));
  if (memory_ == 0) return least;  // the task runs alone
  const std::uint64_t enough = memory_ + least - static_cast<std::uint64_t>(std::max<std::int64_t>(0, free));
  throw Error(
      fmt::format("{}: this raster needs about {} MiB of memory at once, --memory allows {} MiB: give "
                  "--memory {}M or more, {}or a part of the points (--bounds)",
                  use_.what, (enough >> 20) + 1, memory_ >> 20, ((enough >> 20) / 64 + 1) * 64, use_.remedy));
}

void TileRunner::need(std::uint64_t bytes) const {
  make_room(bytes, bytes);
}

void TileRunner::run(std::span<const std::uint64_t> bytes, const std::function<void(std::size_t)>& body) const {
  const auto threads = static_cast<std::uint64_t>(thread_count());
  for (std::size_t first = 0; first < bytes.size(); first += kRound) {
    const auto round = bytes.subspan(first, std::min(kRound, bytes.size() - first));
    std::vector<PassTask> tasks;
    for (const std::uint64_t b : round) tasks.push_back({b, b});
    const std::uint64_t largest = *std::max_element(round.begin(), round.end());
    run_pass(tasks, make_room(largest, largest * threads), [&](std::size_t i) { body(first + i); });
  }
  trim_memory();
}

}  // namespace ilot
