// SPDX-License-Identifier: Apache-2.0
// CGAL's triangulation is GPL. This file is only for comparison and is not part of the released program.
#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>

#include "tests/oracles/delaunay_peer.h"

namespace ilot::test {

std::optional<std::vector<PlacedTriangle>> peer_triangles(const std::vector<Point2>& points) {
  using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
  std::vector<Kernel::Point_2> given;
  for (const Point2 p : points) given.emplace_back(p.x, p.y);
  const CGAL::Delaunay_triangulation_2<Kernel> t(given.begin(), given.end());
  std::vector<PlacedTriangle> all;
  for (auto f = t.finite_faces_begin(); f != t.finite_faces_end(); ++f) {
    const auto corner = [&](int i) {
      const auto& p = f->vertex(i)->point();
      return Point2{static_cast<std::int32_t>(p.x()), static_cast<std::int32_t>(p.y())};
    };
    all.push_back(placed(corner(0), corner(1), corner(2)));
  }
  std::sort(all.begin(), all.end());
  return all;
}

}  // namespace ilot::test
