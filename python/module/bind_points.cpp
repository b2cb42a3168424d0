// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>

#include <optional>

#include "ilot/clusters.h"
#include "ilot/delaunay.h"
#include "ilot/neighbours.h"
#include "ilot/plane_search.h"
#include "python/module/arrays.h"
#include "python/module/bindings.h"

namespace ilot {

namespace {

py::tuple neighbours_python(const py::object& x, const py::object& y, const py::object& z, int count,
                            double max_distance, double step, int threads) {
  const PointArrays points = points_of(x, y, z);
  NeighbourTable table;
  {
    const py::gil_scoped_release released;
    table = nearest_neighbours(points, {count, max_distance, step, threads});
  }
  const std::vector<py::ssize_t> shape{static_cast<py::ssize_t>(points.x.size()), count};
  return py::make_tuple(array_from(std::move(table.index), shape), array_from(std::move(table.distance), shape));
}

py::tuple normals_python(const py::object& x, const py::object& y, const py::object& z, int count, double max_distance,
                         double step, int threads) {
  const PointArrays points = points_of(x, y, z);
  NormalArrays normals;
  {
    const py::gil_scoped_release released;
    normals = estimate_normals(points, {count, max_distance, step, threads});
  }
  return py::make_tuple(array_from(std::move(normals.x)), array_from(std::move(normals.y)),
                        array_from(std::move(normals.z)), array_from(std::move(normals.curvature)));
}

py::tuple clusters_python(const py::object& x, const py::object& y, const py::object& z, double radius, double step) {
  const PointArrays points = points_of(x, y, z);
  Clusters found;
  {
    const py::gil_scoped_release released;
    found = euclidean_clusters(points, radius, step);
  }
  return py::make_tuple(array_from(std::move(found.id)), found.count);
}

py::dict planes_python(const py::object& x, const py::object& y, const py::object& z,
                       const PlaneSearchOptions& options) {
  const PointArrays points = points_of(x, y, z);
  PlaneSearchResult found;
  {
    const py::gil_scoped_release released;
    found = find_planes(points, options);
  }
  std::vector<double> planes;
  for (const Plane& p : found.segments.planes) planes.insert(planes.end(), {p.n.x, p.n.y, p.n.z, p.d});
  const auto rows = static_cast<py::ssize_t>(found.segments.planes.size());
  py::dict out;
  out["label"] = array_from(std::move(found.segments.label));
  out["planes"] = array_from(std::move(planes), {rows, 4});
  out["epsilon"] = found.epsilon;
  out["normal_angle_deg"] = found.normal_angle_deg;
  out["connectivity"] = found.connectivity;
  out["min_points"] = found.min_points;
  return out;
}

py::array triangles_python(const py::object& x, const py::object& y, double step) {
  const auto xs = values_of<double>(x, "x"), ys = values_of<double>(y, "y");
  Triangulation made;
  {
    const py::gil_scoped_release released;
    made = delaunay(xs, ys, step);
  }
  const auto rows = static_cast<py::ssize_t>(made.triangles());
  return array_from(std::move(made.corner), {rows, 3});
}

py::tuple alpha_shape_python(const py::object& x, const py::object& y, double reach, bool fill_holes, double step) {
  const auto xs = values_of<double>(x, "x"), ys = values_of<double>(y, "y");
  AlphaShape shape;
  {
    const py::gil_scoped_release released;
    shape = alpha_shape(xs, ys, {reach, TriangleRule::kCircumradius, fill_holes, step});
  }
  py::list polygons;
  for (ShapePolygon& polygon : shape.polygons) {
    py::list rings;
    for (std::vector<std::uint32_t>& ring : polygon) rings.append(array_from(std::move(ring)));
    polygons.append(rings);
  }
  return py::make_tuple(polygons, shape.area);
}

}  // namespace

void bind_points(py::module_& m) {
  const py::arg x("x"), y("y"), z("z"), count("count"), max_distance("max_distance"), step("step"), threads("threads");
  m.def("nearest_neighbours", &neighbours_python, x, y, z, count, max_distance, step, threads);
  m.def("estimate_normals", &normals_python, x, y, z, count, max_distance, step, threads);
  m.def("euclidean_clusters", &clusters_python, x, y, z, py::arg("radius"), step);
  m.def("delaunay", &triangles_python, x, y, step);
  m.def("alpha_shape", &alpha_shape_python, x, y, py::arg("reach"), py::arg("fill_holes"), step);
  m.def(
      "find_planes",
      [](const py::object& xs, const py::object& ys, const py::object& zs, std::optional<double> epsilon,
         std::optional<double> normal_angle_deg, std::optional<std::uint32_t> min_points,
         std::optional<double> connectivity, double probability, std::uint64_t seed, double lattice_step, int workers) {
        PlaneSearchOptions options;
        options.epsilon = epsilon;
        options.normal_angle_deg = normal_angle_deg;
        options.min_points = min_points;
        options.connectivity = connectivity;
        options.probability = probability;
        options.seed = seed;
        options.step = lattice_step;
        options.threads = workers;
        return planes_python(xs, ys, zs, options);
      },
      x, y, z, py::arg("epsilon"), py::arg("normal_angle_deg"), py::arg("min_points"), py::arg("connectivity"),
      py::arg("probability"), py::arg("seed"), step, threads);
}

}  // namespace ilot
