// SPDX-License-Identifier: Apache-2.0
// A GeoTIFF in the making.
#pragma once
#include <filesystem>
#include <functional>
#include <memory>
#include <span>

#include "engine/cloud/cloud_info.h"

namespace ilot {

// Square pixels, north up.
struct RasterPlace {
  double min_x = 0, max_y = 0, pixel = 1;  // CRS units
  std::uint32_t width = 0, height = 0;
};

enum class RasterValue : std::uint8_t { whole, real };  // u32, f32

// One band, compressed, in tiles of 256 pixels; what is never written takes no room and reads as `nodata`. No time
// stamps. The file is whole after finish(); without it, none is left. Throws Error when it cannot be written.
class RasterFile {
 public:
  RasterFile(const std::filesystem::path& path, const RasterPlace& place, RasterValue value, double nodata,
             const Crs& crs);
  ~RasterFile();
  RasterFile(const RasterFile&) = delete;
  RasterFile& operator=(const RasterFile&) = delete;

  // Rows from the north; (x, y) is the first pixel from the upper left corner of the whole.
  void write(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height,
             std::span<const float> values);
  void finish();

 private:
  struct Dataset;
  std::unique_ptr<Dataset> dataset_;
};

}  // namespace ilot
