// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/slices.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "kernels/core/parallel.h"
#include "kernels/delaunay/alpha_shape.h"
#include "kernels/delaunay/rings.h"

namespace ilot {
namespace {

constexpr double kLattice = 1e-4;  // metres, of the triangulation of a cut
constexpr double kTail = 0.005;    // share of a cut's points beyond its extent on each side
constexpr double kEnough = 0.5;    // of the largest ratio and of the points there

double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

std::size_t boundary_points(std::span<const Point2> points, double reach) {
  const Triangulation t = delaunay(points);
  const std::vector<float> reaches(points.size(), static_cast<float>(reach));
  ShapeParams shape;
  shape.reach = reaches;
  const std::vector<std::uint8_t> keep = shape_triangles(t, points, shape);
  std::vector<std::uint8_t> inside(points.size(), 0), rim(points.size(), 0);
  for (std::size_t i = 0; i < t.corner.size(); ++i) inside[t.corner[i]] |= keep[i / 3];
  for (const BoundaryEdge& e : boundary_edges(t, keep)) rim[e.from] = rim[e.to] = 1;
  std::size_t count = 0;  // points that no triangle holds are boundary too, those at the same place are not
  for (const auto& [left_out, equal] : t.duplicates) inside[left_out] = 1;
  for (std::size_t i = 0; i < points.size(); ++i) count += rim[i] != 0 || inside[i] == 0;
  return count;
}

FacadeSlice slice_of(const FacadeSite& site, double w, std::span<const std::uint32_t> points, double reach) {
  FacadeSlice slice;
  slice.w = w;
  slice.points = points.size();
  std::vector<double> u, v;
  std::vector<Point2> places;
  for (const std::uint32_t i : points) {
    u.push_back(site.points[i].u);
    v.push_back(site.points[i].v);
    places.push_back({static_cast<std::int32_t>(std::lround(u.back() / kLattice)),
                      static_cast<std::int32_t>(std::lround(v.back() / kLattice))});
  }
  slice.boundary = boundary_points(places, reach / kLattice);
  slice.extent = {quantile(u, kTail), quantile(u, 1 - kTail), quantile(v, kTail), quantile(v, 1 - kTail)};
  return slice;
}

}  // namespace

std::vector<FacadeSlice> slices_of(const RaySamples& samples, const Box2& box, double from, double to,
                                   const SliceParams& params) {
  const FacadeSite& site = samples.site();
  const double deepest = std::max(std::abs(from), std::abs(to)) + params.spacing;
  std::map<std::int64_t, std::vector<std::uint32_t>> cuts;
  for (const std::uint32_t i : samples.near(box.grown(samples.oblique() ? 1.5 * deepest : 0))) {
    const FacadePoint& p = site.points[i];
    if (!box.holds({p.u, p.v})) continue;
    const double at = (static_cast<double>(p.w) - from) / params.spacing;
    const auto last = static_cast<std::int64_t>(std::floor((to - from) / params.spacing + 0.5));
    const auto first_cut = static_cast<std::int64_t>(std::ceil(at - params.within));
    for (std::int64_t cut = std::max<std::int64_t>(0, first_cut);
         cut <= last && static_cast<double>(cut) <= at + params.within; ++cut)
      cuts[cut].push_back(i);
  }
  const Place2 steps = samples.step_at({(box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2});
  std::vector<std::int64_t> numbers;
  for (const auto& [cut, points] : cuts) numbers.push_back(cut);
  std::vector<FacadeSlice> slices(numbers.size());
  parallel_for(numbers.size(), [&](std::size_t i) {
    slices[i] = slice_of(site, from + static_cast<double>(numbers[i]) * params.spacing, cuts.at(numbers[i]),
                         params.reach_steps * std::max(steps.u, steps.v));
  });
  return slices;
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
