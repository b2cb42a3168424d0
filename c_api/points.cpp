// SPDX-License-Identifier: Apache-2.0
// Functions over points in memory, over neighbours.h, clusters.h, plane_search.h and delaunay.h.
#include <algorithm>
#include <cmath>
#include <cstring>
#include <nlohmann/json.hpp>

#include "c_api/guard.h"
#include "ilot/clusters.h"
#include "ilot/delaunay.h"
#include "ilot/neighbours.h"
#include "ilot/plane_search.h"

namespace ilot::c {

namespace {

template <typename T>
void fill(T* to, const std::vector<T>& from) {
  std::copy(from.begin(), from.end(), to);
}

// Not a number: chosen from the points.
std::optional<double> given(double value) {
  return std::isnan(value) ? std::nullopt : std::optional<double>(value);
}

}  // namespace

}  // namespace ilot::c

using namespace ilot;
using namespace ilot::c;

extern "C" {

ilot_status ilot_nearest_neighbours(const double* x, const double* y, const double* z, size_t points, int32_t count,
                                    double max_distance, int32_t threads, uint32_t* index, float* distance) {
  return guarded([&] {
    need(index, "index");
    need(distance, "distance");
    const NeighbourTable table = nearest_neighbours(points_of(x, y, z, points), {count, max_distance, 0, threads});
    fill(index, table.index);
    fill(distance, table.distance);
    return ILOT_OK;
  });
}

ilot_status ilot_estimate_normals(const double* x, const double* y, const double* z, size_t points, int32_t count,
                                  double max_distance, int32_t threads, float* normals, float* curvature) {
  return guarded([&] {
    need(normals, "normals");
    const NormalArrays found = estimate_normals(points_of(x, y, z, points), {count, max_distance, 0, threads});
    for (std::size_t i = 0; i < points; ++i) {
      normals[3 * i] = found.x[i];
      normals[3 * i + 1] = found.y[i];
      normals[3 * i + 2] = found.z[i];
    }
    if (curvature != nullptr) fill(curvature, found.curvature);
    return ILOT_OK;
  });
}

ilot_status ilot_euclidean_clusters(const double* x, const double* y, const double* z, size_t points, double radius,
                                    uint32_t* id, uint32_t* clusters) {
  return guarded([&] {
    clear(clusters);
    need(id, "id");
    need(clusters, "clusters");
    const Clusters found = euclidean_clusters(points_of(x, y, z, points), radius);
    fill(id, found.id);
    *clusters = found.count;
    return ILOT_OK;
  });
}

ilot_status ilot_find_planes(const double* x, const double* y, const double* z, size_t points, double epsilon,
                             double normal_angle_deg, double connectivity, uint32_t min_points, uint64_t seed,
                             int32_t threads, uint32_t* label, double** planes, size_t* count) {
  return guarded([&] {
    clear(planes, count);
    need(label, "label");
    need(planes, "planes");
    need(count, "count");
    PlaneSearchOptions options;
    options.epsilon = given(epsilon);
    options.normal_angle_deg = given(normal_angle_deg);
    options.connectivity = given(connectivity);
    if (min_points > 0) options.min_points = min_points;
    options.seed = seed;
    options.threads = threads;
    const PlaneSegments found = find_planes(points_of(x, y, z, points), options).segments;
    auto* rows = static_cast<double*>(allocate(4 * sizeof(double) * found.planes.size()));
    for (std::size_t i = 0; i < found.planes.size(); ++i) {
      const Plane& p = found.planes[i];
      const double row[] = {p.n.x, p.n.y, p.n.z, p.d};
      std::copy(std::begin(row), std::end(row), rows + 4 * i);
    }
    fill(label, found.label);
    *planes = rows;
    *count = found.planes.size();
    return ILOT_OK;
  });
}

ilot_status ilot_delaunay(const double* x, const double* y, size_t points, uint32_t** corners, size_t* triangles) {
  return guarded([&] {
    clear(corners, triangles);
    need(x, "x");
    need(y, "y");
    need(corners, "corners");
    need(triangles, "triangles");
    const Triangulation made = delaunay({x, points}, {y, points});
    *corners = static_cast<std::uint32_t*>(allocate(made.corner.size() * sizeof(std::uint32_t)));
    fill(*corners, made.corner);
    *triangles = made.triangles();
    return ILOT_OK;
  });
}

ilot_status ilot_alpha_shape(const double* x, const double* y, size_t points, double reach, int32_t fill_holes,
                             char** json) {
  return guarded([&] {
    clear(json);
    need(x, "x");
    need(y, "y");
    need(json, "json");
    AlphaShapeOptions options;
    options.reach = reach;
    options.fill_holes = fill_holes != 0;
    const AlphaShape shape = alpha_shape({x, points}, {y, points}, options);
    *json = text_of({{"area", shape.area}, {"polygons", shape.polygons}});
    return ILOT_OK;
  });
}

}  // extern "C"
