// SPDX-License-Identifier: Apache-2.0
// Boundary error E [Lorraine thesis, 3.4.3] of the facades of a scanned building, as seen from their best station and
// from their best two. Compares thresholds that follow the sampling step, predicted or measured, with one threshold for
// the whole plane. This is done for alpha shapes and for the ends of long edges, at the best factor of each plane and
// at the factor 1. Usage: study_boundaries FILE [LEAST]
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "engine/compare/planes/boundary_error.h"
#include "engine/compare/planes/plane_frame.h"
#include "engine/formats/reader.h"
#include "kernels/core/quantile.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/rings.h"
#include "kernels/delaunay/sampling_step.h"
#include "kernels/outlines/edge_cells.h"
#include "study/edge_lengths.h"

namespace {

using namespace ilot;

constexpr double kSteps = 4000;  // lattice steps of the plane per metre
constexpr double kRadians = 0.017453292519943295;
constexpr int kNeighbours = 6;

struct ScannedPoint {
  Vec3 position;
  std::uint32_t station = 0;
};

struct Scan {
  std::map<std::uint32_t, std::vector<ScannedPoint>> of_plane;
  std::map<std::uint32_t, Scanner> stations;
  Truth truth;
  std::vector<Ring3> projecting;  // outlines of elements that project from the facades
};

std::uint32_t true_plane_of(const RecordLayout& layout, const std::byte* record) {
  std::uint32_t v = 0;
  for (const ExtraField& f : layout.extra)
    if (f.name == "true_plane") std::memcpy(&v, record + f.offset, std::min<std::size_t>(f.size, sizeof v));
  return v;
}

void read_points(const std::filesystem::path& file, Scan& scan) {
  const auto reader = open_cloud(file);
  const RecordLayout& l = reader->info().layout;
  constexpr std::uint64_t kBatch = 1 << 18;
  std::vector<std::byte> records(kBatch * l.record_length);
  std::vector<std::uint8_t> valid(kBatch);
  for (std::uint64_t first = 0; first < reader->info().points; first += kBatch) {
    const auto asked = static_cast<std::size_t>(std::min(kBatch, reader->info().points - first));
    const std::size_t got =
        reader->read(first, std::span(records).first(asked * l.record_length), std::span(valid).first(asked));
    for (std::size_t i = 0; i < got; ++i) {
      const std::byte* record = records.data() + i * l.record_length;
      const PointFields f = decode_fields(std::span(record, l.record_length), l.point_format);
      const std::uint32_t plane = true_plane_of(l, record);
      if (plane == 0) continue;
      const Vec3 p{f.x * l.scale[0] + l.offset[0], f.y * l.scale[1] + l.offset[1], f.z * l.scale[2] + l.offset[2]};
      scan.of_plane[plane].push_back({p, f.source_id});
    }
  }
}

Scan read_scan(const std::filesystem::path& file) {
  Scan scan;
  std::filesystem::path beside = file;
  beside.replace_extension(".truth.json");
  scan.truth = read_truth(beside);
  std::ifstream in(beside);
  const nlohmann::json truth = nlohmann::json::parse(in);
  for (const auto& s : truth.at("stations")) {
    const auto& p = s.at("position");
    scan.stations[s.at("id")] = {{p[0], p[1], p[2]},
                                 {0, 0, 1},
                                 s.at("step_horizontal_deg").get<double>() * kRadians,
                                 s.at("step_vertical_deg").get<double>() * kRadians};
  }
  for (const auto& e : truth.at("elements")) {
    if (e.at("depth_m").get<double>() <= 0) continue;
    Ring3& ring = scan.projecting.emplace_back();
    for (const auto& p : e.at("ring")) ring.push_back({p[0], p[1], p[2]});
  }
  read_points(file, scan);
  return scan;
}

// The wall also ends where an element projects from it.
TruePlane with_covers(TruePlane plane, const std::vector<Ring3>& projecting) {
  constexpr double kDepth = 0.5;
  for (Ring3 ring : projecting) {
    double farthest = 0;
    for (Vec3& p : ring) {
      const double d = signed_distance(plane.plane, p);
      farthest = std::max(farthest, std::abs(d));
      p = p - d * plane.plane.n;
    }
    if (farthest < kDepth) plane.polygons[0].holes.push_back(ring);
  }
  return plane;
}

// One facade as it is seen from some stations.
struct View {
  std::vector<Point2> places;
  std::vector<FlatPoint> flat;
  std::vector<FlatEdge> edges;
  std::vector<std::uint8_t> on_edge;               // Bm
  std::vector<float> predicted, measured, global;  // steps per point
  Triangulation t;
};

View view_of(const Scan& scan, const TruePlane& bare, const std::vector<std::uint32_t>& stations) {
  View v;
  const TruePlane plane = with_covers(bare, scan.projecting);
  const FlatFrame frame = plane_frame(plane.plane.n, plane.polygons[0].ring[0]);
  std::vector<Scanner> scanners;
  for (const std::uint32_t id : stations) scanners.push_back(scan.stations.at(id));
  for (Scanner& s : scanners) s.position = s.position - frame.origin;
  const Plane near{plane.plane.n, 0};
  for (const ScannedPoint& p : scan.of_plane.at(plane.id)) {
    if (std::find(stations.begin(), stations.end(), p.station) == stations.end()) continue;
    const FlatPoint f = frame.flat(p.position);
    v.flat.push_back(f);
    v.places.push_back(lattice_point(f, kSteps));
    v.predicted.push_back(static_cast<float>(kSteps * predicted_step(scanners, near, f.x * frame.u + f.y * frame.v)));
  }
  v.edges = true_edges(plane);
  v.on_edge = cells_on_edges(v.flat, v.edges);
  v.measured = measured_steps(v.places, kNeighbours, 1 << 20).step;
  v.global.assign(v.places.size(), upper_median(std::vector(v.measured)));
  v.t = delaunay(v.places);
  return v;
}

BoundaryCounts counts_of(const View& v, const std::vector<std::uint8_t>& marked) {
  BoundaryCounts c;
  for (std::size_t i = 0; i < marked.size(); ++i) {
    c.truth += v.on_edge[i];
    c.found += marked[i];
    c.common += v.on_edge[i] && marked[i];
  }
  return c;
}

std::vector<BoundaryEdge> shape_edges(const View& v, const std::vector<float>& step, double gamma) {
  std::vector<float> reach;
  for (const float s : step) reach.push_back(static_cast<float>(gamma * static_cast<double>(s)));
  return boundary_edges(v.t, shape_triangles(v.t, v.places, {TriangleRule::kCircumradius, reach}));
}

std::vector<std::uint8_t> alpha_boundary(const View& v, const std::vector<float>& step, double gamma) {
  std::vector<std::uint8_t> marked(v.places.size());
  for (const BoundaryEdge& e : shape_edges(v, step, gamma)) marked[e.from] = 1;
  return marked;
}

// Returns the ends of edges that are longer than gamma times the larger step of their ends.
std::vector<std::uint8_t> long_ends(const View& v, const std::vector<float>& step, double gamma) {
  std::vector<std::uint8_t> marked(v.places.size());
  for (std::uint32_t e = 0; e < v.t.corner.size(); ++e) {
    const std::uint32_t a = v.t.corner[e], b = v.t.corner[next_edge(e)];
    const double most = gamma * static_cast<double>(std::max(step[a], step[b]));
    if (static_cast<double>(squared_distance(v.places[a], v.places[b])) > most * most) marked[a] = marked[b] = 1;
  }
  return marked;
}

// Returns the mean distance of the rings at a factor from the true edges, in millimetres.
double ring_distance_mm(const View& v, const std::vector<float>& step, double gamma) {
  const Polygons rings = assemble_rings(shape_edges(v, step, gamma), v.places);
  double sum = 0, vertices = 0;
  for (const Ring& r : rings.rings) {
    std::vector<FlatPoint> ring;
    for (std::uint32_t i = 0; i < r.count; ++i) ring.push_back(v.flat[rings.vertices[r.first + i]]);
    sum += r.count * mean_ring_distance(ring, v.edges, 0.05);
    vertices += r.count;
  }
  return vertices > 0 ? 1000 * sum / vertices : 0;
}

using Marker = std::function<std::vector<std::uint8_t>(const View&, const std::vector<float>&, double)>;

struct Best {
  double gamma = 0;
  BoundaryCounts counts;
};

Best best_of(const View& v, const std::vector<float>& step, const Marker& mark) {
  Best best;
  for (int i = 8; i <= 60; ++i) {
    const double gamma = 0.05 * i;
    const BoundaryCounts c = counts_of(v, mark(v, step, gamma));
    if (best.gamma == 0 || c.error() < best.counts.error()) best = {gamma, c};
  }
  return best;
}

void print_view(const std::string& name, const View& v) {
  const std::pair<const char*, const std::vector<float>*> steps[] = {
      {"predicted", &v.predicted}, {"measured", &v.measured}, {"global", &v.global}};
  const auto n = std::count(v.on_edge.begin(), v.on_edge.end(), 1);
  for (const auto& [what, step] : steps) {
    const Best alpha = best_of(v, *step, alpha_boundary), length = best_of(v, *step, long_ends);
    const BoundaryCounts at_one = counts_of(v, alpha_boundary(v, *step, 1));
    fmt::print("| {} | {} | {} | {} | {:.2f} at {:.2f} | {:.2f} | {:.1f} | {:.1f} | {:.2f} at {:.2f} |\n", name,
               v.places.size(), n, what, alpha.counts.error(), alpha.gamma, at_one.error(),
               ring_distance_mm(v, *step, alpha.gamma), ring_distance_mm(v, *step, 1), length.counts.error(),
               length.gamma);
  }
  const double bend = slope_change(v.t, v.places);
  fmt::print("| {} | {} | {} | change of slope, {:.0f} mm | | | | | {:.2f} |\n", name, v.places.size(), n,
             bend / kSteps * 1000, counts_of(v, ends_of_long_edges(v.t, v.places, bend)).error());
}

// Returns the stations sorted by the number of points that they gave of the plane, most first.
std::vector<std::uint32_t> stations_of(const std::vector<ScannedPoint>& points) {
  std::map<std::uint32_t, std::size_t> count;
  for (const ScannedPoint& p : points) ++count[p.station];
  std::vector<std::uint32_t> ids;
  for (const auto& [id, n] : count) ids.push_back(id);
  std::stable_sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) { return count[a] > count[b]; });
  return ids;
}

}  // namespace

int main(int argc, char** argv) try {
  if (argc < 2) throw std::runtime_error("usage: study_boundaries FILE [LEAST POINTS OF A PLANE]");
  const Scan scan = read_scan(argv[1]);
  const std::size_t least = argc > 2 ? std::stoul(argv[2]) : 20000;
  fmt::print(
      "| plane, stations | points | true | step | alpha shape, E at best gamma | E at 1 | rings off, mm | at 1 | "
      "long edges, E at best |\n|---|---|---|---|---|---|---|---|---|\n");
  for (const TruePlane& plane : scan.truth.planes) {
    const auto points = scan.of_plane.find(plane.id);
    if (plane.class_name != "facade" || points == scan.of_plane.end() || points->second.size() < least) continue;
    const std::vector<std::uint32_t> ids = stations_of(points->second);
    for (std::size_t n = 1; n <= std::min<std::size_t>(2, ids.size()); ++n)
      print_view(fmt::format("{}, {}", plane.id, n == 1 ? "one" : "two"),
                 view_of(scan, plane, {ids.begin(), ids.begin() + static_cast<std::ptrdiff_t>(n)}));
  }
} catch (const std::exception& fault) {
  fmt::print(stderr, "study_boundaries: {}\n", fault.what());
  return 1;
}
