// SPDX-License-Identifier: Apache-2.0
// Planes of a cloud compared with CGAL's Efficient RANSAC and region growing at the same epsilon. Region growing also
// runs after CGAL's own normals, in parallel.
// Usage: bench_cgal_planes CLOUD EPSILON_M WORK_DIR
#define CGAL_LINKED_WITH_TBB
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#include <CGAL/pca_estimate_normals.h>
#include <CGAL/property_map.h>

#include "bench/peers/planes.h"
#include "engine/error.h"

namespace {

using namespace ilot;
using bench::Found;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using PointWithNormal = std::pair<Kernel::Point_3, Kernel::Vector_3>;
using Cloud = std::vector<PointWithNormal>;
using PointMap = CGAL::First_of_pair_property_map<PointWithNormal>;
using NormalMap = CGAL::Second_of_pair_property_map<PointWithNormal>;
using Traits = CGAL::Shape_detection::Efficient_RANSAC_traits<Kernel, Cloud, PointMap, NormalMap>;
using Ransac = CGAL::Shape_detection::Efficient_RANSAC<Traits>;
namespace Growing = CGAL::Shape_detection::Point_set;
using Neighbours = Growing::K_neighbor_query<Kernel, Cloud, PointMap>;
using Region = Growing::Least_squares_plane_fit_region<Kernel, Cloud, PointMap, NormalMap>;

Cloud cgal_cloud(const bench::OrientedCloud& from) {
  Cloud cloud;
  for (std::size_t i = 0; i < from.points.size(); ++i) {
    const Vec3 &p = from.points[i], &n = from.normals[i];
    cloud.push_back({{p.x, p.y, p.z}, {n.x, n.y, n.z}});
  }
  return cloud;
}

// Its indices are those of the points in its own order.
Found efficient_ransac(Cloud cloud, double epsilon) {
  CGAL::get_default_random() = CGAL::Random(0);
  Ransac ransac;
  ransac.set_input(cloud);
  ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
  Ransac::Parameters parameters;
  parameters.probability = 0.01;  // probability that the best plane is not found
  parameters.min_points = bench::kPlaneMinPoints;
  parameters.epsilon = epsilon;
  parameters.normal_threshold = std::cos(bench::kPlaneAngleDeg * CGAL_PI / 180);
  parameters.cluster_epsilon = bench::kPlaneConnectivity;
  ransac.detect(parameters);
  bench::OrientedCloud reordered;
  for (const auto& [p, n] : cloud) reordered.points.push_back({p.x(), p.y(), p.z()});
  Found found;
  for (const auto& shape : ransac.shapes()) {
    const auto* plane = dynamic_cast<CGAL::Shape_detection::Plane<Traits>*>(shape.get());
    const Kernel::Plane_3 p = static_cast<Kernel::Plane_3>(*plane);
    const double length = std::sqrt(p.a() * p.a() + p.b() * p.b() + p.c() * p.c());
    found.add(reordered, shape->indices_of_assigned_points(),
              {{p.a() / length, p.b() / length, p.c() / length}, p.d() / length}, epsilon);
  }
  return found;
}

// CGAL counts neighbours without the point itself. The signs of the normals have no effect on the next steps.
Cloud with_own_normals(Cloud cloud) {
  CGAL::pca_estimate_normals<CGAL::Parallel_tag>(cloud, bench::kPlaneNeighbours - 1,
                                                 CGAL::parameters::point_map(PointMap()).normal_map(NormalMap()));
  return cloud;
}

Found region_growing(const bench::OrientedCloud& oriented, const Cloud& cloud, double epsilon) {
  Neighbours neighbours(cloud, bench::kPlaneNeighbours);
  Region region(cloud, epsilon, bench::kPlaneAngleDeg, bench::kPlaneMinPoints);
  CGAL::Shape_detection::Region_growing<Cloud, Neighbours, Region> growing(cloud, neighbours, region);
  std::vector<std::vector<std::size_t>> regions;
  growing.detect(std::back_inserter(regions));
  Found found;
  for (const auto& members : regions) found.add(oriented, members, bench::plane_of(oriented, members), epsilon);
  return found;
}

}  // namespace

int main(int argc, char** argv) try {
  Cloud cloud;
  bench::compare_planes(argc, argv, [&](const bench::OrientedCloud& oriented, double epsilon) {
    cloud = cgal_cloud(oriented);
    return std::vector<bench::PlaneWay>{
        {"CGAL Efficient RANSAC, in memory",
         [&, epsilon](const bench::OrientedCloud&) { return efficient_ransac(cloud, epsilon); }},
        {"CGAL region growing, in memory",
         [&, epsilon](const bench::OrientedCloud& o) { return region_growing(o, cloud, epsilon); }},
        {"CGAL normals and region growing, in memory",
         [&, epsilon](const bench::OrientedCloud& o) { return region_growing(o, with_own_normals(cloud), epsilon); }}};
  });
} catch (const Error& e) {
  bench::require(false, e.what());
}
