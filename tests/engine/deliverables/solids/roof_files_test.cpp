// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/roof_files.h"

#include <gtest/gtest.h>

#include "engine/validity/validate_models.h"
#include "tests/support/buildings.h"
#include "tests/support/temporary_folder.h"

namespace ilot {
namespace {

ModelsValidity validity_of(const std::filesystem::path& path) {
  return validate_models(path, [&](const ObjectValidity& found) {
    for (const std::string& what : found.format) ADD_FAILURE() << path << ": " << found.id << ": " << what;
    for (const Fault& fault : found.faults)
      ADD_FAILURE() << path << ": " << found.id << ": " << fault.code << fault.where;
  });
}

TEST(RoofFiles, AllHoldTheSameValidBuildings) {
  for (const AttributeStyle style : {AttributeStyle::plain, AttributeStyle::roofer}) {
    const TemporaryFolder folder;
    CityJsonParams params{2154, {652000, 6862000, 0}, 0.0001, style, 1};
    Crs crs;
    crs.epsg = 2154;
    RoofFiles files(folder.path(), {params}, crs);
    Building low = gable_house("1", {652000.1, 6862000.2, 35}), court = court_house("2");
    low.lod = "1.2";
    low.attributes = {{"status", std::string("lod22")}, {"points", std::int64_t{7}}};
    for (Vec3& v : court.vertices) v = v + Vec3{652100, 6862000, 30};
    files.add(std::vector<Building>{low, gable_house("1", {652000.1, 6862000.2, 35})});
    files.add(std::vector<Building>{court});
    files.finish();
    for (const char* name : {"roofs.city.jsonl", "roofs.city.json", "roofs.obj"}) {
      EXPECT_TRUE(validity_of(folder.path() / name).valid()) << name;
      EXPECT_EQ(validity_of(folder.path() / name).objects, 2u) << name;
    }
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "roofs.gpkg"));
    EXPECT_TRUE(std::filesystem::exists(folder.path() / "roofs.mtl"));
  }
}

TEST(RoofFiles, TheSingleObjectIsLeftOutWhenItGrowsTooLarge) {
  const TemporaryFolder folder;
  RoofFiles files(folder.path(), {{}, 500}, {});
  files.add(std::vector<Building>{gable_house("1", {})});
  files.finish();
  EXPECT_FALSE(std::filesystem::exists(folder.path() / "roofs.city.json"));
  EXPECT_TRUE(std::filesystem::exists(folder.path() / "roofs.city.jsonl"));
}

}  // namespace
}  // namespace ilot
