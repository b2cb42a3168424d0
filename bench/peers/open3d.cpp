// SPDX-License-Identifier: Apache-2.0
// Comparison with Open3D: normals (EstimateNormals), clusters (ClusterDBSCAN, where every point is a core point), in
// double.
#include <omp.h>
#include <open3d/geometry/PointCloud.h>
#include <open3d/utility/Logging.h>

#include <cmath>

#include "bench/compare.h"
#include "bench/normal_errors.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/planes/plane_score.h"

namespace {

using namespace ilot;
using open3d::geometry::PointCloud;

constexpr int kNeighbours = 16;

PointCloud cloud_of(Points p, double east, double north) {
  PointCloud cloud;
  for (std::size_t i = 0; i < p.size; ++i)
    cloud.points_.emplace_back(p.x[i] * 1e-3 + east, p.y[i] * 1e-3 + north, p.z[i] * 1e-3);
  return cloud;
}

void open3d_normals(PointCloud& cloud, int threads) {
  omp_set_num_threads(threads);
  cloud.normals_.clear();  // else it uses them to orient the new ones
  cloud.EstimateNormals(open3d::geometry::KDTreeSearchParamKNN(kNeighbours), false);
}

bench::NormalErrors errors_of(const std::vector<PackedNormal>& ours, const PointCloud& theirs) {
  return bench::normal_errors(ours, [&](std::size_t i) {
    const Eigen::Vector3d& n = theirs.normals_[i];
    return Vec3{n.x(), n.y(), n.z()};
  });
}

void compare_normals(const bench::Surface& town, double millions) {
  const std::vector<PackedNormal> ours = bench::all_normals(town.view(), kNeighbours);
  PointCloud cloud = cloud_of(town.view(), 0, 0), raw = cloud_of(town.view(), 652000, 6862000);
  open3d_normals(cloud, 2);
  open3d_normals(raw, 2);
  const bench::NormalErrors same = errors_of(ours, cloud), far = errors_of(ours, raw);
  bench::report({.kernel = "normals", .variant = "Open3D against ours, shifted coordinates, degrees"},
                {{"median", same.median}, {"99th percentile", same.p99}});
  bench::report({.kernel = "normals", .variant = "Open3D against ours, raw national grid coordinates, degrees"},
                {{"median", far.median}, {"99th percentile", far.p99}});
  bench::require(same.median < bench::kSameNormal, "Open3D's normals differ from ours");
  for (const int threads : {1, 2})
    bench::compare({"normals", "whole cloud, k=16, " + bench::in_millions(millions), threads, millions, "M points"},
                   {{"ilot, sorting included", [&] { bench::all_normals_unsorted(town, kNeighbours); }},
                    {"ilot, points in Morton order", [&] { bench::all_normals(town.view(), kNeighbours); }},
                    {"Open3D EstimateNormals", [&] { open3d_normals(cloud, threads); }}});
}

int open3d_clusters(const PointCloud& cloud, double tolerance) {
  const std::vector<int> labels = cloud.ClusterDBSCAN(tolerance, 1);
  return labels.empty() ? 0 : *std::max_element(labels.begin(), labels.end()) + 1;
}

void compare_clusters(double millions) {
  const bench::Surface houses = bench::make_houses(static_cast<std::size_t>(millions * 1e6));
  const PointCloud cloud = cloud_of(houses.view(), 0, 0);
  const auto all = bench::all_of(houses.size);
  const double tolerance = 0.5000005;  // half a square millimetre more, because 0.5 m is included in ours
  const auto ours = static_cast<double>(euclidean_clusters(houses.view(), all, 500).count);
  const auto theirs = static_cast<double>(open3d_clusters(cloud, tolerance));
  bench::report({.kernel = "clusters", .variant = "number, 0.5 m, " + bench::in_millions(millions)},
                {{"ilot", ours}, {"Open3D", theirs}});
  bench::require(ours == theirs, "Open3D finds other clusters");
  bench::compare({"clusters", "0.5 m, " + bench::in_millions(millions), 1, millions, "M points"},
                 {{"ilot", [&] { euclidean_clusters(houses.view(), all, 500); }},
                  {"Open3D ClusterDBSCAN", [&] { open3d_clusters(cloud, tolerance); }}});
}

// Finds one plane by RANSAC, with the same number of hypotheses on all points.
void compare_ransac(const bench::Surface& town, double millions) {
  constexpr int kHypotheses = 64;
  constexpr double kDistance = 0.0645;  // between integer millimetres
  omp_set_num_threads(1);
  const PointCloud cloud = cloud_of(town.view(), 0, 0);
  Eigen::Vector4d plane;
  std::vector<std::size_t> inliers;
  const auto theirs = [&] { std::tie(plane, inliers) = cloud.SegmentPlane(kDistance, 3, kHypotheses, 1.0); };
  theirs();
  const PlaneHypothesis same{static_cast<float>(plane[0]), static_cast<float>(plane[1]), static_cast<float>(plane[2]),
                             static_cast<float>(plane[3] * 1000)};
  const OrientedPoints points{town.view()};
  std::uint32_t ours = 0;
  count_inliers(points, std::span(&same, 1), {1000 * static_cast<float>(kDistance), 0}, std::span(&ours, 1));
  // It returns the plane fitted to the inliers of the best hypothesis, so the counts are near but not equal.
  const double apart = std::abs(static_cast<double>(ours) - static_cast<double>(inliers.size()));
  bench::require(apart <= 0.02 * static_cast<double>(inliers.size()), "Open3D segments another plane");
  const std::vector<PlaneHypothesis> hypotheses(kHypotheses, same);
  std::vector<std::uint32_t> counts(kHypotheses);
  bench::compare({"plane_score", "RANSAC, 64 hypotheses, " + bench::in_millions(millions), 1,
                  millions * kHypotheses * 1e-3, "G point-planes"},
                 {{"ilot",
                   [&] {
                     count_inliers(points, hypotheses, {64.5f, 0}, counts);
                   }},
                  {"Open3D SegmentPlane", theirs}});
}

}  // namespace

int main(int argc, char** argv) {
  open3d::utility::SetVerbosityLevel(open3d::utility::VerbosityLevel::Error);
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface town = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    compare_normals(town, millions);
    compare_ransac(town, millions);
    compare_clusters(millions);
  }
}
