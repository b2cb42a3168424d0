// SPDX-License-Identifier: Apache-2.0
// Counts the roof faces that each method finds on the scene `roofs`. Buildings are clusters [Boltcheva et al. 2019,
// 3.1] of roof and wall points. A true face is found when one found plane has an intersection over union of at least
// half with it, in points. The results are by area of the face and by kind of roof, so that D2 + D3 of the documents
// can be compared with D4. Usage: study_roofs ROOFS.laz
#include <fmt/core.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdlib>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <numeric>

#include "kernels/core/portable_math.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/neighbours/hough_normals.h"
#include "kernels/neighbours/knn.h"
#include "kernels/plane_methods/roof_ransac.h"
#include "kernels/plane_methods/split_merge.h"
#include "kernels/planes/ransac.h"
#include "kernels/planes/region_planes.h"
#include "kernels/planes/relabel.h"
#include "study/scene.h"

namespace {

using namespace ilot;
using bench::Scene;

// The points of one building, relative to its lowest corner, with both kinds of normals.
struct Building : PaddedOrientedPoints {  // sharp normals
  std::vector<PackedNormal> sharp;
  std::vector<std::uint32_t> near, truth;
  NeighbourLists neighbours() const { return {near, Scene::kNear}; }
};

struct Face {
  double area = 0;
  std::string roof;
  std::uint64_t points = 0;
};

constexpr double kUnit = 0.001;
const double kEpsilon = 0.083 / kUnit;  // Boltcheva's value: a twelfth of a metre
constexpr std::int64_t kGap = 1000;
constexpr std::uint32_t kLeast = 12;

std::vector<Building> buildings_of(const Scene& s) {
  std::vector<std::uint32_t> chosen;
  for (std::uint32_t i = 0; i < s.size(); ++i)
    if (s.true_class[i] == 2 || s.true_class[i] == 3) chosen.push_back(i);
  const Clusters clusters = euclidean_clusters(s.points(), chosen, kGap);
  std::vector<std::vector<std::uint32_t>> members(clusters.count);
  for (std::size_t i = 0; i < chosen.size(); ++i) members[clusters.id[i]].push_back(chosen[i]);
  std::vector<Building> result;
  for (const auto& m : members) {
    if (m.size() < 50) continue;
    Building b;
    const auto lowest = [&](const std::vector<float>& v) {
      float low = v[m[0]];
      for (const std::uint32_t i : m) low = std::min(low, v[i]);
      return low;
    };
    const float x = lowest(s.x), y = lowest(s.y), z = lowest(s.z);
    for (const std::uint32_t i : m) {
      b.add(s.x[i] - x, s.y[i] - y, s.z[i] - z);
      b.truth.push_back(s.true_class[i] == 2 ? s.true_plane[i] : 0);
    }
    b.pad();
    const NeighbourIndex index = build_neighbour_index(b.points());
    std::vector<std::uint32_t> all(m.size());
    std::iota(all.begin(), all.end(), 0u);
    std::vector<std::int64_t> reach2(m.size());
    b.sharp.resize(m.size());
    hough_normals(index, all, {30, kMaxSquaredReach}, b.sharp, reach2);
    b.near.resize(m.size() * Scene::kNear);
    knn(index, all, {Scene::kNear, kMaxSquaredReach}, b.near, reach2);
    for (std::size_t i = 0; i < m.size(); ++i) {
      b.nx[i] = static_cast<float>(b.sharp[i].x) / 32767;
      b.ny[i] = static_cast<float>(b.sharp[i].y) / 32767;
      b.nz[i] = static_cast<float>(b.sharp[i].z) / 32767;
    }
    result.push_back(std::move(b));
  }
  return result;
}

std::map<std::uint32_t, Face> faces_of(const std::filesystem::path& file) {
  std::filesystem::path beside = file;
  beside.replace_extension(".truth.json");
  std::ifstream in(beside);
  const nlohmann::json truth = nlohmann::json::parse(in);
  std::map<std::uint32_t, Face> faces;
  for (const auto& p : truth.at("planes"))
    if (p.at("class") == "roof") faces[p.at("id")] = {p.at("area_m2"), "", p.at("points")};
  for (const auto& b : truth.at("buildings"))
    for (const auto& f : b.at("faces"))
      if (faces.count(f) != 0) faces[f].roof = b.at("roof");
  return faces;
}

void evaluate(const char* name, const std::vector<Building>& buildings, const std::map<std::uint32_t, Face>& faces,
              const std::function<PlaneSegments(const Building&)>& method) {
  const auto start = std::chrono::steady_clock::now();
  std::map<std::uint32_t, std::uint64_t> of_truth;
  std::map<std::pair<std::uint32_t, std::uint64_t>, std::uint64_t> shared;
  std::map<std::uint64_t, std::uint64_t> of_found;
  std::uint64_t planes = 0;
  for (const Building& b : buildings) {
    PlaneSegments s = method(b);
    RelabelParams relabel{kEpsilon, kGap};
    relabel_until_stable(b.points(), b.neighbours(), relabel, kLeast, s);
    for (std::size_t i = 0; i < b.truth.size(); ++i) {
      const std::uint64_t found = s.label[i] == 0 ? 0 : planes + s.label[i];
      if (b.truth[i] != 0) ++of_truth[b.truth[i]];
      if (found != 0) ++of_found[found];
      if (b.truth[i] != 0 && found != 0) ++shared[{b.truth[i], found}];
    }
    planes += s.planes.size();
  }
  const double seconds = std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
  std::map<std::uint32_t, bool> found;
  for (const auto& [pair, n] : shared)
    if (2 * n >= of_truth[pair.first] + of_found[pair.second] - n) found[pair.first] = true;
  const auto share = [&](double from, double to, const char* roof) {
    std::size_t all = 0, hit = 0;
    for (const auto& [id, f] : faces) {
      if (f.area < from || f.area >= to || (*roof != 0 && f.roof != roof)) continue;
      ++all;
      hit += found.count(id);
    }
    return all == 0 ? std::string("-")
                    : fmt::format("{:.1f}", 100.0 * static_cast<double>(hit) / static_cast<double>(all));
  };
  fmt::print("{:<22}{:>7.2f}{:>7}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", name, seconds, planes, share(10, 1e9, ""),
             share(5, 10, ""), share(2, 5, ""), share(2, 1e9, "gable"), share(2, 1e9, "hip"), share(2, 1e9, "complex"));
  std::fflush(stdout);
}

PlaneSegments smooth(const Building& b, double degrees) {
  const Regions r = grow_smooth(b.points(), b.sharp, b.neighbours(), {cos_degrees(degrees), 1.0 / 3, kGap, 6});
  return planes_of_regions(b.points(), r, {kEpsilon, kLeast, kGap, PlaneEstimate::kBest});
}

PlaneSegments pairs(const Building& b) {
  const Regions r = grow_by_pairs(b.points(), b.sharp, b.neighbours(), {cos_degrees(8), kEpsilon / 2, kGap, kLeast});
  return planes_of_regions(b.points(), r, {kEpsilon, kLeast, kGap, PlaneEstimate::kBest});
}

PlaneSegments rings(const Building& b, std::uint32_t least) {
  RoofRansacParams p;
  p.epsilon = kEpsilon;
  p.stray_gap = kGap;
  p.min_points = least;
  p.key = 1;
  return roof_ransac(b.points(), b.neighbours(), p);
}

PlaneSegments draws(const Building& b) {
  return ransac_planes(b.oriented(), {kEpsilon, cos_degrees(25), kGap, kLeast, 0.99, 1});
}

PlaneSegments octree(const Building& b) {
  SplitMergeParams p;
  p.epsilon = kEpsilon;
  p.tolerance = kEpsilon / 2.5;
  p.max_step = kEpsilon / 2;
  p.min_edge = 600;
  p.min_points = kLeast;
  return split_merge(b.points(), p);
}

}  // namespace

