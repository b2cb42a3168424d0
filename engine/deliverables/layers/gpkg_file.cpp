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

void GpkgFile::add_point(OGRLayer& layer, OGRFeature& feature, Vec3 place) {
  OGRPoint point(place.x, place.y, place.z);
  feature.SetGeometry(&point);
  add(layer, feature);
}

void GpkgFile::add_area(OGRLayer& layer, OGRFeature& feature, std::span<const Vec3> corners) {
  OGRLinearRing ring;
  for (const Vec3& corner : corners) ring.addPoint(corner.x, corner.y);
  ring.closeRings();
  OGRPolygon polygon;
  polygon.addRing(&ring);
  feature.SetGeometry(&polygon);
  add(layer, feature);
}

void GpkgFile::add(OGRLayer& layer, OGRFeature& feature) {
  if (!writing_ && file_->StartTransaction() != OGRERR_NONE) fail();
  writing_ = true;
  if (layer.CreateFeature(&feature) != OGRERR_NONE) fail();
  if (++pending_ < kFeaturesPerTransaction) return;
  pending_ = 0;
  if (file_->CommitTransaction() != OGRERR_NONE || file_->StartTransaction() != OGRERR_NONE) fail();
}

void GpkgFile::set_style(const OGRLayer& layer, const LayerStyle& style) {
  styles_.emplace_back(const_cast<OGRLayer&>(layer).GetName(), style);
}

// The table that QGIS reads styles from, with its columns. The time is that of all our files.
void GpkgFile::write_styles() {
  if (styles_.empty()) return;
  CPLStringList options;
  options.SetNameValue("ASPATIAL_VARIANT", "GPKG_ATTRIBUTES");
  OGRLayer* table = file_->CreateLayer("layer_styles", nullptr, wkbNone, options.List());
  if (table == nullptr) fail();
  for (const char* name :
       {"f_table_catalog", "f_table_schema", "f_table_name", "f_geometry_column", "styleName", "styleQML", "styleSLD"})
    add_field(*table, name, OFTString);
  add_field(*table, "useAsDefault", OFTInteger, OFSTBoolean);
  for (const char* name : {"description", "owner", "ui"}) add_field(*table, name, OFTString);
  add_field(*table, "update_time", OFTDateTime);
  for (const auto& [layer, style] : styles_) {
    OGRFeature feature(table->GetLayerDefn());
    for (const char* name : {"f_table_catalog", "f_table_schema", "styleSLD", "owner", "ui"})
      feature.SetField(name, "");
    feature.SetField("f_table_name", layer.c_str());
    feature.SetField("f_geometry_column", "geom");
    feature.SetField("styleName", style.name.c_str());
    feature.SetField("styleQML", layer_style_qml(style).c_str());
    feature.SetField("useAsDefault", 1);
    feature.SetField("description", "made by ilot");
    feature.SetField("update_time", 2000, 1, 1, 0, 0, 0.0f, 100);
    add(*table, feature);
  }
}

void GpkgFile::finish() {
  CPLErrorReset();
  write_styles();
  if (writing_ && file_->CommitTransaction() != OGRERR_NONE) fail();
  file_.reset();
  if (CPLGetLastErrorType() >= CE_Failure) fail();
  whole_ = true;
}

}  // namespace ilot
