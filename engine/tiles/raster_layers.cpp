// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/raster_layers.h"

namespace ilot {
namespace {

constexpr double kShareOfLayers = 0.15;  // share of the budget for packed layers

}  // namespace

RasterLayers::RasterLayers(const PassContext& context, const std::filesystem::path& folder, TileRaster raster,
                           const RasterUse& use)
    : raster_(std::move(raster)),
      packed_(folder, static_cast<std::uint64_t>(kShareOfLayers * static_cast<double>(context.budget_bytes))),
      runner_(context, packed_, use) {
  raster_.grid.run = [this](std::span<const std::uint64_t> bytes, const std::function<void(std::size_t)>& body) {
    runner_.run(bytes, body);
  };
  raster_.grid.need = [this](std::uint64_t bytes) { runner_.need(bytes); };
  layers_ = {raster_.grid,
             [this](const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out) {
               packed_.read(layer, tile, part, out);
             },
             [this](const char* layer, std::size_t tile, const Image& image) { packed_.write(layer, tile, image); },
             [this](const char* layer) { packed_.drop(layer); }};
}

}  // namespace ilot
