// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/street_training.h"

#include <gtest/gtest.h>

#include <map>
#include <utility>

#include "engine/error.h"
#include "ilot/streets.h"
#include "tests/engine/products/streets/street_runs.h"

namespace ilot {
namespace {

using nlohmann::json;
using test::run_cloud;
using test::street_points;
using test::StreetsOutcome;

std::vector<std::pair<std::string, PointLabel>> classes_of(const std::filesystem::path& out) {
  std::vector<std::pair<std::string, PointLabel>> all;
  for (const StreetObject& o : read_streets(out).objects) all.emplace_back(o.class_name, o.label);
  return all;
}

std::string place(double x, double y, const std::string& name) {
  std::ostringstream out;
  out.precision(12);
  out << R"({"type":"Feature","properties":{"class":")" << name << R"("},"geometry":{"type":"Point","coordinates":[)"
      << x << "," << y << "]}}";
  return out.str();
}

std::string collection(const std::string& features) {
  return R"({"type":"FeatureCollection","crs":{"type":"name","properties":{"name":"urn:ogc:def:crs:EPSG::2154"}},)"
         R"("features":[)" +
         features + "]}";
}

TEST(StreetTraining, LearnsFromPlaces) {
  const TemporaryFolder folder;
  std::string features = place(900000, 660001, "car");
  for (int b = 0; b < 3; ++b) features += "," + place(700005 + 6 * b, 660003.8, b == 0 ? "car" : "other");
  features += "," + place(700005.01, 660003.8, "car");
  const auto train = folder.put("labels.geojson", collection(features));
  EXPECT_THROW(run_cloud(folder, street_points(2, 3), "one", [&](RunOptions& o) { o.train = train; }), Error)
      << "one object of a class is too little";
}

struct TestObject {
  std::int64_t x, y, length, width, height;  // millimetres
  const char* name;
};

const std::vector<TestObject>& test_objects() {
  static const std::vector<TestObject> list{
      {1500, 2500, 4000, 1700, 1400, "car"},    {8500, 2500, 4200, 1800, 1500, "car"},
      {2000, 8000, 200, 200, 5000, "lamppost"}, {8000, 8000, 200, 200, 5500, "lamppost"},
      {15000, 8000, 600, 700, 1100, "other"},   {20000, 8000, 700, 600, 1000, "other"},
      {16000, 2500, 4100, 1700, 1450, "car"},   {12000, 8000, 250, 200, 5200, "lamppost"},
      {17500, 8000, 600, 600, 1050, "other"}};
  return list;
}

// The street with the objects as boxes: their tops, and their sides down to the ground.
std::vector<Index3> points_of_objects() {
  constexpr std::int64_t kSide = 60, kStep = 50;  // millimetres: what counts as a side, and between its points
  std::vector<Index3> points = street_points(1, 0), sides;
  for (Index3& p : points)
    for (const TestObject& s : test_objects()) {
      const std::int64_t x = p.x - 700000000 - s.x, y = p.y - 660000000 - s.y;
      if (x < 0 || x >= s.length || y < 0 || y >= s.width) continue;
      if (x < kSide || y < kSide || s.length - x <= kSide || s.width - y <= kSide)
        for (std::int64_t z = 0; z < s.height; z += kStep) sides.push_back({p.x, p.y, p.z + z});
      p.z += s.height;
    }
  points.insert(points.end(), sides.begin(), sides.end());
  return points;
}

// The places of the test objects, with the classes that `called` gives to theirs.
std::string places_of_objects(const std::function<std::string(const std::string&)>& called) {
  std::string features;
  for (const TestObject& s : test_objects())
    features +=
        (features.empty() ? "" : ",") + place(700000 + 0.001 * static_cast<double>(s.x + s.length / 2),
                                              660000 + 0.001 * static_cast<double>(s.y + s.width / 2), called(s.name));
  return features;
}

// Names that are none of ours are classes of one's own, with labels from 100 on in the order of their names. One that
// has a single object is left out, and takes no number. The model that is written gives the same.
TEST(StreetTraining, ClassesOfOnesOwn) {
  bool first = true;
  const std::string features = places_of_objects([&](const std::string& name) {
    if (name == "car") return std::string("véhicule");
    if (name == "other") return std::exchange(first, false) ? std::string("armoire") : std::string("hydrant");
    return name;
  });
  const TemporaryFolder folder;
  const auto train = folder.put("labels.geojson", collection(features));
  const StreetsOutcome out = run_cloud(folder, points_of_objects(), "out", [&](RunOptions& o) { o.train = train; });
  std::map<std::string, int> labels;
  std::uint64_t samples = 0;
  for (const auto& c : out.record["training"]) {
    labels[c["class"]] = c["label"];
    samples += c["samples"].get<std::uint64_t>();
    EXPECT_LE(c["right"].get<std::uint64_t>(), c["judged"].get<std::uint64_t>());
  }
  EXPECT_EQ(labels, (std::map<std::string, int>{{"lamppost", 11}, {"hydrant", 100}, {"véhicule", 101}}));
  EXPECT_EQ(samples, test_objects().size() - 1);
  EXPECT_NE(out.record["warnings"].dump().find("armoire is left out"), std::string::npos)
      << out.record["warnings"].dump();
  EXPECT_EQ(out.record["warnings"].dump().find("contains no"), std::string::npos)
      << "one's own need not be all of ours";
  std::map<std::string, int> found;
  for (const StreetObject& o : read_streets(out.out).objects) {
    ASSERT_TRUE(labels.contains(o.class_name)) << o.class_name;
    EXPECT_EQ(static_cast<int>(o.label), labels[o.class_name]);
    ++found[o.class_name];
  }
  EXPECT_GE(found["véhicule"], 2);
  EXPECT_NE(test::file_bytes(out.out / "streets" / "streets.svg").find("véhicule"), std::string::npos);
  const auto again = run_cloud(folder, points_of_objects(), "again", [&](RunOptions& o) {
    o.train = folder.put("own.model", test::file_bytes(out.out / "streets" / "objects.model"));
  });
  EXPECT_EQ(classes_of(out.out), classes_of(again.out));
  EXPECT_TRUE(again.record.value("training", json::array()).empty());
}

// Labels without a class, and one outside the cloud: it is said, and nothing is called that.
TEST(StreetTraining, ThreeClassesInsteadOfFour) {
  const std::vector<Index3> points = points_of_objects();
  std::string features = places_of_objects([](const std::string& name) { return name; });
  features += "," + place(900000, 660001, "car");
  const TemporaryFolder folder;
  const auto train = folder.put("labels.geojson", collection(features));
  const StreetsOutcome out = run_cloud(folder, points, "out", [&](RunOptions& o) { o.train = train; });
  ASSERT_FALSE(out.record["warnings"].empty());
  EXPECT_NE(out.record["warnings"].dump().find("contains no pedestrian"), std::string::npos)
      << out.record["warnings"].dump();
  EXPECT_NE(out.record["warnings"].dump().find("1 of its 10 places are on nothing"), std::string::npos)
      << out.record["warnings"].dump();
  EXPECT_GT(std::filesystem::file_size(out.out / "streets" / "objects.model"), 0u);

  // The same model in the words of version 2 says the same, with a warning.
  std::string old = test::file_bytes(out.out / "streets" / "objects.model");
  ASSERT_TRUE(old.starts_with("ilot objects 3\n"));
  const auto again = run_cloud(folder, points, "again", [&](RunOptions& o) { o.train = folder.put("new.model", old); });
  old = "ilot things 2" + old.substr(std::string("ilot objects 3").size());
  const auto older = run_cloud(folder, points, "older", [&](RunOptions& o) { o.train = folder.put("old.model", old); });
  EXPECT_EQ(again.record["result_hash"], older.record["result_hash"]);
  EXPECT_EQ(again.record["warnings"].dump().find("version 2"), std::string::npos);
  EXPECT_NE(older.record["warnings"].dump().find("version 2"), std::string::npos);
}

TEST(StreetTraining, PlacesOutsideTheCloudAreRefused) {
  const TemporaryFolder folder;
  const auto outside = folder.put("outside.geojson", collection(place(1, 1, "car") + "," + place(2, 2, "other")));
  const auto unknown = folder.put("unknown.geojson", collection(place(700005, 660003.8, "wall")));
  const auto broken = folder.put("broken.geojson", collection(place(700005, 660003.8, "a <b>")));
  for (const auto& [file, part] : {std::pair{outside, "none of its 2 places"},
                                   {unknown, "'wall' is no class of objects"},
                                   {broken, "'a <b>' is no name of a class"}}) {
    try {
      run_cloud(folder, street_points(2, 3), "out", [&, f = file](RunOptions& o) { o.train = f; });
      FAIL() << part;
    } catch (const Error& e) {
      EXPECT_EQ(e.code(), ExitCode::usage);
      EXPECT_NE(std::string(e.what()).find(part), std::string::npos) << e.what();
    }
    std::filesystem::remove_all(folder.path() / "out");
  }
}

}  // namespace
}  // namespace ilot
