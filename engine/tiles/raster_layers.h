// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "engine/pass/context.h"
#include "engine/tiles/packed_layers.h"
#include "engine/tiles/tile_layers.h"
#include "engine/tiles/tile_raster.h"
#include "engine/tiles/tile_runner.h"

namespace ilot {

// A raster with its layers, packed in memory and, beyond a share of the budget, in files of `folder`; and the work on
// its tiles within --memory. `what` stands in front of what an Error says.
class RasterLayers {
 public:
  RasterLayers(const PassContext& context, const std::filesystem::path& folder, TileRaster raster,
               const std::string& what);
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
