// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/border_samples.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "kernels/delaunay/delaunay.h"
#include "kernels/geometry/point2.h"

namespace ilot {
namespace {

// Derived: a border is known to one step.
constexpr double kCreaseSteps = 1;  // steps; greatest distance of a border from the line of its planes
// Choice: gaps of wet tiles; wider gaps lose the ridge between their sides.
constexpr double kLongestSteps = 8, kLongestMetres = 3;  // longest edges that show a border

class BorderFinder {
 public:
  BorderFinder(const RoofSite& site, const RoofPlanes& planes) : site_(site), planes_(planes) {
    for (std::uint32_t i = 0; i < site.points.size(); ++i)
      if (planes.of_point[i] != 0) {
        points_.push_back(lattice_point({site.points[i].x, site.points[i].y}, 1000));
        from_.push_back(i);
      }
  }

  Borders find() {
    const Triangulation t = delaunay(points_);
    for (std::uint32_t e = 0; e < t.corner.size(); ++e) {
      const std::uint32_t from = t.corner[e], to = t.corner[next_edge(e)];
      if (t.twin[e] != kNoEdge && t.twin[e] < e) continue;
      if (planes_.of_point[from_[from]] != planes_.of_point[from_[to]]) see(from_[from], from_[to]);
    }
    return std::move(borders_);
  }

 private:
  void see(std::uint32_t p, std::uint32_t q) {
    const double longest = std::max(kLongestSteps * planes_.step, kLongestMetres);
    const Vec3 along = site_.points[q] - site_.points[p];
    const double length = std::sqrt(along.x * along.x + along.y * along.y);
    if (length > longest) return;
    std::uint32_t a = planes_.of_point[p] - 1, b = planes_.of_point[q] - 1;
    const RoofPlane& pa = planes_.planes[a];
    const RoofPlane& pb = planes_.planes[b];
    const Vec3 middle = site_.points[p] + 0.5 * along;
    const double apart = std::abs(pa.at(middle.x, middle.y) - pb.at(middle.x, middle.y));
    const double slope = std::sqrt((pa.gx - pb.gx) * (pa.gx - pb.gx) + (pa.gy - pb.gy) * (pa.gy - pb.gy));
    const double reach = std::max(kCreaseSteps * planes_.step, length);
    const bool crosses = slope >= kLeastSlopeChange && apart <= slope * reach;
    if (a > b) std::swap(a, b);
    if (site_.points[q].z > site_.points[p].z) std::swap(p, q);
    const FlatPoint upper = flat(site_.points[p]), lower = flat(site_.points[q]);
    if (crosses) {
      borders_.creases.push_back({flat(middle), a, b, upper, lower});
    } else {  // half a step from the upper point: what is farther away may be its shadow
      const double share = std::min(0.5, 0.5 * planes_.step / length);
      const FlatPoint at{upper.x + share * (lower.x - upper.x), upper.y + share * (lower.y - upper.y)};
      borders_.steps.push_back({at, a, b, upper, lower});
    }
  }

  static FlatPoint flat(Vec3 p) { return {p.x, p.y}; }

  const RoofSite& site_;
  const RoofPlanes& planes_;
  std::vector<Point2> points_;
  std::vector<std::uint32_t> from_;
  Borders borders_;
};

}  // namespace

Borders find_borders(const RoofSite& site, const RoofPlanes& planes) {
  return BorderFinder(site, planes).find();
}

}  // namespace ilot
