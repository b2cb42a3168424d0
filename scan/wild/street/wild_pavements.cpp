// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/street/wild_pavements.h"

#include <algorithm>
#include <cmath>

#include "kernels/outlines/hull.h"

namespace ilot::scan {
namespace {

constexpr double kOverHead = 2.2;  // metres above the base; what is higher is in nobody's way
constexpr double kTwigs = 1;       // metres; likewise, of the crowns of trees, which people push aside or walk around
constexpr double kFoot = 0.3;    // metres; branches begin higher, and their boxes reach far beyond what is low of them
constexpr double kGrain = 1e-4;  // metres, of outlines

// The part of an ellipsoid below a height, as a box.
Box3<Vec3> low_part(const Crown& leaf, double z) {
  const double up = z - leaf.centre.z;
  const double share = up >= 0 ? 1 : std::sqrt(std::max(0.0, 1 - up * up / (leaf.radii.z * leaf.radii.z)));
  const Vec3 half{share * leaf.radii.x, share * leaf.radii.y, leaf.radii.z};
  return {leaf.centre - half, leaf.centre + half};
}

}  // namespace

std::vector<Vec3> low_outline(const WildObject& object) {
  std::vector<Point2> corners;
  const auto add = [&](const Box3<Vec3>& box) {
    if (box.min.z >= kOverHead) return;
    for (const double x : {box.min.x, box.max.x})
      for (const double y : {box.min.y, box.max.y}) {
        const Vec3 at = object.pose.place({x, y, 0});
        corners.push_back({static_cast<std::int32_t>(std::lround(at.x / kGrain)),
                           static_cast<std::int32_t>(std::lround(at.y / kGrain))});
      }
  };
  for (const Solid& solid : object.shape.solids)
    if (!object.is_tree() || solid.bounds.min.z < kFoot) add(solid.bounds);
  for (const Crown& leaf : object.shape.leaves)
    if (!object.is_tree() || leaf.centre.z - leaf.radii.z < kTwigs)
      add(low_part(leaf, object.is_tree() ? kTwigs : kOverHead));
  std::vector<Vec3> ring;
  for (const std::uint32_t i : convex_hull(corners))
    ring.push_back({kGrain * corners[i].x, kGrain * corners[i].y, object.pose.base.z});
  return ring;
}

std::vector<TruePavement> true_pavements(const WildStreet& street) {
  std::vector<TruePavement> all;
  for (const StreetPlot& plot : street.plots) {
    if (plot.use == PlotUse::cross) continue;
    const double t = plot.side * street.half_road, inside = t + plot.side * 1e-3;
    const auto add = [&](double s0, double s1, bool faced) {
      if (s1 - s0 < 1e-6) return;
      TruePavement piece;
      piece.width = street.pavement;
      if (faced) piece.to_facade = street.pavement + plot.setback;
      std::vector<double> cuts{s0, s1};
      for (const ProfileKnot& knot : street.profile)
        if (knot.s > s0 && knot.s < s1) cuts.push_back(knot.s);
      std::sort(cuts.begin(), cuts.end());
      for (const double s : cuts) piece.line.push_back({s, t, street.ground_height(s, inside)});
      all.push_back(piece);
    };
    const bool house = plot.use == PlotUse::house;
    const double way = plot.passage ? plot.passage_width / 2 : 0, middle = plot.passage ? plot.passage_s : plot.s0;
    add(plot.s0, middle - way, house);
    if (plot.passage) add(middle - way, middle + way, false);
    add(middle + way, plot.s1, house);
  }
  return all;
}

std::vector<TrueCarriageway> true_carriageways(const WildStreet& street) {
  const auto rectangle = [](double s0, double s1, double t0, double t1) {
    return std::vector<Vec3>{{s0, t0, 0}, {s1, t0, 0}, {s1, t1, 0}, {s0, t1, 0}};
  };
  const double from = -kStreetBeyond, to = street.length + kStreetBeyond;
  std::vector<TrueCarriageway> all{{rectangle(from, to, -street.half_road, street.half_road)}};
  for (const GroundPatch& patch : street.patches) {
    if (patch.kind == GroundPatch::Kind::cross) all.push_back({rectangle(patch.s0, patch.s1, patch.t0, patch.t1)});
  }
  return all;
}

}  // namespace ilot::scan
