// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <functional>
#include <span>

#include "engine/pass/context.h"
#include "engine/tiles/packed_layers.h"
#include "engine/tiles/raster_use.h"

namespace ilot {

// Runs the work on tiles within --memory. The memory of tables, layers, libraries and the allocator is measured before
// each round of tasks and not estimated. The tasks of the round share what is left. Where that is too little, layers
// are first moved to their files. Where it is too little for a single task, an Error names the memory that would be
// enough. The results do not depend on any of this.
class TileRunner {
 public:
  TileRunner(const PassContext& context, PackedLayers& layers, const RasterUse& use)
      : memory_(context.memory_bytes), budget_(context.budget_bytes), layers_(layers), use_(use) {}

  // The functions RunTasks and NeedBytes of a TileGrid.
  void run(std::span<const std::uint64_t> bytes, const std::function<void(std::size_t)>& body) const;
  void need(std::uint64_t bytes) const;

 private:
  std::int64_t free_bytes() const;
  std::uint64_t make_room(std::uint64_t least, std::uint64_t wanted) const;

  std::uint64_t memory_, budget_;
  PackedLayers& layers_;
  RasterUse use_;
};

}  // namespace ilot
