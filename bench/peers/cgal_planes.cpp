// SPDX-License-Identifier: Apache-2.0
// Planes of a cloud beside CGAL's Efficient RANSAC and region growing at the same epsilon. Ours is the whole run, from
// the file to labelled points and a table of planes on disk; theirs is detection alone, given points and normals in
// memory. Not only times: what share of the points each assigns, and what share of those lies beyond epsilon of the
// plane they were given to.
// Usage: bench_cgal_planes CLOUD EPSILON_M WORK_DIR
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Random.h>
#include <CGAL/Shape_detection/Efficient_RANSAC.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing.h>
#include <CGAL/Shape_detection/Region_growing/Region_growing_on_point_set.h>
#include <CGAL/linear_least_squares_fitting_3.h>
#include <CGAL/property_map.h>

#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/compare.h"
#include "bench/normal_errors.h"
#include "engine/cloud/record.h"
#include "engine/error.h"
#include "engine/formats/reader.h"
#include "engine/report/progress.h"
#include "engine/run/run.h"
#include "engine/settings/config.h"

namespace {

using namespace ilot;
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

constexpr int kNeighbours = 16;
constexpr std::size_t kMinPoints = 50;
constexpr double kConnectivity = 1.0, kAngleDeg = 25, kCosine = 0.906307787;

// Points relative to the first, and our normals of them: the same for everybody.
Cloud load(const std::filesystem::path& path) {
  const auto reader = open_cloud(path);
  const RecordLayout& layout = reader->info().layout;
  const std::size_t n = reader->info().points;
  std::vector<std::byte> records(n * layout.record_length);
  std::vector<std::uint8_t> valid(n);
  bench::require(reader->read(0, records, valid) == n, "the cloud is damaged");
  const auto at = [&](std::size_t i) {
    return decode_fields(std::span(records).subspan(i * layout.record_length, layout.record_length),
                         layout.point_format);
  };
  PointFields low = at(0);
  for (std::size_t i = 0; i < n; ++i) {
    const PointFields f = at(i);
    low.x = std::min(low.x, f.x);
    low.y = std::min(low.y, f.y);
    low.z = std::min(low.z, f.z);
  }
  std::vector<std::uint64_t> codes;
  for (std::size_t i = 0; i < n; ++i) {
    const PointFields f = at(i);
    codes.push_back(morton_code({static_cast<std::uint32_t>(f.x - low.x), static_cast<std::uint32_t>(f.y - low.y),
                                 static_cast<std::uint32_t>(f.z - low.z)}));
  }
  const bench::Surface s = bench::surface_of(std::move(codes));
  const std::vector<PackedNormal> normals = bench::all_normals(s.view(), kNeighbours);
  Cloud cloud;
  for (std::size_t i = 0; i < n; ++i) {
    const Kernel::Vector_3 v(normals[i].x, normals[i].y, normals[i].z);
    const double length = std::sqrt(std::max(1.0, v.squared_length()));
    cloud.push_back({{s.x[i] * layout.scale[0], s.y[i] * layout.scale[1], s.z[i] * layout.scale[2]}, v / length});
  }
  return cloud;
}

struct Found {
  std::size_t planes = 0, assigned = 0, beyond = 0;

