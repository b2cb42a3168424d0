// SPDX-License-Identifier: Apache-2.0
// Shared by the comparisons of our planes with those of another library. Our times are for the steps from the file to
// joined planes and labels on disk (index, normals, planes, join), and also for the whole run, which draws outlines and
// writes the points too. The other library works on points in memory. It uses our normals unless the name states that
// it makes its own. Besides times, the comparison gives the share of the points that each assigns, and the share of
// these points that is farther than epsilon from their plane.
#pragma once
#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>

#include "bench/compare.h"
#include "bench/normal_errors.h"
#include "engine/cloud/record.h"
#include "engine/formats/reader.h"
#include "engine/pass/index.h"
#include "engine/pass/input_lattice.h"
#include "engine/products/planes/make_planes.h"
#include "engine/report/progress.h"
#include "engine/run/run.h"
#include "engine/settings/config.h"
#include "kernels/planes/plane_fit.h"

namespace ilot::bench {

constexpr int kPlaneNeighbours = 16;
constexpr std::size_t kPlaneMinPoints = 50;
constexpr double kPlaneConnectivity = 1.0, kPlaneAngleDeg = 25;

// Points in metres relative to the lowest corner of the cloud, in Morton order, and our normals of them. All libraries
// get the same input.
struct OrientedCloud {
  std::vector<Vec3> points, normals;
};

inline OrientedCloud load_oriented(const std::filesystem::path& path) {
  const auto reader = open_cloud(path);
  const RecordLayout& layout = reader->info().layout;
  const std::size_t n = reader->info().points;
  std::vector<std::byte> records(n * layout.record_length);
  std::vector<std::uint8_t> valid(n);
  require(reader->read(0, records, valid) == n, "the cloud is damaged");
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
  const Surface s = surface_of(std::move(codes));
  OrientedCloud cloud;
  for (const PackedNormal& packed : all_normals(s.view(), kPlaneNeighbours)) {
    const Vec3 v{static_cast<double>(packed.x), static_cast<double>(packed.y), static_cast<double>(packed.z)};
    cloud.normals.push_back((1 / std::max(1.0, norm(v))) * v);
  }
  for (std::size_t i = 0; i < n; ++i)
    cloud.points.push_back({s.x[i] * layout.scale[0], s.y[i] * layout.scale[1], s.z[i] * layout.scale[2]});
  return cloud;
}

struct Found {
  std::size_t planes = 0, assigned = 0, beyond = 0;

