// SPDX-License-Identifier: Apache-2.0
// Layers of a raster in tiles as GeoTIFFs.
#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "engine/deliverables/layers/raster_file.h"
#include "engine/tiles/tile_raster.h"

namespace ilot {

constexpr std::int64_t kMostTilesOfSheet = 128;  // 65,536 pixels of tiles of 512: 3.3 km at 5 cm

// How a layer is written: `values` gives the value of each pixel of a tile, rows from the south.
struct SheetLayer {
  const char* name;
  RasterValue kind;
  double nodata;
  std::function<std::vector<float>(std::size_t tile)> values;
};

// Writes layers as GeoTIFFs, north up. A layer is one file where the raster has at most kMostTilesOfSheet tiles in both
// directions. A larger raster is cut into sheets of that size, at multiples of it on the lattice of tiles. Sheets
// without a tile are left out. The others are cut down to their tiles and numbered (range_1.tif, range_2.tif), and
// range.vrt shows them as one image. There is no range.vrt where it would have 2^31 pixels in one direction, which
// happens where points are farther apart than the Earth is wide. So the directory of a file has at most a megabyte, and
// regions far from all others cost only the space of their own tiles. The raster must outlive the object.
class TileSheets {
 public:
  TileSheets(const TileRaster& raster, const std::filesystem::path& folder, const Crs& crs);
  void write(const SheetLayer& layer) const;

 private:
  // A box of tiles of the lattice from the first row and column to the last, inclusive.
  struct TileBox {
    std::int64_t first_row = INT64_MAX, first_column = INT64_MAX, last_row = INT64_MIN, last_column = INT64_MIN;

    void add(const PointWindow& w);
    std::int64_t rows() const { return last_row - first_row + 1; }
    std::int64_t columns() const { return last_column - first_column + 1; }
  };
  // The tiles that are written to one file.
  struct Sheet {
    TileBox box;
    std::vector<std::size_t> tiles;
  };

  void cut();
  std::int64_t side() const { return raster_.grid.side; }
  RasterPlace place_of(const TileBox& box) const;
  void write_sheet(const SheetLayer& layer, const Sheet& sheet, const std::string& name) const;

  const TileRaster& raster_;
  std::filesystem::path folder_;
  Crs crs_;
  TileBox whole_;
  std::vector<Sheet> sheets_;
};

}  // namespace ilot
