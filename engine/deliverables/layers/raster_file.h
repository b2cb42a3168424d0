// SPDX-License-Identifier: Apache-2.0
// A GeoTIFF that is being written.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <span>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// Pixels are square, north is up.
struct RasterPlace {
  double min_x = 0, max_y = 0, pixel = 1;  // CRS units
  std::uint32_t width = 0, height = 0;
};

enum class RasterValue : std::uint8_t { whole, real };  // u32, f32

// One compressed band in tiles of 256 pixels. Pixels that are never written take no space and are read as `nodata`.
// There are no time stamps. The file is complete after finish(); without it, no file remains. Throws Error when it
// cannot be written.
class RasterFile {
 public:
  RasterFile(const std::filesystem::path& path, const RasterPlace& place, RasterValue value, double nodata,
             const Crs& crs);
  ~RasterFile();
  RasterFile(const RasterFile&) = delete;
  RasterFile& operator=(const RasterFile&) = delete;

  // Rows begin in the north. (x, y) is the first pixel, counted from the upper left corner of the whole raster.
  void write(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height,
             std::span<const float> values);
  void finish();

 private:
  struct Dataset;
  std::unique_ptr<Dataset> dataset_;
};

}  // namespace ilot
