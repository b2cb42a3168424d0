// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/cluster_outline.h"

#include <algorithm>
#include <cmath>

#include "engine/products/roofs/sites/outline_repair.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/rings.h"
#include "kernels/outlines/regularise.h"

namespace ilot {
namespace {

constexpr std::size_t kMostPoints = std::size_t{1} << 18;
constexpr std::int32_t kThinning = 100;  // millimetres
// Choice: an outline through points is inside of the wall by half a step on average; 1.25 of them hide its steps.
constexpr double kStepsOfTolerance = 1.25;
// Choice: eaves are straight within 10 cm; above a metre small houses lose their corners.
constexpr double kLeastTolerance = 100, kMostTolerance = 1000;  // millimetres

// Returns the positions sorted, each once, and thinned where there are very many.
std::vector<Point2> places_of(std::span<const Point2> points) {
  std::vector<Point2> places(points.begin(), points.end());
  std::sort(places.begin(), places.end());
  places.erase(std::unique(places.begin(), places.end()), places.end());
  if (places.size() <= kMostPoints) return places;
  const auto cell = [](Point2 p) { return Point2{p.x / kThinning, p.y / kThinning}; };
  std::stable_sort(places.begin(), places.end(), [&](Point2 a, Point2 b) { return cell(a) < cell(b); });
  places.erase(std::unique(places.begin(), places.end(), [&](Point2 a, Point2 b) { return cell(a) == cell(b); }),
               places.end());
  return places;
}

double area_of_shape(const Triangulation& t, std::span<const Point2> places, std::span<const std::uint8_t> keep) {
  double twice = 0;
  for (std::size_t i = 0; i < t.triangles(); ++i)
    if (keep[i] != 0)
      twice += static_cast<double>(
          orient2d(places[t.corner[3 * i]], places[t.corner[3 * i + 1]], places[t.corner[3 * i + 2]]));
  return twice / 2;
}

// The rings of one polygon as positions, without holes smaller than an area.
SitePolygon polygon_of(const Polygons& all, std::uint32_t polygon, std::span<const Point2> places, double least_hole) {
  SitePolygon rings;
  for (const auto& r : all.rings) {
    if (r.polygon != polygon) continue;
    const double area = static_cast<double>(twice_area(all, r, places)) * 0.5e-6;
    if (!rings.empty() && -area < least_hole) continue;
    auto& ring = rings.emplace_back();
    for (std::uint32_t i = 0; i < r.count; ++i) ring.push_back(places[all.vertices[r.first + i]]);
  }
  return rings;
}

}  // namespace

std::vector<SitePolygon> cluster_outline(std::span<const Point2> points, const ClusterOutlineParams& params) {
  const std::vector<Point2> places = places_of(points);
  const Triangulation t = delaunay(places);
  if (t.triangles() == 0) return {};
  const std::vector<float> reach(places.size(), static_cast<float>(params.alpha));
  ShapeParams shape;
  shape.reach = reach;
  const std::vector<std::uint8_t> keep = shape_triangles(t, places, shape);
  const double step = std::sqrt(area_of_shape(t, places, keep) / static_cast<double>(places.size()));
  const Polygons boundary = assemble_rings(boundary_edges(t, keep), places);
  const RegulariseParams regular{std::clamp(kStepsOfTolerance * step, kLeastTolerance, kMostTolerance), step / 2};
  std::vector<SitePolygon> outlines;
  for (std::uint32_t p = 0; p < boundary.count; ++p) {
    const SitePolygon rings = polygon_of(boundary, p, places, params.least_courtyard);
    if (area_of(rings) < params.least_area) continue;
    for (SitePolygon& outline : repair_outline(regularise(rings, regular), params.least_area).polygons)
      outlines.push_back(std::move(outline));
  }
  std::stable_sort(outlines.begin(), outlines.end(),
                   [](const SitePolygon& a, const SitePolygon& b) { return area_of(a) > area_of(b); });
  return outlines;
}

}  // namespace ilot