int main(int argc, char** argv) {
  if (argc < 2) {
    fmt::print(stderr, "usage: study_roofs ROOFS.laz\n");
    return 2;
  }
  try {
    const auto faces = faces_of(argv[1]);
    const Scene s = bench::load_scene(argv[1], 16, bench::Cleaning::kNone);
    const std::vector<Building> buildings = buildings_of(s);
    fmt::print("{}: {} buildings or blocks, {} true faces; faces found, percent\n", argv[1], buildings.size(),
               faces.size());
    fmt::print("{:<22}{:>7}{:>7}{:>9}{:>9}{:>9}{:>9}{:>9}{:>9}\n", "method", "s", "planes", ">= 10 m2", "5-10", "2-5",
               "gable", "hip", "complex");
    evaluate("D2 + D3, 2 degrees", buildings, faces, [](const Building& b) { return smooth(b, 2); });
    evaluate("D2 + D3, 5 degrees", buildings, faces, [](const Building& b) { return smooth(b, 5); });
    evaluate("D2 + A2", buildings, faces, pairs);
    evaluate("D4, 100 points", buildings, faces, [](const Building& b) { return rings(b, 100); });
    evaluate("D4, 20 points", buildings, faces, [](const Building& b) { return rings(b, 20); });
    evaluate("D2 + A6", buildings, faces, draws);
    evaluate("A3 octree", buildings, faces, octree);
  } catch (const std::exception& e) {
    fmt::print(stderr, "study_roofs: {}\n", e.what());
    return 1;
  }
  return 0;
}
