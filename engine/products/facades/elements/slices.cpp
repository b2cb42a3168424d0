// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/slices.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/products/facades/rays/value_stream.h"
#include "kernels/core/quantile.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/rings.h"

namespace ilot {
namespace {

// Derived: a tenth of the finest step of usual files, 1 mm.
constexpr double kCutLattice = 1e-4;  // metres; lattice for the triangulation of a cut
// Choice: one point in 200 on each side may be an outlier.
constexpr double kTailOfCut = 0.005;  // share of the points of a cut beyond its extent on each side
// Choice: half of the largest values; a front that is thinner than half of the densest one is not preferred.
constexpr double kEnough = 0.5;  // share of the largest ratio, and of the number of points there

std::size_t boundary_points(std::span<const Point2> points, double reach) {
  const Triangulation t = delaunay(points);
  const std::vector<float> reaches(points.size(), static_cast<float>(reach));
  ShapeParams shape;
  shape.reach = reaches;
  const std::vector<std::uint8_t> keep = shape_triangles(t, points, shape);
  std::vector<std::uint8_t> inside(points.size(), 0), rim(points.size(), 0);
  for (std::size_t i = 0; i < t.corner.size(); ++i) inside[t.corner[i]] |= keep[i / 3];
  for (const BoundaryEdge& e : boundary_edges(t, keep)) rim[e.from] = rim[e.to] = 1;
  std::size_t count = 0;  // a point in no triangle is on the boundary too; a point at the place of another is not
  for (const auto& [left_out, equal] : t.duplicates) inside[left_out] = 1;
  for (std::size_t i = 0; i < points.size(); ++i) count += rim[i] != 0 || inside[i] == 0;
  return count;
}

// The points of one cut.
struct Cut {
  std::size_t count = 0;
  std::vector<std::array<float, 2>> kept;  // u, v of the points that are kept
};

// Finds the cuts with which each point is consistent.
class Cuts {
 public:
  Cuts(const RaySamples& samples, const SliceRange& range, const SliceParams& params)
      : range_(range),
        params_(params),
        last_(static_cast<std::int64_t>(std::floor((range.to - range.from) / params.spacing + 0.5))) {
    const double deepest = std::max(std::abs(range.from), std::abs(range.to)) + params.spacing;
    around_ = range.box.grown(samples.oblique() ? 1.5 * deepest : 0);
  }
  const Box2& around() const { return around_; }  // the box in which rays to the box of the cuts cross the wall
  double w(std::int64_t cut) const { return range_.from + static_cast<double>(cut) * params_.spacing; }
  template <class Visit>
  void of(const Ray& ray, const Visit& visit) const {
    if (!range_.box.contains({ray.at.u, ray.at.v})) return;
    const double at = (static_cast<double>(ray.at.w) - range_.from) / params_.spacing;
    const auto first = static_cast<std::int64_t>(std::ceil(at - params_.within));
    for (std::int64_t cut = std::max<std::int64_t>(0, first);
         cut <= last_ && static_cast<double>(cut) <= at + params_.within; ++cut)
      visit(cut);
  }

 private:
  SliceRange range_;
  Box2 around_;
  const SliceParams& params_;
  std::int64_t last_;
};

int level_of(Rays& rays, const Cuts& cuts) {
  constexpr std::uint64_t kMostOfCut = 1 << 15, kMostOfAll = 1 << 17;  // points; 250 bytes each of a cut, 8 of all
  if (rays.size() <= kMostOfCut) return 0;
  std::map<std::int64_t, RankCounts> of_cut;
  RankCounts of_all;
  for (const Ray& ray : rays)
    cuts.of(ray, [&](std::int64_t cut) {
      of_cut[cut].add(ray);
      of_all.add(ray);
    });
  int level = of_all.level(kMostOfAll);
  for (const auto& [cut, counts] : of_cut) level = std::max(level, counts.level(kMostOfCut));
  return level;
}

FacadeSlice slice_of(double w, const Cut& cut, double reach) {
  FacadeSlice slice;
  slice.w = w;
  slice.points = cut.count;
  std::vector<double> u, v;
  std::vector<Point2> places;
  for (const auto& [at_u, at_v] : cut.kept) {
    u.push_back(at_u);
    v.push_back(at_v);
    places.push_back(lattice_point({u.back() / kCutLattice, v.back() / kCutLattice}, 1));
  }
  slice.boundary = boundary_points(places, reach / kCutLattice);
  slice.extent = {lower_quantile(u, kTailOfCut), lower_quantile(u, 1 - kTailOfCut), lower_quantile(v, kTailOfCut),
                  lower_quantile(v, 1 - kTailOfCut)};
  return slice;
}

}  // namespace

std::vector<FacadeSlice> slices_of(const RaySamples& samples, const SliceRange& range, const SliceParams& params) {
  const Cuts cuts(samples, range, params);
  Rays near = samples.near(cuts.around());
  const int level = level_of(near, cuts);
  std::map<std::int64_t, Cut> by_number;
  for (const Ray& ray : near)
    cuts.of(ray, [&](std::int64_t number) {
      Cut& cut = by_number[number];
      ++cut.count;
      if (is_kept(ray, level)) cut.kept.push_back({ray.at.u, ray.at.v});
    });
  const Box2& box = range.box;
  const Place2 steps = samples.step_at({(box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2});
  const double reach = params.reach_steps * std::max(steps.u, steps.v) * std::sqrt(std::ldexp(1.0, level));
  std::vector<FacadeSlice> slices;
  for (const auto& [number, cut] : by_number) {
    if (cut.kept.empty()) continue;
    slices.push_back(slice_of(cuts.w(number), cut, reach));
    slices.back().level = level;
  }
  return slices;
}

Box2 whole_extent(const RaySamples& samples, const SliceRange& range, const FacadeSlice& slice,
                  const SliceParams& params) {
  if (slice.level == 0) return slice.extent;
  const Cuts cuts(samples, range, params);
  const PlaceStream places = [&](const std::function<void(double, double)>& take) {
    for (const Ray& ray : samples.near(cuts.around()))
      cuts.of(ray, [&](std::int64_t cut) {
        if (cuts.w(cut) == slice.w) take(ray.at.u, ray.at.v);
      });
  };
  return box_of_places(places, slice.points, kTailOfCut);
}

std::optional<FacadeSlice> end_slice(std::span<const FacadeSlice> slices) {
  if (slices.empty()) return std::nullopt;
  const auto less = [](const FacadeSlice& a, const FacadeSlice& b) { return a.ratio() < b.ratio(); };
  const FacadeSlice best = *std::max_element(slices.begin(), slices.end(), less);
  std::optional<FacadeSlice> nearest;
  for (const FacadeSlice& s : slices) {
    const bool enough = s.ratio() >= kEnough * best.ratio() &&
                        static_cast<double>(s.points) >= kEnough * static_cast<double>(best.points);
    if (enough && (!nearest || std::abs(s.w) < std::abs(nearest->w))) nearest = s;
  }
  return nearest;
}

}  // namespace ilot
