// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/raster_file.h"

#include <cpl_conv.h>
#include <gdal_priv.h>

#include <string>

#include "engine/deliverables/layers/silent_gdal.h"
#include "engine/deliverables/layers/spatial_reference.h"
#include "engine/error.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr GIntBig kCacheBytes = 4 << 20;  // a tile is written at once; GDAL's default share of memory is not needed

}  // namespace

struct RasterFile::Dataset {
  std::filesystem::path path;
  GDALDatasetUniquePtr file;
  bool whole = false;

  [[noreturn]] void fail() const { throw Error(path.string() + ": cannot be written: " + CPLGetLastErrorMsg()); }
};

RasterFile::RasterFile(const std::filesystem::path& path, const RasterPlace& place, RasterValue value, double nodata,
                       const Crs& crs)
    : dataset_(std::make_unique<Dataset>()) {
  CPLSetErrorHandler(keep_silent);
  GDALSetCacheMax64(kCacheBytes);
  dataset_->path = path;
  GDALRegister_GTiff();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
  char** options = nullptr;
  for (const char* option : {"TILED=YES", "BLOCKXSIZE=256", "BLOCKYSIZE=256", "COMPRESS=DEFLATE", "ZLEVEL=1",
                             "SPARSE_OK=TRUE", "BIGTIFF=IF_SAFER"})
    options = CSLAddString(options, option);
  options = CSLAddString(options, value == RasterValue::real ? "PREDICTOR=3" : "PREDICTOR=2");
  // GDAL compresses tiles on threads of its own and writes them in the order in which they came.
  options = CSLSetNameValue(options, "NUM_THREADS", std::to_string(thread_count()).c_str());
  dataset_->file.reset(driver->Create(path.c_str(), static_cast<int>(place.width), static_cast<int>(place.height), 1,
                                      value == RasterValue::real ? GDT_Float32 : GDT_UInt32, options));
  CSLDestroy(options);
  if (!dataset_->file) dataset_->fail();
  double transform[6] = {place.min_x, place.pixel, 0, place.max_y, 0, -place.pixel};
  dataset_->file->SetGeoTransform(transform);
  if (const auto reference = spatial_reference(crs)) dataset_->file->SetSpatialRef(reference.get());
  dataset_->file->GetRasterBand(1)->SetNoDataValue(nodata);
}

RasterFile::~RasterFile() {
  if (dataset_->whole) return;
  dataset_->file.reset();
  std::error_code ignored;
  std::filesystem::remove(dataset_->path, ignored);
}

void RasterFile::write(std::uint32_t x, std::uint32_t y, std::uint32_t width, std::uint32_t height,
                       std::span<const float> values) {
  CPLErrorReset();
  const CPLErr failed = dataset_->file->GetRasterBand(1)->RasterIO(
      GF_Write, static_cast<int>(x), static_cast<int>(y), static_cast<int>(width), static_cast<int>(height),
      const_cast<float*>(values.data()), static_cast<int>(width), static_cast<int>(height), GDT_Float32, 0, 0, nullptr);
  if (failed != CE_None || dataset_->file->GetRasterBand(1)->FlushCache(false) != CE_None) dataset_->fail();
  // A tile of an earlier call that was compressed in the meantime and cannot be written is told here only.
  if (CPLGetLastErrorType() >= CE_Failure) dataset_->fail();
}

void RasterFile::finish() {
  CPLErrorReset();
  dataset_->file.reset();
  if (CPLGetLastErrorType() >= CE_Failure) dataset_->fail();
  dataset_->whole = true;
}

}  // namespace ilot
