// SPDX-License-Identifier: Apache-2.0
// Planes of real roofs and facades, against labels that others gave them.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <fstream>
#include <map>
#include <sstream>

#include "engine/compare/planes/plane_matching.h"
#include "engine/products/planes/join/label_pass.h"
#include "tests/engine/formats/fixtures.h"
#include "tests/support/plane_store.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr double kRoofShare = 0.93;  // of the points that carry their face

struct Labelled {
  std::vector<Index3> points;         // millimetres
  std::vector<std::uint32_t> labels;  // 0 = not judged
};

Index3 point_of(const std::string& line) {
  std::istringstream in(line);
  double x = 0, y = 0, z = 0;
  in >> x >> y >> z;
  return {std::llround(1000 * x), std::llround(1000 * y), std::llround(1000 * z)};
}

// Points of both, in global order: true label, found plane.
LabelPairs compare(const Labelled& scene) {
  std::vector<std::size_t> order(scene.points.size());
  for (std::size_t i = 0; i < order.size(); ++i) order[i] = i;
  std::stable_sort(order.begin(), order.end(),
                   [&](std::size_t a, std::size_t b) { return key_of(scene.points[a]) < key_of(scene.points[b]); });
  const test::PlaneStore s(scene.points);
  label_pass(s.cloud.store(), s.cells, s.found, s.joined, {});
  const auto plane = test::whole_column(s.cloud.store(), columns::kPlane);
  LabelPairs pairs;
  for (std::size_t i = 0; i < order.size(); ++i) pairs.add(scene.labels[order[i]], plane[i]);
  return pairs;
}

// RoofN3D (Wichmann et al. 2018): label 5 is what no face has.
TEST(RealPlanes, RoofsOfRoofN3d) {
  ILOT_DATA_OR_SKIP(data);
  std::uint64_t points = 0, carrying = 0, faces = 0, matched = 0;
  for (const fs::directory_entry& entry : fs::recursive_directory_iterator(data / "roofs/roofn3d")) {
    fs::path labels = entry.path();
    if (labels.extension() != ".pts" || !fs::exists(labels.replace_extension(".seg"))) continue;
    Labelled roof;
    std::ifstream where(entry.path()), what(labels);
    std::uint32_t label = 0;
    // Somewhere in a cell, as a roof in a town is, not on the corner of eight.
    for (std::string line; std::getline(where, line) && what >> label; roof.labels.push_back(label % 5)) {
      const Index3 p = point_of(line);
      roof.points.push_back({p.x + 16000, p.y + 16000, p.z + 16000});
    }
    const PlaneMatching m = match_planes(compare(roof).sorted());
    points += m.points;
    carrying += m.carrying;
    faces += m.true_planes;
    matched += m.matches.size();
  }
  EXPECT_EQ(faces, 64u);
  EXPECT_GE(matched, 62u);
  EXPECT_GT(static_cast<double>(carrying), kRoofShare * static_cast<double>(points)) << carrying << " of " << points;
}

// NUIST facades (Zang et al. 2024): a file an element.
void expect_a_wall(const fs::path& folder) {
  Labelled facade;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    std::ifstream in(entry.path());
    const bool wall = entry.path().filename().string().starts_with("wall");
    for (std::string line; std::getline(in, line);) {
      if (line.size() < 6) continue;
      facade.points.push_back(point_of(line));
      facade.labels.push_back(wall ? 1 : 2);
    }
  }
  std::uint64_t of_wall = 0, of_openings = 0;  // in planes that the wall has most points of
  std::uint64_t walls = 0, openings = 0, largest = 0;
  std::map<std::uint32_t, std::array<std::uint64_t, 2>> by_plane;
  for (const LabelPair& p : compare(facade).sorted()) {
    (p.truth == 1 ? walls : openings) += p.points;
    if (p.found != 0) by_plane[p.found][p.truth - 1] += p.points;
  }
  for (const auto& [plane, n] : by_plane) {
    if (n[0] <= n[1]) continue;
    of_wall += n[0];
    of_openings += n[1];
    largest = std::max(largest, n[0]);
  }
  EXPECT_GT(static_cast<double>(of_wall), 0.95 * static_cast<double>(walls)) << "the wall is found";
  EXPECT_GT(static_cast<double>(largest), 0.3 * static_cast<double>(walls)) << "in few planes";
  EXPECT_LT(static_cast<double>(of_openings), 0.06 * static_cast<double>(openings))
      << "windows and doors are not in it";
}

TEST(RealPlanes, WallsOfTwoFacades) {
  ILOT_DATA_OR_SKIP(data);
  for (const char* building : {"building_1", "building_3"})
    expect_a_wall(data / "facades/nuist" / building / "facade_1");
}

}  // namespace
}  // namespace ilot
