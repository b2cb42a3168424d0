// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/gpkg_file.h"

#include <cpl_conv.h>

#include "engine/deliverables/layers/silent_gdal.h"
#include "engine/deliverables/layers/spatial_reference.h"
#include "engine/error.h"

namespace ilot {
namespace {

constexpr int kFeaturesPerTransaction = 4096;

}  // namespace

void GpkgFile::fail() const {
  throw Error(path_.string() + ": cannot be written: " + CPLGetLastErrorMsg());
}

GpkgFile::GpkgFile(const std::filesystem::path& path) : path_(path) {
  CPLSetErrorHandler(keep_silent);
  CPLSetConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z");
  RegisterOGRGeoPackage();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  file_.reset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!file_) fail();
}

GpkgFile::~GpkgFile() {
  if (whole_) return;
  file_.reset();
  std::error_code ignored;
  std::filesystem::remove(path_, ignored);
}

OGRLayer& GpkgFile::add_layer(const char* name, OGRwkbGeometryType type, const Crs& crs) {
  auto reference = spatial_reference(crs);
  if (!reference) {  // GDAL maps this name to the id -1 of the standard; without a name it writes 0, degrees
    reference = std::make_unique<OGRSpatialReference>();
    reference->SetLocalCS("Undefined Cartesian SRS");
  }
  OGRLayer* layer = file_->CreateLayer(name, reference.get(), type, nullptr);
  if (layer == nullptr) fail();
  return *layer;
}

void GpkgFile::add_field(OGRLayer& layer, const char* name, OGRFieldType type, OGRFieldSubType detail) {
  OGRFieldDefn field(name, type);
  field.SetSubType(detail);
  layer.CreateField(&field);
}

void GpkgFile::add(OGRLayer& layer, OGRFeature& feature) {
  if (!writing_ && file_->StartTransaction() != OGRERR_NONE) fail();
  writing_ = true;
  if (layer.CreateFeature(&feature) != OGRERR_NONE) fail();
  if (++pending_ < kFeaturesPerTransaction) return;
  pending_ = 0;
  if (file_->CommitTransaction() != OGRERR_NONE || file_->StartTransaction() != OGRERR_NONE) fail();
}

void GpkgFile::finish() {
  CPLErrorReset();
  if (writing_ && file_->CommitTransaction() != OGRERR_NONE) fail();
  file_.reset();
  if (CPLGetLastErrorType() >= CE_Failure) fail();
  whole_ = true;
}

}  // namespace ilot