  // Counts the members of one plane.
  template <class Members>
  void add(const OrientedCloud& cloud, const Members& members, const Plane& plane, double epsilon) {
    ++planes;
    for (const auto i : members) {
      ++assigned;
      beyond += std::abs(signed_distance(plane, cloud.points[static_cast<std::size_t>(i)])) > epsilon;
    }
  }
};

// Returns the least-squares plane of some points, for methods that give only the groups of points.
template <class Members>
Plane plane_of(const OrientedCloud& cloud, const Members& members) {
  Moments m;
  for (const auto i : members) {
    const Vec3& p = cloud.points[static_cast<std::size_t>(i)];
    const auto whole = [](double v) { return static_cast<std::int64_t>(std::nearbyint(v * 1000)); };
    m.add_point({whole(p.x), whole(p.y), whole(p.z)});
  }
  const Plane millimetres = fit_plane(m).plane;
  return {millimetres.n, millimetres.d / 1000};
}

inline Settings plane_settings(double epsilon) {
  Settings settings;
  apply_assignment(settings, "planes.epsilon=" + std::to_string(epsilon));
  apply_assignment(settings, "planes.min_points=" + std::to_string(kPlaneMinPoints));
  apply_assignment(settings, "planes.connectivity=" + std::to_string(kPlaneConnectivity));
  return settings;
}

// Every labelled point of ours is within epsilon by contract. Tests and `ilot evaluate` check this.
inline Found cloud_to_planes(const std::filesystem::path& path, double epsilon, const std::filesystem::path& work) {
  std::vector<std::unique_ptr<PointReader>> inputs;
  inputs.push_back(open_cloud(path));
  IndexParams params;
  const InputLattice lattice = common_lattice(inputs, 1);
  params.unit = lattice.unit;
  params.multiple = lattice.multiple;
  const std::filesystem::path folder = work / "store";
  std::filesystem::remove_all(folder);
  std::filesystem::create_directories(folder);
  const PassContext context;
  const IndexResult index = build_index(inputs, params, folder, context);
  Progress progress;
  RunRecord record;
  const PlanesResult result = make_planes(index.store, inputs, plane_settings(epsilon), context, progress, record);
  Found found{result.segments.size(), 0, 0};
  for (const Segment& s : result.segments) found.assigned += s.points;
  std::filesystem::remove_all(folder);
  return found;
}

inline Found whole_run(const std::filesystem::path& path, double epsilon, const std::filesystem::path& work) {
  RunOptions options;
  options.inputs = {path};
  options.output = work / "out";
  options.existing = Existing::overwrite;
  options.threads = thread_count();
  options.settings = plane_settings(epsilon);
  Progress progress;
  require(run(options, progress) == 0, "the run skipped something");
  std::ifstream file(options.output / "run.json");
  const nlohmann::json record = nlohmann::json::parse(file);
  return {record["counts"]["planes"], record["counts"]["points"]["labelled"], 0};
}

inline void report_planes(const std::string& who, const Found& found, std::size_t points) {
  const double n = static_cast<double>(points), assigned = static_cast<double>(found.assigned);
  const double beyond = static_cast<double>(found.beyond);
  report({.kernel = "planes", .variant = who + ", " + in_millions(n / 1e6)},
         {{"planes", static_cast<double>(found.planes)},
          {"assigned share", assigned / n},
          {"assigned within epsilon, share", (assigned - beyond) / n},
          {"of those assigned beyond epsilon", beyond / std::max(1.0, assigned)}});
}

struct PlaneWay {
  std::string name;
  std::function<Found(const OrientedCloud&)> detect;
};

// argv: CLOUD EPSILON_M WORK_DIR [NAME]. With NAME, only the peers whose name contains NAME run. One thread on each
// side, three rounds; one round for clouds of more than two million points.
inline void compare_planes(int argc, char** argv,
                           const std::function<std::vector<PlaneWay>(const OrientedCloud&, double)>& peers) {
  require((argc == 4 || argc == 5) && std::atof(argv[2]) > 0, "usage: CLOUD EPSILON_M WORK_DIR [NAME]");
  const std::string wanted = argc == 5 ? argv[4] : "";
  const std::filesystem::path path = argv[1], work = argv[3];
  const double epsilon = std::atof(argv[2]);
  const OrientedCloud cloud = load_oriented(path);
  const double millions = static_cast<double>(cloud.points.size()) / 1e6;
  std::vector<PlaneWay> ways{
      {"ilot, file to files", [&](const OrientedCloud&) { return whole_run(path, epsilon, work); }},
      {"ilot, file to planes", [&](const OrientedCloud&) { return cloud_to_planes(path, epsilon, work); }}};
  for (PlaneWay& peer : peers(cloud, epsilon))
    if (peer.name.find(wanted) != std::string::npos) ways.push_back(std::move(peer));
  std::vector<Found> found(ways.size());
  std::vector<Way> timed;
  for (std::size_t i = 0; i < ways.size(); ++i)
    timed.push_back({ways[i].name, [&, i] { found[i] = ways[i].detect(cloud); }});
  compare({"planes", "epsilon " + std::to_string(epsilon).substr(0, 5) + " m, " + in_millions(millions), 1, millions,
           "M points", millions > 2 ? 1 : 3},
          timed);
  for (std::size_t i = 0; i < ways.size(); ++i) report_planes(ways[i].name, found[i], cloud.points.size());
}

}  // namespace ilot::bench
