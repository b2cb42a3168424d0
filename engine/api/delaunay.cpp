// SPDX-License-Identifier: Apache-2.0
#include "ilot/delaunay.h"

#include <algorithm>
#include <cmath>
#include <string>

#include "engine/error.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/rings.h"

namespace ilot {
namespace {

constexpr double kSteps = 0x1p30;  // along the longer side: coordinates within kMaxPlaneCoordinate of the middle

struct PlaneLattice {
  std::vector<Point2> points;
  double step = 1;
};

struct Range {
  double min = 0, max = 0;
};

Range range_of(std::span<const double> values) {
  Range r{values[0], values[0]};
  for (const double v : values) {
    if (!(std::abs(v) <= 1e15)) throw Error("points: a coordinate is not finite, or beyond 1e15", ExitCode::usage);
    r = {std::min(r.min, v), std::max(r.max, v)};
  }
  return r;
}

double chosen_step(double length) {
  const double least = std::max(length / (kSteps - 4), 1e-9);
  for (int power = -9;; ++power)
    for (const double digit : {1.0, 2.0, 5.0}) {
      const double step = power < 0 ? digit / std::pow(10.0, -power) : digit * std::pow(10.0, power);
      if (step >= least) return step;
    }
}

PlaneLattice plane_lattice(std::span<const double> x, std::span<const double> y, double step) {
  if (x.size() != y.size()) throw Error("points: x and y have different lengths", ExitCode::usage);
  if (x.size() > (std::size_t{1} << 29)) throw Error("points: 2^29 at most", ExitCode::usage);
  PlaneLattice lattice;
  if (x.empty()) return lattice;
  const Range rx = range_of(x), ry = range_of(y);
  const double length = std::max(rx.max - rx.min, ry.max - ry.min);
  lattice.step = step == 0 ? chosen_step(length) : step;
  if (!(lattice.step > 0) || length > lattice.step * (kSteps - 4))
    throw Error("step " + std::to_string(step) + ": too fine for the extent of the points", ExitCode::usage);
  const double x0 = std::round((rx.min + rx.max) / 2 / lattice.step);
  const double y0 = std::round((ry.min + ry.max) / 2 / lattice.step);
  lattice.points.reserve(x.size());
  for (std::size_t i = 0; i < x.size(); ++i)
    lattice.points.push_back({static_cast<std::int32_t>(std::round(x[i] / lattice.step - x0)),
                              static_cast<std::int32_t>(std::round(y[i] / lattice.step - y0))});
  return lattice;
}

}  // namespace

Triangulation delaunay(std::span<const double> x, std::span<const double> y, double step) {
  return delaunay(plane_lattice(x, y, step).points);
}

AlphaShape alpha_shape(std::span<const double> x, std::span<const double> y, const AlphaShapeOptions& options) {
  if (!(options.reach > 0) || !std::isfinite(options.reach)) throw Error("reach: must be above 0", ExitCode::usage);
  const PlaneLattice lattice = plane_lattice(x, y, options.step);
  const Triangulation triangles = delaunay(lattice.points);
  const std::vector<float> reach(lattice.points.size(), static_cast<float>(options.reach / lattice.step));
  std::vector<std::uint8_t> keep = shape_triangles(triangles, lattice.points, {options.rule, reach});
  if (options.fill_holes) keep_enclosed(triangles, keep);
  const Polygons polygons = assemble_rings(boundary_edges(triangles, keep), lattice.points);
  AlphaShape shape;
  shape.polygons.resize(polygons.count);
  double area = 0;
  for (const Ring& ring : polygons.rings) {
    const auto first = polygons.vertices.begin() + ring.first;
    shape.polygons[ring.polygon].emplace_back(first, first + ring.count);
    area += 0.5 * static_cast<double>(twice_area(polygons, ring, lattice.points));
  }
  shape.area = area * lattice.step * lattice.step;
  return shape;
}

}  // namespace ilot
