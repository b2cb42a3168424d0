// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <string>
#include <vector>

#include "engine/deliverables/layers/raster_file.h"

namespace ilot {

// A file of a mosaic, in the folder of the mosaic, and its place in pixels from the upper left corner of the whole.
struct MosaicPart {
  std::string file;
  std::int64_t x = 0, y = 0;
  std::uint32_t width = 0, height = 0;
};

// Writes GDAL's virtual format (.vrt), which joins neighbouring files to one raster. QGIS opens it like a GeoTIFF.
// Pixels outside all parts are read as nodata.
void write_raster_mosaic(const std::filesystem::path& path, const RasterPlace& place, RasterValue value, double nodata,
                         const Crs& crs, const std::vector<MosaicPart>& parts);

}  // namespace ilot
