// SPDX-License-Identifier: Apache-2.0
// Comparison with PCL: normals (NormalEstimationOMP), clusters (EuclideanClusterExtraction), the inliers of a plane
// (SampleConsensusModelPlane, with which SACSegmentation counts). PCL stores coordinates in float32, so the comparison
// uses coordinates that are shifted to the town. The errors of normals on coordinates of a national grid are also
// reported.
#include <omp.h>
#include <pcl/features/normal_3d_omp.h>
#include <pcl/point_types.h>
#include <pcl/sample_consensus/sac_model_plane.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/extract_clusters.h>
#include <pcl/segmentation/sac_segmentation.h>

#include <cmath>

#include "bench/compare.h"
#include "bench/normal_errors.h"
#include "bench/town.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/neighbours/knn.h"
#include "kernels/planes/plane_score.h"

namespace {

using namespace ilot;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;

constexpr int kNeighbours = 16;

// Coordinates are metres. `east` and `north` are added in double before the conversion to float32.
Cloud::Ptr cloud_of(Points p, double east, double north) {
  const Cloud::Ptr cloud(new Cloud);
  for (std::size_t i = 0; i < p.size; ++i)
    cloud->emplace_back(static_cast<float>(p.x[i] * 1e-3 + east), static_cast<float>(p.y[i] * 1e-3 + north),
                        static_cast<float>(p.z[i] * 1e-3));
  return cloud;
}

pcl::PointCloud<pcl::Normal> pcl_normals(const Cloud::Ptr& cloud, int threads) {
  pcl::NormalEstimationOMP<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setNumberOfThreads(static_cast<unsigned>(threads));
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
  estimation.setKSearch(kNeighbours);
  pcl::PointCloud<pcl::Normal> out;
  estimation.compute(out);
  return out;
}

bench::NormalErrors errors_of(const std::vector<PackedNormal>& ours, const pcl::PointCloud<pcl::Normal>& theirs) {
  return bench::normal_errors(ours, [&](std::size_t i) {
    return Vec3{theirs[i].normal_x, theirs[i].normal_y, theirs[i].normal_z};
  });
}

void compare_normals(const bench::Surface& town, double millions) {
  const Cloud::Ptr cloud = cloud_of(town.view(), 0, 0);
  const std::vector<PackedNormal> ours = bench::all_normals(town.view(), kNeighbours);
  const bench::NormalErrors shifted = errors_of(ours, pcl_normals(cloud, 2));
  const bench::NormalErrors raw = errors_of(ours, pcl_normals(cloud_of(town.view(), 652000, 6862000), 2));
  bench::report({.kernel = "normals", .variant = "PCL against ours, shifted coordinates, degrees"},
                {{"median", shifted.median}, {"99th percentile", shifted.p99}});
  bench::report({.kernel = "normals", .variant = "PCL against ours, raw national grid coordinates, degrees"},
                {{"median", raw.median}, {"99th percentile", raw.p99}});
  bench::require(shifted.median < bench::kSameNormal, "PCL's normals differ from ours on shifted coordinates");
  for (const int threads : {1, 2})
    bench::compare({"normals", "whole cloud, k=16, " + bench::in_millions(millions), threads, millions, "M points"},
                   {{"ilot, sorting included", [&] { bench::all_normals_unsorted(town, kNeighbours); }},
                    {"ilot, points in Morton order", [&] { bench::all_normals(town.view(), kNeighbours); }},
                    {"PCL NormalEstimationOMP", [&] { pcl_normals(cloud, threads); }}});
}

std::size_t pcl_clusters(const Cloud::Ptr& cloud, double tolerance) {
  const pcl::search::KdTree<pcl::PointXYZ>::Ptr tree(new pcl::search::KdTree<pcl::PointXYZ>);
  tree->setInputCloud(cloud);
  pcl::EuclideanClusterExtraction<pcl::PointXYZ> extraction;
  extraction.setClusterTolerance(tolerance);
  extraction.setMinClusterSize(1);
  extraction.setSearchMethod(tree);
  extraction.setInputCloud(cloud);
  std::vector<pcl::PointIndices> clusters;
  extraction.extract(clusters);
  return clusters.size();
}

void compare_clusters(double millions) {
  const bench::Surface houses = bench::make_houses(static_cast<std::size_t>(millions * 1e6));
  const Cloud::Ptr cloud = cloud_of(houses.view(), 0, 0);
  const auto all = bench::all_of(houses.size);
  // Half a step of float32 in both directions, because 0.5 m is included in ours.
  const double tolerance = 0.5000005;
  const auto ours = static_cast<double>(euclidean_clusters(houses.view(), all, 500).count);
  const auto theirs = static_cast<double>(pcl_clusters(cloud, tolerance));
  bench::report({.kernel = "clusters", .variant = "number, 0.5 m, " + bench::in_millions(millions)},
                {{"ilot", ours}, {"PCL", theirs}});
  bench::require(std::abs(ours - theirs) <= 1e-5 * static_cast<double>(houses.size), "PCL finds other clusters");
  bench::compare({"clusters", "0.5 m, " + bench::in_millions(millions), 1, millions, "M points"},
                 {{"ilot", [&] { euclidean_clusters(houses.view(), all, 500); }},
                  {"PCL EuclideanClusterExtraction", [&] { pcl_clusters(cloud, tolerance); }}});
}

// The plane is horizontal and its distances are exact in float32, so both must count the same points.
void compare_plane_counts(const bench::Surface& town, double millions) {
  const Cloud::Ptr cloud(new Cloud);
  const Points p = town.view();
  for (std::size_t i = 0; i < p.size; ++i) cloud->emplace_back(p.x[i], p.y[i], p.z[i]);
  const pcl::SampleConsensusModelPlane<pcl::PointXYZ> model(cloud);
  const PlaneHypothesis plane{0, 0, 1, -10000.5f};
  const Eigen::VectorXf coefficients = (Eigen::VectorXf(4) << 0, 0, 1, -10000.5f).finished();
  std::uint32_t ours = 0;
  count_inliers({p}, std::span(&plane, 1), {64, 0}, std::span(&ours, 1));
  bench::require(ours == model.countWithinDistance(coefficients, 64), "PCL counts other inliers of the same plane");
  std::vector<PlaneHypothesis> sixteen(16, plane);
  std::vector<std::uint32_t> counts(16);
  std::size_t sink = 0;
  bench::compare({"plane_score", "16 planes, " + bench::in_millions(millions), 1, millions * 16e-3, "G point-planes"},
                 {{"ilot",
                   [&] {
                     count_inliers({p}, sixteen, {64, 0}, counts);
                   }},
                  {"PCL SampleConsensusModelPlane", [&] {
                     for (int i = 0; i < 16; ++i) sink += model.countWithinDistance(coefficients, 64);
                   }}});
  bench::require(sink > 0, "PCL counted nothing");
}

// Finds one plane by RANSAC, with the same number of hypotheses on all points. Its inliers must equal ours of the same
// coefficients. The only exceptions are points that float32 rounds across the distance because it sums in another
// order.
void compare_ransac(const bench::Surface& town, double millions) {
  constexpr int kHypotheses = 64;
  constexpr float kDistance = 0.064f;
  const Cloud::Ptr cloud = cloud_of(town.view(), 0, 0);
  std::vector<float> x, y, z;
  for (const pcl::PointXYZ& p : *cloud) {
    x.push_back(p.x);
    y.push_back(p.y);
    z.push_back(p.z);
  }
  for (auto* v : {&x, &y, &z}) v->resize(cloud->size() + 16);
  const OrientedPoints points{{x.data(), y.data(), z.data(), cloud->size()}};
  pcl::ModelCoefficients found;
  pcl::PointIndices inliers;
  const auto theirs = [&] {
    pcl::SACSegmentation<pcl::PointXYZ> segmentation;
    segmentation.setModelType(pcl::SACMODEL_PLANE);
    segmentation.setMethodType(pcl::SAC_RANSAC);
    segmentation.setOptimizeCoefficients(false);
    segmentation.setMaxIterations(kHypotheses);
    segmentation.setProbability(1 - 1e-12);  // so that it never stops early
    segmentation.setDistanceThreshold(kDistance);
    segmentation.setInputCloud(cloud);
    segmentation.segment(inliers, found);
  };
  theirs();
  const PlaneHypothesis same{found.values[0], found.values[1], found.values[2], found.values[3]};
  std::uint32_t ours = 0;
  count_inliers(points, std::span(&same, 1), {kDistance, 0}, std::span(&ours, 1));
  const double apart = std::abs(static_cast<double>(ours) - static_cast<double>(inliers.indices.size()));
  bench::require(apart <= 1e-4 * static_cast<double>(inliers.indices.size()), "PCL segments other inliers");
  const std::vector<PlaneHypothesis> hypotheses(kHypotheses, same);
  std::vector<std::uint32_t> counts(kHypotheses);
  bench::compare({"plane_score", "RANSAC, 64 hypotheses, " + bench::in_millions(millions), 1,
                  millions * kHypotheses * 1e-3, "G point-planes"},
                 {{"ilot",
                   [&] {
                     count_inliers(points, hypotheses, {kDistance, 0}, counts);
                   }},
                  {"PCL SACSegmentation", theirs}});
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1})) {
    const bench::Surface town = bench::make_surface(static_cast<std::size_t>(millions * 1e6));
    compare_normals(town, millions);
    compare_plane_counts(town, millions);
    compare_ransac(town, millions);
    compare_clusters(millions);
  }
}
