// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/roofs_gpkg.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include <fstream>
#include <iterator>

#include "engine/error.h"
#include "tests/support/buildings.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

std::vector<Building> court() {
  Building b = court_house("court");
  b.attributes = {{"status", std::string("lod22")},
                  {"points", std::int64_t{3000000000}},
                  {"h_ground", 35.25},
                  {"volume_lod22_m3", 336.0}};
  return {b};
}

void write_roofs(const std::filesystem::path& path, AttributeStyle style) {
  Crs crs;
  crs.epsg = 2154;
  RoofsGpkg file(path, crs, style, 1);
  file.add(std::vector<Building>{gable_house("gable", {652000, 6862000, 35})});
  file.add(court());
  file.finish();
}

TEST(RoofsGpkg, ReadsBackAsItWasGiven) {
  const TemporaryFolder folder;
  write_roofs(folder.path() / "roofs.gpkg", AttributeStyle::plain);
  const GDALDatasetUniquePtr file(GDALDataset::Open((folder.path() / "roofs.gpkg").c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(file);
  OGRLayer* buildings = file->GetLayerByName("buildings");
  OGRLayer* faces = file->GetLayerByName("roof_faces");
  ASSERT_TRUE(buildings && faces);
  EXPECT_STREQ(buildings->GetSpatialRef()->GetAuthorityCode(nullptr), "2154");
  ASSERT_EQ(buildings->GetFeatureCount(), 2);
  ASSERT_EQ(faces->GetFeatureCount(), 3);
  const OGRFeatureUniquePtr gable(buildings->GetNextFeature()), other(buildings->GetNextFeature());
  EXPECT_STREQ(gable->GetFieldAsString("id"), "gable");
  EXPECT_FALSE(gable->IsFieldSet(gable->GetFieldIndex("h_ground")) &&
               !gable->IsFieldNull(gable->GetFieldIndex("h_ground")));
  EXPECT_EQ(gable->GetGeometryRef()->toMultiPolygon()->get_Area(), 80);
  EXPECT_TRUE(gable->GetGeometryRef()->IsValid());
  EXPECT_EQ(other->GetFieldAsInteger64("points"), 3000000000);
  EXPECT_EQ(other->GetFieldAsDouble("h_ground"), 35.25);
  EXPECT_EQ(other->GetGeometryRef()->toMultiPolygon()->get_Area(), 84) << "without its court";
  const OGRFeatureUniquePtr south(faces->GetNextFeature());
  EXPECT_STREQ(south->GetFieldAsString("building"), "gable");
  EXPECT_EQ(south->GetFieldAsInteger64("plane_id"), 1);
  EXPECT_NEAR(south->GetFieldAsDouble("slope_deg"), 36.8699, 1e-4);
  EXPECT_NEAR(south->GetFieldAsDouble("azimuth_deg"), 180, 1e-9);
  EXPECT_NEAR(south->GetFieldAsDouble("area_m2"), 50, 1e-9);
  OGREnvelope3D box;
  south->GetGeometryRef()->getEnvelope(&box);
  EXPECT_EQ(box.MaxZ, 41);
}

TEST(RoofsGpkg, HasRoofersColumnsInItsStyle) {
  const TemporaryFolder folder;
  write_roofs(folder.path() / "roofs.gpkg", AttributeStyle::roofer);
  const GDALDatasetUniquePtr file(GDALDataset::Open((folder.path() / "roofs.gpkg").c_str(), GDAL_OF_VECTOR));
  OGRLayer* buildings = file->GetLayerByName("buildings");
  const OGRFeatureUniquePtr gable(buildings->GetNextFeature()), other(buildings->GetNextFeature());
  EXPECT_EQ(other->GetFieldAsInteger("rf_success"), 1);
  EXPECT_EQ(other->GetFieldAsDouble("rf_h_ground"), 35.25);
  EXPECT_EQ(other->GetFieldIndex("h_ground"), -1);
  EXPECT_EQ(other->GetFieldAsDouble("rf_volume_lod22"), 336);
  EXPECT_GE(file->GetLayerByName("roof_faces")->GetLayerDefn()->GetFieldIndex("rf_azimuth"), 0);
}

TEST(RoofsGpkg, SameBytesEveryTimeAndNothingUnfinished) {
  const TemporaryFolder folder;
  write_roofs(folder.path() / "a.gpkg", AttributeStyle::plain);
  write_roofs(folder.path() / "b.gpkg", AttributeStyle::plain);
  const auto bytes = [&](const char* name) {
    std::ifstream file(folder.path() / name, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(file), {});
  };
  EXPECT_EQ(bytes("a.gpkg"), bytes("b.gpkg"));
  {
    RoofsGpkg file(folder.path() / "c.gpkg", {}, AttributeStyle::plain, 1);
    file.add(court());
  }
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "c.gpkg"));
  EXPECT_THROW(RoofsGpkg(folder.path() / "none" / "d.gpkg", {}, AttributeStyle::plain, 1), Error);
}

}  // namespace
}  // namespace ilot
