// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <string>
#include <utility>

#include "engine/pass/context.h"
#include "engine/tiles/packed_layers.h"

namespace ilot {

// Runs the work on tiles within --memory as the process stands: what tables, layers, libraries and the allocator hold
// is measured before each round of tasks, not estimated, and the tasks of the round share what is left. Where that is
// too little, layers move to their files first; where it is too little for a single task, an Error says how much memory
// would do. What is computed depends on none of this.
class TileRunner {
 public:
  TileRunner(const PassContext& context, PackedLayers& layers, std::string what)
      : memory_(context.memory_bytes), budget_(context.budget_bytes), layers_(layers), what_(std::move(what)) {}

  // RunTasks and NeedBytes of a TileGrid.
  void run(std::span<const std::uint64_t> bytes, const std::function<void(std::size_t)>& body) const;
  void need(std::uint64_t bytes) const;

 private:
  std::int64_t free_bytes() const;
  std::uint64_t make_room(std::uint64_t least, std::uint64_t wanted) const;

  std::uint64_t memory_, budget_;
  PackedLayers& layers_;
  std::string what_;  // runs: in front of what an Error says
};

}  // namespace ilot
