// SPDX-License-Identifier: Apache-2.0
// Comparison with CGAL: normals (pca_estimate_normals, parallel), in double.
#define CGAL_LINKED_WITH_TBB
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include "bench/compare.h"
#include "bench/normal_errors.h"

namespace {

using namespace ilot;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PointWithNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;

// CGAL counts neighbours without the point itself.
constexpr int kNeighbours = 16, kOthers = kNeighbours - 1;

std::vector<PointWithNormal> cloud_of(Points p, double east, double north) {
  std::vector<PointWithNormal> cloud;
  for (std::size_t i = 0; i < p.size; ++i)
    cloud.push_back({Kernel::Point_3(p.x[i] * 1e-3 + east, p.y[i] * 1e-3 + north, p.z[i] * 1e-3), {0, 0, 0}});
  return cloud;
}

void cgal_normals(std::vector<PointWithNormal>& cloud) {
  CGAL::pca_estimate_normals<CGAL::Parallel_tag>(
      cloud, kOthers,
      CGAL::parameters::point_map(CGAL::First_of_pair_property_map<PointWithNormal>())
          .normal_map(CGAL::Second_of_pair_property_map<PointWithNormal>()));
}

bench::NormalErrors errors_of(const std::vector<PackedNormal>& ours, const std::vector<PointWithNormal>& theirs) {
  return bench::normal_errors(ours, [&](std::size_t i) {
    return Vec3{theirs[i].second.x(), theirs[i].second.y(), theirs[i].second.z()};
  });
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface town = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    const std::vector<PackedNormal> ours = bench::all_normals(town.view(), kNeighbours);
    std::vector<PointWithNormal> cloud = cloud_of(town.view(), 0, 0), raw = cloud_of(town.view(), 652000, 6862000);
    cgal_normals(cloud);
    cgal_normals(raw);
    const bench::NormalErrors same = errors_of(ours, cloud), far = errors_of(ours, raw);
    bench::report({.kernel = "normals", .variant = "CGAL against ours, shifted coordinates, degrees"},
                  {{"median", same.median}, {"99th percentile", same.p99}});
    bench::report({.kernel = "normals", .variant = "CGAL against ours, raw national grid coordinates, degrees"},
                  {{"median", far.median}, {"99th percentile", far.p99}});
    bench::require(same.median < bench::kSameNormal, "CGAL's normals differ from ours");
    for (const int threads : {1, 2})
      bench::compare({"normals", "whole cloud, k=16, " + bench::in_millions(millions), threads, millions, "M points"},
                     {{"ilot, sorting included", [&] { bench::all_normals_unsorted(town, kNeighbours); }},
                      {"ilot, points in Morton order", [&] { bench::all_normals(town.view(), kNeighbours); }},
                      {"CGAL pca_estimate_normals", [&] { cgal_normals(cloud); }}});
  }
}
