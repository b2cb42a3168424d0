// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_rasters.h"

#include "engine/deliverables/layers/tile_sheets.h"

namespace ilot {
namespace {

// Derived: the value for no data that readers of rasters expect.
constexpr float kNone = -9999;  // pixels without a height

}  // namespace

void write_street_rasters(const StreetTiles& tiles, const std::filesystem::path& folder, const Crs& crs) {
  const double unit = tiles.raster().unit;
  const auto heights = [&](const char* layer, double per_unit, const char* where) {
    return [&tiles, layer, per_unit, where](std::size_t tile) {
      const Image image = layer_tile(tiles.layers(), layer, tile);
      const Image mask = where == nullptr ? Image{} : layer_tile(tiles.layers(), where, tile);
      std::vector<float> out(image.size(), kNone);
      for (std::size_t i = 0; i < image.size(); ++i)
        if (image.values[i] != kNoHeight && (where == nullptr || mask.values[i] == 1))
          out[i] = static_cast<float>(image.values[i] * per_unit);
      return out;
    };
  };
  const auto counts = [&](std::size_t tile) {
    const Image image = layer_tile(tiles.layers(), "accumulation", tile);
    return std::vector<float>(image.values.begin(), image.values.end());
  };
  const TileSheets writer(tiles.raster(), folder, crs);
  writer.write({"range", RasterValue::real, kNone, heights("range", unit, nullptr)});
  writer.write({"accumulation", RasterValue::whole, 0, counts});
  writer.write({"ground", RasterValue::real, kNone, heights("level", unit, "mask")});
  writer.write({"artefacts", RasterValue::real, kNone, heights("height", tiles.raster().scale.unit, nullptr)});
}

}  // namespace ilot
