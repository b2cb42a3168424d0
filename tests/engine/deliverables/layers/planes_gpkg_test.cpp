// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/layers/planes_gpkg.h"

#include <gtest/gtest.h>
#include <ogrsf_frmts.h>

#include "engine/error.h"
#include "tests/support/file_bytes.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

Segment segment(std::uint32_t id) {
  Segment s;
  s.id = id;
  s.content_id = 0xfedcba9876543210ull + id;
  s.plane = {{0, 0, 1}, -7.25};
  s.points = 5000000000ull;
  s.epsilon_m = 0.02;
  s.rms_m = 0.01;
  return s;
}

// A square with a hole, and a triangle, at national coordinates.
Outline outline(std::uint32_t id) {
  const auto at = [](double x, double y) { return Vec3{652000.125 + x, 6862000.5 + y, 7.25}; };
  return {id,
          {{{at(0, 0), at(9, 0), at(9, 9), at(0, 9)}, {at(3, 3), at(3, 6), at(6, 6), at(6, 3)}},
           {{at(20, 0), at(25, 0), at(20, 5)}}}};
}

void write_planes(const std::filesystem::path& path, const Crs& crs) {
  PlanesGpkg file(path, crs);
  file.add(segment(1), outline(1));
  file.add(segment(2), {2, {}});
  file.finish();
}

TEST(PlanesGpkg, ReadsBackAsItWasGiven) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "planes.gpkg";
  Crs crs;
  crs.epsg = 2154;
  write_planes(path, crs);
  const GDALDatasetUniquePtr file(GDALDataset::Open(path.c_str(), GDAL_OF_VECTOR));
  ASSERT_TRUE(file);
  OGRLayer* layer = file->GetLayerByName("planes");
  ASSERT_NE(layer, nullptr);
  ASSERT_NE(layer->GetSpatialRef(), nullptr);
  EXPECT_STREQ(layer->GetSpatialRef()->GetAuthorityCode(nullptr), "2154");
  ASSERT_EQ(layer->GetFeatureCount(), 2);
  const OGRFeatureUniquePtr first(layer->GetNextFeature()), second(layer->GetNextFeature());
  EXPECT_EQ(first->GetFieldAsInteger64("plane_id"), 1);
  EXPECT_EQ(first->GetFieldAsInteger64("points"), 5000000000);
  EXPECT_STREQ(first->GetFieldAsString("content_id"), "fedcba9876543211");
  EXPECT_EQ(first->GetFieldAsDouble("d"), -7.25);
  const OGRMultiPolygon* parts = first->GetGeometryRef()->toMultiPolygon();
  ASSERT_EQ(parts->getNumGeometries(), 2);
  const OGRPolygon* square = parts->getGeometryRef(0);
  ASSERT_EQ(square->getNumInteriorRings(), 1);
  EXPECT_EQ(square->get_Area(), 72);
  EXPECT_EQ(square->getExteriorRing()->getNumPoints(), 5);
  EXPECT_EQ(square->getExteriorRing()->getX(1), 652009.125);
  EXPECT_EQ(square->getExteriorRing()->getZ(1), 7.25);
  EXPECT_TRUE(parts->IsValid());
  EXPECT_EQ(second->GetGeometryRef()->toMultiPolygon()->getNumGeometries(), 0);
}

TEST(PlanesGpkg, SameBytesEveryTime) {
  const TemporaryFolder folder;
  write_planes(folder.path() / "a.gpkg", {});
  write_planes(folder.path() / "b.gpkg", {});
  EXPECT_EQ(test::file_bytes(folder.path() / "a.gpkg"), test::file_bytes(folder.path() / "b.gpkg"));
}

TEST(PlanesGpkg, LeavesNothingHalfWritten) {
  const TemporaryFolder folder;
  const auto path = folder.path() / "planes.gpkg";
  {
    PlanesGpkg file(path, {});
    file.add(segment(1), outline(1));
  }
  EXPECT_FALSE(std::filesystem::exists(path));
  EXPECT_THROW(PlanesGpkg(folder.path() / "no such folder" / "planes.gpkg", {}), Error);
}

}  // namespace
}  // namespace ilot
