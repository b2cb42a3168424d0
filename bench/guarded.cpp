// SPDX-License-Identifier: Apache-2.0
// Runs one kernel once on a small fixed input. bench/guard counts its instructions, and only those inside guarded().
// Usage: guarded NAME. Without a name it lists the kernels.
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <functional>
#include <numeric>
#include <utility>
#include <vector>

#include "bench/street_image.h"
#include "bench/surface.h"
#include "kernels/core/eigen3.h"
#include "kernels/core/moments.h"
#include "kernels/core/radix_sort.h"
#include "kernels/core/union_find.h"
#include "kernels/morphology/area_opening.h"
#include "kernels/morphology/flat_zones.h"
#include "kernels/morphology/h_maxima.h"
#include "kernels/morphology/watershed.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/neighbours/hough_normals.h"
#include "kernels/neighbours/knn.h"
#include "kernels/planes/plane_score.h"
#include "kernels/planes/ransac.h"
#include "tests/oracles/whole_fill.h"

// bench/guard finds this function by its name in the machine code. It is never inlined.
extern "C" __attribute__((noinline)) void guarded(const std::function<void()>* run) {
  (*run)();
}

namespace {

using namespace ilot;

struct Inputs {
  bench::Surface town = bench::make_surface(20000), houses = bench::make_houses(20000);
  NeighbourIndex index = build_neighbour_index(town.view());
  std::vector<std::uint32_t> all = std::vector<std::uint32_t>(20000);
  std::vector<PackedNormal> normals = std::vector<PackedNormal>(20000);
  std::vector<std::int64_t> reach2 = std::vector<std::int64_t>(20000);
  std::vector<std::uint32_t> lists = std::vector<std::uint32_t>(20000 * 16);
  std::vector<float> nx, ny, nz;
  std::vector<PlaneHypothesis> planes;
  std::vector<std::uint32_t> counts = std::vector<std::uint32_t>(16), parents = std::vector<std::uint32_t>(20000);
  std::vector<std::uint64_t> codes;
  Image street = bench::make_street_image(200000);
  Image filled = test::fill_holes(test::fill_missing(street), Adjacency::eight);
  PixelLabels maxima = regional_maxima(h_maxima(filled, 100, Adjacency::eight), Adjacency::eight);

  Inputs() {
    std::iota(all.begin(), all.end(), 0u);
    ilot::normals(index, all, {16, kMaxSquaredReach}, normals, reach2);
    for (const PackedNormal& n : normals) {
      nx.push_back(n.x / 32767.0f);
      ny.push_back(n.y / 32767.0f);
      nz.push_back(n.z / 32767.0f);
    }
    for (auto* v : {&nx, &ny, &nz}) v->resize(20016);
    for (int i = 0; i < 16; ++i)
      planes.push_back({0, i % 2 == 0 ? 0.0f : 0.5f, 1, -9000.5f - 250.0f * static_cast<float>(i)});
    Rng rng(1);
    for (int i = 0; i < 20000; ++i) codes.push_back(rng.next() >> 1);
  }
  OrientedPoints oriented() const { return {town.view(), nx.data(), ny.data(), nz.data()}; }
};

using Kernels = std::vector<std::pair<const char*, std::function<void()>>>;

Kernels kernels_on(Inputs& in) {
  const Points p = in.town.view();
  return {
      {"area_opening", [&in] { area_opening(in.filled, 50, Adjacency::eight); }},
      {"build_neighbour_index", [&in, p] { in.index = build_neighbour_index(p); }},
      {"clusters", [&in] { euclidean_clusters(in.houses.view(), in.all, 500); }},
      {"count_inliers",
       [&in, p] {
         count_inliers({p}, in.planes, {64, 0}, in.counts);
       }},
      {"count_inliers_normals",
       [&in] {
         count_inliers(in.oriented(), in.planes, {64, 0.9f}, in.counts);
       }},
      {"fill_holes", [&in] { test::fill_holes(in.street, Adjacency::eight); }},
      {"flat_zones", [&in] { flat_zones(in.filled, 1000, Adjacency::eight); }},
      {"h_maxima", [&in] { h_maxima(in.filled, 100, Adjacency::eight); }},
      {"hough_normals",
       [&in] {
         const auto some = std::span(in.all).first(2000);
         hough_normals(in.index, some, {.k = 30, .max_d2 = kMaxSquaredReach}, std::span(in.normals).first(2000),
                       std::span(in.reach2).first(2000));
       }},
      {"knn",
       [&in] {
         knn(in.index, in.all, {16, kMaxSquaredReach}, in.lists, in.reach2);
       }},
      {"moments", [&in, p] { in.reach2[0] = moments_of(p, in.all).n; }},
      {"normals",
       [&in] {
         normals(in.index, in.all, {16, kMaxSquaredReach}, in.normals, in.reach2);
       }},
      {"ransac",
       [&in] {
         ransac_planes(in.oriented(), {.epsilon = 50, .min_cos = 0.9, .connectivity = 1000, .min_points = 50});
       }},
      {"sorted_order", [&in] { sorted_order(in.codes); }},
      {"watershed", [&in] { watershed(in.filled, in.maxima, Adjacency::eight); }},
      {"union_find",
       [&in] {
         UnionFind sets(in.parents);
         for (std::uint32_t i = 0; i < 20000; ++i) sets.unite(i, (i * 7919 + 13) % 20000);
       }},
  };
}

}  // namespace

int main(int argc, char** argv) {
  Inputs inputs;
  for (const auto& [name, run] : kernels_on(inputs)) {
    if (argc < 2) std::puts(name);
    if (argc == 2 && std::strcmp(argv[1], name) == 0) {
      guarded(&run);
      return 0;
    }
  }
  return argc < 2 ? 0 : 2;
}
