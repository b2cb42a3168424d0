// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/planes_gpkg.h"

#include <cpl_conv.h>
#include <fmt/format.h>
#include <ogrsf_frmts.h>

#include "engine/deliverables/spatial_reference.h"
#include "engine/error.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr int kFeaturesPerTransaction = 4096;

void keep_silent(CPLErr, CPLErrorNum, const char*) {}

void add_field(OGRLayer& layer, const char* name, OGRFieldType type) {
  OGRFieldDefn field(name, type);
  layer.CreateField(&field);
}

OGRMultiPolygon geometry_of(const Outline& outline) {
  OGRMultiPolygon all;
  all.set3D(true);
  for (const Outline::Part& part : outline.parts) {
    OGRPolygon polygon;
    polygon.set3D(true);
    for (const Outline::Ring& ring : part) {
      OGRLinearRing closed;
      for (const Vec3& p : ring) closed.addPoint(p.x, p.y, p.z);
      closed.closeRings();
      polygon.addRing(&closed);
    }
    all.addGeometry(&polygon);
  }
  return all;
}

}  // namespace

struct PlanesGpkg::Layer {
  fs::path path;
  GDALDatasetUniquePtr file;
  OGRLayer* layer = nullptr;
  int pending = 0;
  bool whole = false;

  [[noreturn]] void fail() const { throw Error(path.string() + ": cannot be written: " + CPLGetLastErrorMsg()); }
};

PlanesGpkg::PlanesGpkg(const fs::path& path, const Crs& crs) : layer_(std::make_unique<Layer>()) {
  layer_->path = path;
  CPLSetErrorHandler(keep_silent);
  CPLSetConfigOption("OGR_CURRENT_DATE", "2000-01-01T00:00:00.000Z");
  RegisterOGRGeoPackage();
  GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GPKG");
  layer_->file.reset(driver->Create(path.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
  if (!layer_->file) layer_->fail();
  const auto reference = spatial_reference(crs);
  layer_->layer = layer_->file->CreateLayer("planes", reference.get(), wkbMultiPolygon25D, nullptr);
  if (layer_->layer == nullptr) layer_->fail();
  add_field(*layer_->layer, "plane_id", OFTInteger64);
  add_field(*layer_->layer, "content_id", OFTString);
  add_field(*layer_->layer, "points", OFTInteger64);
  for (const char* name :
       {"nx", "ny", "nz", "d", "epsilon_m", "rms_m", "area_m2", "level_m", "up_m", "normal_spread_deg", "confidence"})
    add_field(*layer_->layer, name, OFTReal);
  add_field(*layer_->layer, "colour_class", OFTInteger);
  add_field(*layer_->layer, "neighbours", OFTInteger64);
  if (layer_->file->StartTransaction() != OGRERR_NONE) layer_->fail();
}

PlanesGpkg::~PlanesGpkg() {
  if (layer_->whole) return;
  layer_->file.reset();
  std::error_code ignored;
  fs::remove(layer_->path, ignored);
}

void PlanesGpkg::add(const Segment& s, const Outline& outline) {
  OGRFeature feature(layer_->layer->GetLayerDefn());
  feature.SetField("plane_id", static_cast<GIntBig>(s.id));
  feature.SetField("content_id", fmt::format("{:016x}", s.content_id).c_str());
  feature.SetField("points", static_cast<GIntBig>(s.points));
  feature.SetField("nx", s.plane.n.x);
  feature.SetField("ny", s.plane.n.y);
  feature.SetField("nz", s.plane.n.z);
  feature.SetField("d", s.plane.d);
  feature.SetField("epsilon_m", s.epsilon_m);
  feature.SetField("rms_m", s.rms_m);
  feature.SetField("area_m2", s.area_m2);
  feature.SetField("level_m", s.level_m);
  feature.SetField("up_m", s.up_m);
  feature.SetField("normal_spread_deg", s.normal_spread_deg);
  feature.SetField("confidence", s.confidence);
  feature.SetField("colour_class", static_cast<int>(s.colour_class));
  feature.SetField("neighbours", static_cast<GIntBig>(s.neighbours));
  OGRMultiPolygon geometry = geometry_of(outline);
  feature.SetGeometry(&geometry);
  if (layer_->layer->CreateFeature(&feature) != OGRERR_NONE) layer_->fail();
  if (++layer_->pending < kFeaturesPerTransaction) return;
  layer_->pending = 0;
  if (layer_->file->CommitTransaction() != OGRERR_NONE || layer_->file->StartTransaction() != OGRERR_NONE)
    layer_->fail();
}

void PlanesGpkg::finish() {
  CPLErrorReset();
  if (layer_->file->CommitTransaction() != OGRERR_NONE) layer_->fail();
  layer_->file.reset();
  if (CPLGetLastErrorType() >= CE_Failure) layer_->fail();
  layer_->whole = true;
}

}  // namespace ilot
