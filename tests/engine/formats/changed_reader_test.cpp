// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/changed_reader.h"

#include "engine/formats/crs.h"
#include "engine/formats/crs_transform.h"
#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

std::unique_ptr<PointReader> cloud_of(const Folder& folder, const std::string& text, bool degrees = false) {
  spill_text(folder / "a.xyz", text);
  return open_cloud(folder / "a.xyz", {std::nullopt, degrees});
}

TEST(ChangedReader, HeightsAreInTheUnitOfPositionsAndRecordsStay) {
  const Folder folder;
  const auto plain = cloud_of(folder, "100 200 10\n101 201 20.5\n");
  const auto changed = with_heights_in_unit(cloud_of(folder, "100 200 10\n101 201 20.5\n"), 0.3048);
  const Rows before = read_all(*plain), after = read_all(*changed);
  EXPECT_EQ(after.bytes, before.bytes);
  EXPECT_NEAR(world(after, changed->info().layout, 1).z, 20.5 * 0.3048, 1e-9);
  EXPECT_EQ(world(after, changed->info().layout, 1).x, 101);
  EXPECT_EQ(reader_of_records(*changed).info().layout.scale, plain->info().layout.scale);
  EXPECT_EQ(&reader_of_records(*plain), plain.get());
}

// Paris, on the central meridian of the zone: easting 500 km; a hundredth of a second of latitude is 31 cm.
TEST(ChangedReader, DegreesAreMovedToTheZone) {
  const Folder folder;
  const Crs degrees = crs_from_epsg(4326), zone = utm_at(degrees, {3.0, 48.85, 40});
  EXPECT_EQ(zone.epsg, 32631);
  EXPECT_EQ(utm_at(degrees, {-70.6, -33.4, 0}).epsg, 32719);
  EXPECT_THROW(utm_at(degrees, {0, 88, 0}), Error);
  const auto moved =
      reprojected(cloud_of(folder, "3.000000000 48.850000000 40.125\n3.000001000 48.850001000 41\n", true), degrees,
                  zone, {3.0, 48.85, 40});
  const Rows rows = read_all(*moved);
  const Vec3 a = world(rows, moved->info().layout, 0), b = world(rows, moved->info().layout, 1);
  EXPECT_NEAR(a.x, 500000, 1e-4);
  EXPECT_EQ(a.z, 40.125) << "heights stay";
  EXPECT_NEAR(b.y - a.y, 0.1112, 0.0005);
  EXPECT_NEAR(b.x - a.x, 0.0733, 0.0005);
  EXPECT_EQ(moved->info().crs.epsg, 32631);
  const Vec3 north{500000, 5410000, 0};
  std::vector<Vec3> back{a};
  CrsTransform(zone, degrees).apply(back);
  EXPECT_NEAR(back[0].y, 48.85, 1e-8);
  EXPECT_GT(a.y, north.y - 20000);
}

TEST(ChangedReader, RowsWithoutAPlaceAreNotValid) {
  const Folder folder;
  const auto moved = reprojected(cloud_of(folder, "3 48.85 40\n3.1 48.9 41\n3 95 1\n", true), crs_from_epsg(4326),
                                 crs_from_epsg(32631), {3, 48.85, 40});
  EXPECT_EQ(read_all(*moved).valid, (std::vector<std::uint8_t>{1, 1, 0}));
}

TEST(ChangedReader, SaysAnotherCrsOfTheSameRecords) {
  const Folder folder;
  auto plain = cloud_of(folder, "3 48.85 40\n3.1 48.9 41\n", true);
  const PointReader* file = plain.get();
  const Rows before = read_all(*plain);
  const auto said = in_crs(std::move(plain), crs_from_epsg(2994));
  EXPECT_EQ(said->info().crs.epsg, 2994);
  EXPECT_EQ(read_all(*said).bytes, before.bytes);
  EXPECT_EQ(&reader_of_records(*said), said.get());
  EXPECT_EQ(&reader_of_file(*said), file);
}

TEST(ChangedReader, DegreesBeyondAnyAreNotBelieved) {
  EXPECT_FALSE(can_be_at(crs_from_epsg(4326), {515393, 4918000, 100}));
  EXPECT_TRUE(can_be_at(crs_from_epsg(4326), {3, 48, 100}));
  EXPECT_TRUE(can_be_at(crs_from_epsg(2154), {515393, 4918000, 100}));
  EXPECT_TRUE(can_be_at(crs_from_epsg(4978), {4198945, 174747, 4781887})) << "from the Earth's centre";
  EXPECT_FALSE(can_be_at(crs_from_epsg(4978), {515393, 4918000, 100}));
  // Lambert-93 in the south: as far from its origin as places are from the Earth's centre.
  EXPECT_FALSE(can_be_at(crs_from_epsg(4326), {770550, 6277550, 100}));
  EXPECT_FALSE(can_be_at(crs_from_epsg(4978), {770550, 6277550, 100}));
  EXPECT_FALSE(can_be_at(crs_from_epsg(4326), {4198945, 174747, 4781887})) << "these are no degrees";
  EXPECT_FALSE(can_be_at(crs_from_epsg(4978), {0, 0, 0}));
  for (const double height : {-400.0, 0.0, 8800.0}) {
    EXPECT_TRUE(can_be_at(crs_from_epsg(4978), {6378137 + height, 0, 0}));
    EXPECT_TRUE(can_be_at(crs_from_epsg(4978), {0, 0, -6356752.3 - height}));
  }
  EXPECT_FALSE(can_be_at(crs_from_epsg(4978), {6356752, 0, 0})) << "21 km below the equator";
}

TEST(ChangedReader, TheHorizontalPartOfACompoundCrs) {
  const Crs both = crs_from_text("EPSG:2154+8228");  // NAVD88 height (ft)
  EXPECT_NEAR(both.metres_per_unit_z, 0.3048, 1e-6);
  const Crs plan = horizontal_crs(both);
  EXPECT_EQ(plan.epsg, 2154);
  EXPECT_EQ(plan.metres_per_unit_z, 1);
  EXPECT_EQ(plan.wkt.find("COMPD"), std::string::npos);
}

}  // namespace
}  // namespace ilot
