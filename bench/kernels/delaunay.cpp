// SPDX-License-Identifier: Apache-2.0
// Delaunay triangulations and alpha shapes of points seen from above. peers/cgal_delaunay.cpp compares them with
// another library.
#include "kernels/delaunay/delaunay.h"

#include <algorithm>

#include "bench/compare.h"
#include "bench/plane_town.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/rings.h"
#include "kernels/delaunay/topology.h"

namespace {

using namespace ilot;

std::size_t ring_count(const bench::PlanePoints& set) {
  const Triangulation t = delaunay(set.points);
  const std::vector<float> reach(set.points.size(), set.reach);
  const auto keep = shape_triangles(t, set.points, {TriangleRule::kCircumradius, reach});
  return assemble_rings(boundary_edges(t, keep), set.points).rings.size();
}

}  // namespace

int main(int argc, char** argv) {
  for (const double millions : bench::numbers(argc, argv, {1}))
    for (const auto& set : bench::plane_points(static_cast<std::size_t>(millions * 1e6))) {
      const std::string variant = std::string(set.name) + ", " + bench::in_millions(millions);
      const Triangulation t = delaunay(set.points);
      bench::require(check_topology(t, set.points) == TopologyFault::kNone && is_delaunay(t, set.points),
                     "delaunay: not a Delaunay triangulation");
      bench::compare(
          {"delaunay", variant, 1, millions, "M points"},
          {{"ilot", [&] { delaunay(set.points); }}, {"ilot, with alpha shape and rings", [&] { ring_count(set); }}});
      bench::scaling({"delaunay", variant, 2, millions, "M points"}, [&] { delaunay(set.points); });
    }
}
