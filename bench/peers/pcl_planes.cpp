// SPDX-License-Identifier: Apache-2.0
// Planes of a cloud compared with PCL's RegionGrowing, which uses angles and curvature but no epsilon. Its segments get
// their least-squares planes, and the points farther than epsilon from these planes are counted. It also runs after
// PCL's own normals. Usage: bench_pcl_planes CLOUD EPSILON_M WORK_DIR
#include <pcl/features/normal_3d.h>
#include <pcl/point_types.h>
#include <pcl/search/kdtree.h>
#include <pcl/segmentation/region_growing.h>

#include "bench/peers/planes.h"
#include "engine/error.h"

namespace {

using namespace ilot;
using Cloud = pcl::PointCloud<pcl::PointXYZ>;
using Normals = pcl::PointCloud<pcl::Normal>;

bench::Found region_growing(const bench::OrientedCloud& oriented, const Cloud::Ptr& cloud, const Normals::Ptr& normals,
                            double epsilon) {
  pcl::RegionGrowing<pcl::PointXYZ, pcl::Normal> growing;
  growing.setMinClusterSize(bench::kPlaneMinPoints);
  growing.setSearchMethod(pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
  growing.setNumberOfNeighbours(bench::kPlaneNeighbours);
  growing.setInputCloud(cloud);
  growing.setInputNormals(normals);
  growing.setSmoothnessThreshold(3.0f / 180 * 3.14159265f);  // the values of its tutorial
  growing.setCurvatureThreshold(1.0f);
  std::vector<pcl::PointIndices> regions;
  growing.extract(regions);
  bench::Found found;
  for (const auto& region : regions)
    found.add(oriented, region.indices, bench::plane_of(oriented, region.indices), epsilon);
  return found;
}

Normals::Ptr own_normals(const Cloud::Ptr& cloud) {
  pcl::NormalEstimation<pcl::PointXYZ, pcl::Normal> estimation;
  estimation.setInputCloud(cloud);
  estimation.setSearchMethod(pcl::search::KdTree<pcl::PointXYZ>::Ptr(new pcl::search::KdTree<pcl::PointXYZ>));
  estimation.setKSearch(bench::kPlaneNeighbours);
  const Normals::Ptr normals(new Normals);
  estimation.compute(*normals);
  return normals;
}

}  // namespace

int main(int argc, char** argv) try {
  const Cloud::Ptr cloud(new Cloud);
  const Normals::Ptr normals(new Normals);
  bench::compare_planes(argc, argv, [&](const bench::OrientedCloud& oriented, double epsilon) {
    for (std::size_t i = 0; i < oriented.points.size(); ++i) {
      const auto small = [](double v) { return static_cast<float>(v); };
      const Vec3 &p = oriented.points[i], &n = oriented.normals[i];
      cloud->emplace_back(small(p.x), small(p.y), small(p.z));
      normals->emplace_back(small(n.x), small(n.y), small(n.z));
    }
    return std::vector<bench::PlaneWay>{
        {"PCL RegionGrowing, in memory",
         [&, epsilon](const bench::OrientedCloud& o) { return region_growing(o, cloud, normals, epsilon); }},
        {"PCL normals and RegionGrowing, in memory", [&, epsilon](const bench::OrientedCloud& o) {
           return region_growing(o, cloud, own_normals(cloud), epsilon);
         }}};
  });
} catch (const Error& e) {
  bench::require(false, e.what());
}
