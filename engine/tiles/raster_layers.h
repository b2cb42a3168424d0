// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>

#include "engine/pass/context.h"
#include "engine/tiles/packed_layers.h"
#include "engine/tiles/tile_layers.h"
#include "engine/tiles/tile_raster.h"
#include "engine/tiles/tile_runner.h"

namespace ilot {

// A raster with its layers, which are packed in memory and, beyond a share of the budget, in files of `folder`. It also
// runs the work on its tiles within --memory. The text of an Error begins with `use.what`.
class RasterLayers {
 public:
  RasterLayers(const PassContext& context, const std::filesystem::path& folder, TileRaster raster,
               const RasterUse& use);
  RasterLayers(const RasterLayers&) = delete;
  RasterLayers& operator=(const RasterLayers&) = delete;

  const TileRaster& raster() const { return raster_; }
  const TileLayers& layers() const { return layers_; }

 private:
  TileRaster raster_;
  PackedLayers packed_;
  TileRunner runner_;
  TileLayers layers_;
};

}  // namespace ilot
