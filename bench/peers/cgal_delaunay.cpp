// SPDX-License-Identifier: Apache-2.0
// Delaunay triangulation and alpha shape compared with CGAL's, of the same points in the same order. The numbers of
// triangles must be equal before any timing.
#include <CGAL/Alpha_shape_2.h>
#include <CGAL/Alpha_shape_face_base_2.h>
#include <CGAL/Alpha_shape_vertex_base_2.h>
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include <algorithm>

#include "bench/compare.h"
#include "bench/plane_town.h"
#include "kernels/delaunay/alpha_shape.h"

namespace {

using namespace ilot;
using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel>;
using AlphaVertex = CGAL::Alpha_shape_vertex_base_2<Kernel>;
using AlphaFace = CGAL::Alpha_shape_face_base_2<Kernel>;
using AlphaDelaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<AlphaVertex, AlphaFace>>;
using AlphaShape = CGAL::Alpha_shape_2<AlphaDelaunay>;
using Given = std::vector<Kernel::Point_2>;

std::size_t ours(const bench::PlanePoints& set) {
  const Triangulation t = delaunay(set.points);
  const std::vector<float> reach(set.points.size(), set.reach);
  const auto keep = shape_triangles(t, set.points, {TriangleRule::kCircumradius, reach});
  return static_cast<std::size_t>(std::count(keep.begin(), keep.end(), 1));
}

std::size_t filtered(const Given& given, double reach) {
  const Delaunay t(given.begin(), given.end());
  std::size_t count = 0;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f)
    count += CGAL::squared_radius(f->vertex(0)->point(), f->vertex(1)->point(), f->vertex(2)->point()) <= reach * reach;
  return count;
}

std::size_t alpha_shape(const Given& given, double reach) {
  const AlphaShape shape(given.begin(), given.end(), reach * reach, AlphaShape::GENERAL);
  std::size_t count = 0;
  for (auto f = shape.finite_faces_begin(); f != shape.finite_faces_end(); ++f)
    count += shape.classify(f) == AlphaShape::INTERIOR;
  return count;
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1}))
    for (const auto& set : bench::plane_points(static_cast<std::size_t>(millions * 1e6))) {
      Given given;
      for (const Point2 p : set.points) given.emplace_back(p.x, p.y);
      const std::string variant = std::string(set.name) + ", " + bench::in_millions(millions);
      bench::require(delaunay(set.points).triangles() == Delaunay(given.begin(), given.end()).number_of_faces() &&
                         ours(set) == filtered(given, set.reach),
                     "delaunay: number of triangles differs from CGAL's");
      bench::compare({"delaunay", variant, 1, millions, "M points"},
                     {{"ilot", [&] { delaunay(set.points); }},
                      {"CGAL Delaunay_triangulation_2", [&] { Delaunay(given.begin(), given.end()); }}});
      bench::compare({"alpha_shape", variant, 1, millions, "M points"},
                     {{"ilot", [&] { ours(set); }},
                      {"CGAL Delaunay_triangulation_2 and a filter", [&] { filtered(given, set.reach); }},
                      {"CGAL Alpha_shape_2, which prepares every alpha", [&] { alpha_shape(given, set.reach); }}});
    }
}
