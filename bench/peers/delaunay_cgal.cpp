// SPDX-License-Identifier: Apache-2.0
// CGAL's triangulations are GPL: this file is for comparison only and is not part of what ships.
#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "bench/peers/delaunay.h"

namespace ilot::bench {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using AlphaVertex = CGAL::Alpha_shape_vertex_base_2<Kernel>;
using AlphaFace = CGAL::Alpha_shape_face_base_2<Kernel>;
using AlphaDelaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<AlphaVertex, AlphaFace>>;
using AlphaShape = CGAL::Alpha_shape_2<AlphaDelaunay>;

std::vector<Kernel::Point_2> converted(std::span<const Point2> points) {
  std::vector<Kernel::Point_2> all;
  all.reserve(points.size());
  for (const Point2 p : points) all.emplace_back(p.x, p.y);
  return all;
}

std::size_t delaunay_triangles(std::span<const Point2> points, double) {
  const auto given = converted(points);
  return Delaunay(given.begin(), given.end()).number_of_faces();
}

std::size_t filtered_triangles(std::span<const Point2> points, double reach) {
  const auto given = converted(points);
  const Delaunay t(given.begin(), given.end());
  std::size_t count = 0;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    count += CGAL::squared_radius(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()) <= reach * reach;
  return count;
}

std::size_t alpha_triangles(std::span<const Point2> points, double reach) {
  const auto given = converted(points);
  const AlphaShape shape(given.begin(), given.end(), reach * reach, AlphaShape::GENERAL);
  std::size_t count = 0;
  for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f)
    count += shape.classify(f) == AlphaShape::INTERIOR;
  return count;
}

}  // namespace

std::vector<ShapePeer> delaunay_peers() {
  return {{"CGAL Delaunay_triangulation_2", false, delaunay_triangles}};
}
std::vector<ShapePeer> alpha_shape_peers() {
  return {{"CGAL Delaunay_triangulation_2 and a filter", false, filtered_triangles},
          {"CGAL Alpha_shape_2", true, alpha_triangles}};
}

}  // namespace ilot::bench
