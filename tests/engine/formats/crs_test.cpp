// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/crs.h"

#include "tests/engine/formats/fixtures.h"

namespace ilot {
namespace {

using namespace test;

Vlr text_record(const std::string& user, std::uint16_t id, const std::string& text) {
  Vlr vlr;
  vlr.user_id = user;
  vlr.record_id = id;
  const auto* p = reinterpret_cast<const std::byte*>(text.data());
  vlr.payload.assign(p, p + text.size());
  return vlr;
}

Vlr keys(std::vector<std::array<int, 2>> entries) {
  std::vector<int> words{1, 1, 0, static_cast<int>(entries.size())};
  for (const auto& [id, value] : entries) words.insert(words.end(), {id, 0, 1, value});
  Vlr vlr = text_record("LASF_Projection", 34735, "");
  for (const int word : words) {
    vlr.payload.push_back(static_cast<std::byte>(word & 255));
    vlr.payload.push_back(static_cast<std::byte>(word >> 8));
  }
  return vlr;
}

TEST(Crs, EpsgCodesGiveUnits) {
  EXPECT_EQ(crs_from_epsg(2154).metres_per_unit, 1);
  EXPECT_FALSE(crs_from_epsg(2154).unit_assumed);
  EXPECT_EQ(crs_from_epsg(2154).epsg, 2154);
  EXPECT_NEAR(crs_from_epsg(2994).metres_per_unit, 0.3048, 1e-12);
  EXPECT_TRUE(crs_from_epsg(4326).geographic);
  const Crs compound = crs_from_text("EPSG:2154+5720");
  EXPECT_EQ(compound.epsg, 2154);
  EXPECT_EQ(compound.metres_per_unit_z, 1);
  EXPECT_THROW(crs_from_epsg(1), Error);
  EXPECT_THROW(crs_from_text("nonsense"), Error);
  EXPECT_THROW(crs_from_text("EPSG:5720 trailing"), Error);
  EXPECT_THROW(crs_from_text("RGF93 / Lambert-93"), Error);  // names are not looked up
  EXPECT_EQ(crs_from_text("epsg:2154").epsg, 2154);
}

// A grid that is bound to the heights leaves their unit as it is.
TEST(Crs, HeightsInFeetWithAGrid) {
  const std::string feet =
      R"(VERT_CS["NAVD88 height in feet",VERT_DATUM["North American Vertical Datum 1988",2005,)"
      R"(EXTENSION["PROJ4_GRIDS","g2012a_conus.gtx"],AUTHORITY["EPSG","5103"]],)"
      R"(UNIT["US survey foot",0.304800609601219,AUTHORITY["EPSG","9003"]],AXIS["Up",UP],AUTHORITY["EPSG","6360"]])";
  const std::string plan =
      R"(PROJCS["metres",GEOGCS["NAD83",DATUM["North_American_Datum_1983",SPHEROID["GRS 1980",6378137,298.257222101]],)"
      R"(PRIMEM["Greenwich",0],UNIT["degree",0.0174532925199433]],PROJECTION["Transverse_Mercator"],)"
      R"(PARAMETER["latitude_of_origin",0],PARAMETER["central_meridian",-93],PARAMETER["scale_factor",0.9996],)"
      R"(PARAMETER["false_easting",500000],PARAMETER["false_northing",0],UNIT["metre",1]])";
  const Crs crs = crs_from_text("COMPD_CS[\"metres and feet\"," + plan + "," + feet + "]");
  EXPECT_EQ(crs.metres_per_unit, 1);
  EXPECT_NEAR(crs.metres_per_unit_z, 0.304800609601219, 1e-12);
}

TEST(Crs, NothingKnownAssumesMetres) {
  std::vector<std::string> warnings;
  const Crs crs = crs_from_vlrs({}, true, warnings);
  EXPECT_TRUE(crs.unit_assumed);
  EXPECT_EQ(crs.metres_per_unit, 1);
  EXPECT_TRUE(warnings.empty());
}

TEST(Crs, WktIsTakenFromAnyHomeAndKeptVerbatim) {
  const std::string wkt = crs_from_epsg(2154).wkt;
  for (const bool flag : {true, false}) {
    for (const Vlr& vlr : {text_record("LASF_Projection", 2112, wkt), text_record("liblas", 2112, wkt + '\0'),
                           text_record("Pix4D", 4224, wkt)}) {
      std::vector<std::string> warnings;
      const Crs crs = crs_from_vlrs({text_record("LASF_Projection", 2112, ""), vlr}, flag, warnings);
      EXPECT_EQ(crs.epsg, 2154);
      EXPECT_EQ(crs.wkt, wkt);
      EXPECT_EQ(warnings.size(), flag ? 0u : 1u) << "a wrong flag is a warning";
    }
  }
}

TEST(Crs, GeoTiffKeysGiveCodesAndUnits) {
  std::vector<std::string> warnings;
  EXPECT_EQ(crs_from_vlrs({keys({{3072, 28992}})}, false, warnings).epsg, 28992);
  const Crs compound = crs_from_vlrs({keys({{1024, 1}, {3072, 28992}, {4096, 5709}})}, false, warnings);
  EXPECT_NE(compound.name.find("NAP"), std::string::npos);
  EXPECT_TRUE(crs_from_vlrs({keys({{1024, 2}, {2048, 4326}})}, false, warnings).geographic);
  const Crs feet = crs_from_vlrs({keys({{1024, 1}, {3072, 32767}, {3076, 9003}})}, false, warnings);
  EXPECT_NEAR(feet.metres_per_unit, 1200.0 / 3937, 1e-12);
  EXPECT_NEAR(feet.metres_per_unit_z, 1200.0 / 3937, 1e-12);
  EXPECT_FALSE(feet.unit_assumed);
  EXPECT_NEAR(crs_from_vlrs({keys({{3072, 2154}, {4099, 9002}})}, false, warnings).metres_per_unit_z, 0.3048, 1e-12);
  EXPECT_TRUE(warnings.empty());
  const Crs mixed = crs_from_vlrs({keys({{3072, 26995}, {3076, 9003}})}, false, warnings);
  EXPECT_NEAR(mixed.metres_per_unit, 1200.0 / 3937, 1e-12);
  EXPECT_EQ(mixed.epsg, 0);
  EXPECT_EQ(warnings.size(), 1u);
}

TEST(Crs, RecordsSayWhatWasMeant) {
  for (const int code : {2154, 4326}) {
    for (const bool wkt : {true, false}) {
      std::vector<std::string> warnings;
      const std::vector<Vlr> records = crs_records(crs_from_epsg(code), wkt);
      ASSERT_EQ(records.size(), 1u);
      EXPECT_EQ(crs_from_vlrs(records, wkt, warnings).epsg, code);
      EXPECT_TRUE(warnings.empty());
    }
  }
  EXPECT_TRUE(crs_records(Crs{}, true).empty());
}

TEST(Crs, KeysSayHeightsToo) {
  std::vector<std::string> warnings;
  const Crs feet = crs_from_text("EPSG:2154+8228");  // NAVD88 height (ft)
  const Crs read = crs_from_vlrs(crs_records(feet, false), false, warnings);
  EXPECT_EQ(read.epsg, 2154);
  EXPECT_EQ(read.metres_per_unit_z, feet.metres_per_unit_z);
  EXPECT_EQ(read.wkt, feet.wkt);
  const Crs of_one_code = crs_from_vlrs(crs_records(crs_from_epsg(7415), false), false, warnings);  // 28992 + 5709
  EXPECT_EQ(of_one_code.wkt.substr(0, 8), "COMPD_CS");
  Crs own;
  own.wkt = "LOCAL_CS[\"own\",UNIT[\"metre\",1]]";
  EXPECT_TRUE(crs_records(own, false).empty());
  EXPECT_TRUE(warnings.empty());
}

TEST(Crs, ReplacingGoesThroughTheFile) {
  const Folder folder;
  CloudSpec spec;
  spec.like.vlrs = {keys({{3072, 28992}}), text_record("liblas", 2112, "x"), text_record("other", 1, "kept")};
  replace_crs(spec.like, crs_from_epsg(2154));
  const auto writer = create_cloud(folder / "a.las", spec);
  writer->finish();
  const CloudInfo info = open_cloud(folder / "a.las")->info();
  EXPECT_EQ(info.crs.epsg, 2154);
  EXPECT_EQ(info.vlrs.size(), 2u);
  EXPECT_TRUE(info.warnings.empty());
}

TEST(Crs, WithoutACodeNeedsLas14) {
  const Folder folder;
  const Crs foot = crs_from_text(
      "PROJCS[\"of this place\",GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
      "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]],PROJECTION[\"Transverse_Mercator\"],"
      "PARAMETER[\"latitude_of_origin\",47.3],PARAMETER[\"central_meridian\",4.1],PARAMETER[\"scale_factor\",1],"
      "PARAMETER[\"false_easting\",651000],PARAMETER[\"false_northing\",6861000],UNIT[\"foot\",0.3048]]");
  ASSERT_EQ(foot.epsg, 0);
  for (const auto& [crs, minor] : {std::pair{foot, 4}, std::pair{crs_from_epsg(2994), 2}}) {
    CloudSpec spec;
    spec.like.header.resize(227);
    spec.like.version_minor = 2;
    spec.like.layout.point_format = 0;
    spec.like.layout.record_length = 20;
    replace_crs(spec.like, crs);
    create_cloud(folder / "a.las", spec)->finish();
    const CloudInfo info = open_cloud(folder / "a.las")->info();
    EXPECT_EQ(info.version_minor, minor);
    EXPECT_NEAR(info.crs.metres_per_unit, 0.3048, 1e-12);
    EXPECT_TRUE(info.warnings.empty());
    EXPECT_EQ(info.vlrs.size(), 1u);
  }
}

TEST(Crs, DamagedRecordsAreNoCrs) {
  Rng rng(5);
  for (int round = 0; round < 300; ++round) {
    Vlr vlr = keys({{1024, 1}, {3072, 28992}, {4096, 5709}, {3076, 9003}, {4099, 9001}});
    for (int i = 0; i < 4; ++i) vlr.payload[rng.below(vlr.payload.size())] = static_cast<std::byte>(rng.below(256));
    vlr.payload.resize(rng.below(vlr.payload.size() + 1));
    std::vector<std::string> warnings;
    const Crs crs = crs_from_vlrs({vlr, text_record("LASF_Projection", 2112, "PROJCS[\"x\"")}, round % 2, warnings);
    EXPECT_GT(crs.metres_per_unit, 0);
    EXPECT_GT(crs.metres_per_unit_z, 0);
  }
}

}  // namespace
}  // namespace ilot