  void add(const Cloud& cloud, const std::vector<std::size_t>& members, const Kernel::Plane_3& plane, double epsilon) {
    ++planes;
    assigned += members.size();
    for (const std::size_t i : members) beyond += CGAL::squared_distance(plane, cloud[i].first) > epsilon * epsilon;
  }
};

Found efficient_ransac(Cloud& cloud, double epsilon) {
  CGAL::get_default_random() = CGAL::Random(0);
  Ransac ransac;
  ransac.set_input(cloud);
  ransac.add_shape_factory<CGAL::Shape_detection::Plane<Traits>>();
  Ransac::Parameters parameters;
  parameters.probability = 0.01;  // of overlooking the best plane
  parameters.min_points = kMinPoints;
  parameters.epsilon = epsilon;
  parameters.normal_threshold = kCosine;
  parameters.cluster_epsilon = kConnectivity;
  ransac.detect(parameters);
  Found found;
  for (const auto& shape : ransac.shapes()) {
    const auto* plane = dynamic_cast<CGAL::Shape_detection::Plane<Traits>*>(shape.get());
    found.add(cloud, shape->indices_of_assigned_points(), static_cast<Kernel::Plane_3>(*plane), epsilon);
  }
  return found;
}

Found region_growing(const Cloud& cloud, double epsilon) {
  Neighbours neighbours(cloud, kNeighbours);
  Region region(cloud, epsilon, kAngleDeg, kMinPoints);
  CGAL::Shape_detection::Region_growing<Cloud, Neighbours, Region> growing(cloud, neighbours, region);
  std::vector<std::vector<std::size_t>> regions;
  growing.detect(std::back_inserter(regions));
  Found found;
  for (const auto& members : regions) {
    std::vector<Kernel::Point_3> points;
    for (const std::size_t i : members) points.push_back(cloud[i].first);
    Kernel::Plane_3 plane;
    CGAL::linear_least_squares_fitting_3(points.begin(), points.end(), plane, CGAL::Dimension_tag<0>());
    found.add(cloud, members, plane, epsilon);
  }
  return found;
}

// Every labelled point of ours is within epsilon by contract; tests and `ilot evaluate` check it.
Found whole_run(const std::filesystem::path& path, double epsilon, const std::filesystem::path& work) {
  RunOptions options;
  options.inputs = {path};
  options.output = work / "out";
  options.existing = Existing::overwrite;
  options.threads = thread_count();
  apply_assignment(options.settings, "planes.epsilon=" + std::to_string(epsilon));
  apply_assignment(options.settings, "planes.min_points=" + std::to_string(kMinPoints));
  apply_assignment(options.settings, "planes.connectivity=" + std::to_string(kConnectivity));
  Progress progress;
  bench::require(run(options, progress) == 0, "the run skipped something");
  std::ifstream file(options.output / "run.json");
  const nlohmann::json record = nlohmann::json::parse(file);
  return {record["counts"]["planes"], record["counts"]["points"]["labelled"], 0};
}

void report(const std::string& who, const Found& found, std::size_t points) {
  const double n = static_cast<double>(points), assigned = static_cast<double>(found.assigned);
  const double beyond = static_cast<double>(found.beyond);
  bench::report({.kernel = "planes", .variant = who + ", " + bench::in_millions(n / 1e6)},
                {{"planes", static_cast<double>(found.planes)},
                 {"assigned share", assigned / n},
                 {"assigned within epsilon, share", (assigned - beyond) / n},
                 {"of those assigned beyond epsilon", beyond / std::max(1.0, assigned)}});
}

void measure(const std::filesystem::path& path, double epsilon, const std::filesystem::path& work) {
  Cloud cloud = load(path);
  Found ours, ransac, growing;
  const double millions = static_cast<double>(cloud.size()) / 1e6;
  bench::compare({"planes", "epsilon " + std::to_string(epsilon).substr(0, 5) + " m, " + bench::in_millions(millions),
                  2, millions, "M points", millions > 0.5 ? 1 : 3},
                 {{"ilot, file to files", [&] { ours = whole_run(path, epsilon, work); }},
                  {"CGAL Efficient RANSAC, in memory", [&] { ransac = efficient_ransac(cloud, epsilon); }},
                  {"CGAL region growing, in memory", [&] { growing = region_growing(cloud, epsilon); }}});
  report("ilot", ours, cloud.size());
  report("CGAL Efficient RANSAC", ransac, cloud.size());
  report("CGAL region growing", growing, cloud.size());
}

}  // namespace

int main(int argc, char** argv) try {
  bench::require(argc == 4 && std::atof(argv[2]) > 0, "usage: bench_cgal_planes CLOUD EPSILON_M WORK_DIR");
  measure(argv[1], std::atof(argv[2]), argv[3]);
} catch (const Error& e) {
  bench::require(false, e.what());
}
