// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_rasters.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>

#include "engine/deliverables/layers/raster_file.h"
#include "engine/deliverables/layers/raster_mosaic.h"
#include "kernels/core/integers.h"

namespace ilot {
namespace {

// Derived: the value for no data that readers of rasters expect.
constexpr float kNone = -9999;  // pixels without a height
constexpr std::int64_t kMostPixels = (std::int64_t{1} << 31) - 1;

// A box of tiles of the lattice from the first row and column to the last, inclusive.
struct TileBox {
  std::int64_t first_row = INT64_MAX, first_column = INT64_MAX, last_row = INT64_MIN, last_column = INT64_MIN;

  void add(const PointWindow& w) {
    first_row = std::min(first_row, w.row), last_row = std::max(last_row, w.row);
    first_column = std::min(first_column, w.column), last_column = std::max(last_column, w.column);
  }
  std::int64_t rows() const { return last_row - first_row + 1; }
  std::int64_t columns() const { return last_column - first_column + 1; }
};

// The tiles that are written to one file.
struct Sheet {
  TileBox box;
  std::vector<std::size_t> tiles;
};

std::vector<Sheet> sheets_of(const TileRaster& raster, TileBox& whole) {
  const auto sheet_of = [](std::int64_t tile) { return floor_divided(tile, kMostTilesOfSheet); };
  std::map<PointWindow, Sheet> by_place;
  for (std::size_t tile = 0; tile < raster.grid.count(); ++tile) whole.add(raster.window(tile));
  const bool one = whole.rows() <= kMostTilesOfSheet && whole.columns() <= kMostTilesOfSheet;
  for (std::size_t tile = 0; tile < raster.grid.count(); ++tile) {
    const PointWindow at = raster.window(tile);
    Sheet& sheet = by_place[one ? PointWindow{} : PointWindow{sheet_of(at.row), sheet_of(at.column)}];
    sheet.box.add(at);
    sheet.tiles.push_back(tile);
  }
  std::vector<Sheet> sheets;
  for (auto& entry : by_place) sheets.push_back(std::move(entry.second));
  return sheets;
}

// How a layer is written: `values` gives the value of each pixel of a tile.
struct RasterLayer {
  const char* name;
  RasterValue kind;
  double nodata;
  std::function<std::vector<float>(std::size_t tile)> values;
};

class RasterWriter {
 public:
  RasterWriter(const StreetTiles& tiles, const std::filesystem::path& folder, const Crs& crs)
      : raster_(tiles.raster()), folder_(folder), crs_(crs), sheets_(sheets_of(raster_, whole_)) {}

  void write(const RasterLayer& layer) const {
    if (sheets_.size() == 1) {
      write_sheet(layer, sheets_[0], std::string(layer.name) + ".tif");
      return;
    }
    std::vector<MosaicPart> parts;
    for (const Sheet& sheet : sheets_) {
      const std::string name = fmt::format("{}_{}.tif", layer.name, parts.size() + 1);
      write_sheet(layer, sheet, name);
      const RasterPlace place = place_of(sheet.box);
      parts.push_back({name, side() * (sheet.box.first_column - whole_.first_column),
                       side() * (whole_.last_row - sheet.box.last_row), place.width, place.height});
    }
    if (std::max(whole_.rows(), whole_.columns()) * side() <= kMostPixels)
      write_raster_mosaic(folder_ / (std::string(layer.name) + ".vrt"), place_of(whole_), layer.kind, layer.nodata,
                          crs_, parts);
  }

 private:
  std::int64_t side() const { return raster_.grid.side; }

  RasterPlace place_of(const TileBox& box) const {
    const double units = static_cast<double>(raster_.pixel) * raster_.unit;  // CRS units of a pixel
    const auto at = [&](std::int64_t tile) {
      return static_cast<double>(tile * side()) * static_cast<double>(raster_.pixel) * raster_.unit;
    };
    return {at(box.first_column), at(box.last_row + 1), units, static_cast<std::uint32_t>(box.columns() * side()),
            static_cast<std::uint32_t>(box.rows() * side())};
  }

  void write_sheet(const RasterLayer& layer, const Sheet& sheet, const std::string& name) const {
    RasterFile file(folder_ / name, place_of(sheet.box), layer.kind, layer.nodata, crs_);
    const std::uint32_t size = raster_.grid.side;
    for (const std::size_t tile : sheet.tiles) {
      const std::vector<float> rows = layer.values(tile);
      std::vector<float> turned(rows.size());
      for (std::size_t y = 0; y < size; ++y)
        std::copy_n(rows.begin() + static_cast<std::ptrdiff_t>(y * size), size,
                    turned.begin() + static_cast<std::ptrdiff_t>((size - 1 - y) * size));
      const PointWindow at = raster_.window(tile);
      file.write(static_cast<std::uint32_t>(at.column - sheet.box.first_column) * size,
                 static_cast<std::uint32_t>(sheet.box.last_row - at.row) * size, size, size, turned);
    }
    file.finish();
  }

  const TileRaster& raster_;
  const std::filesystem::path& folder_;
  const Crs& crs_;
  TileBox whole_;  // set by sheets_of
  std::vector<Sheet> sheets_;
};

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
  const RasterWriter writer(tiles, folder, crs);
  writer.write({"range", RasterValue::real, kNone, heights("range", unit, nullptr)});
  writer.write({"accumulation", RasterValue::whole, 0, counts});
  writer.write({"ground", RasterValue::real, kNone, heights("level", unit, "mask")});
  writer.write({"artefacts", RasterValue::real, kNone, heights("height", tiles.raster().scale.unit, nullptr)});
}

}  // namespace ilot
