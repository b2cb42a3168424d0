// SPDX-License-Identifier: Apache-2.0
#include "kernels/plane_methods/roof_ransac.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numeric>
#include <optional>

#include "kernels/core/rng.h"
#include "kernels/geometry/padded_points.h"
#include "kernels/neighbours/clusters.h"
#include "kernels/planes/plane_fit.h"
#include "kernels/planes/plane_score.h"
#include "kernels/planes/refine.h"
#include "kernels/planes/relabel.h"

namespace ilot {
namespace {

using Indices = std::vector<std::uint32_t>;

// The points that have no plane yet, compact and padded as Points requires.
struct Remaining : PaddedPoints {
  Indices index;
};

Remaining remaining_points(Points p, const std::vector<std::uint32_t>& label) {
  Remaining r;
  for (std::uint32_t i = 0; i < p.size; ++i) {
    if (label[i] != 0) continue;
    r.add(p.x[i], p.y[i], p.z[i]);
    r.index.push_back(i);
  }
  r.pad();
  return r;
}

// Returns the ring of nearest points around the centre, from the inner-th to the outer-th, ties by index.
Indices ring_around(Points p, std::uint32_t centre, const RoofRansacParams& params) {
  std::vector<std::pair<double, std::uint32_t>> near(p.size);
  for (std::uint32_t i = 0; i < p.size; ++i) {
    const double dx = p.x[i] - p.x[centre], dy = p.y[i] - p.y[centre], dz = p.z[i] - p.z[centre];
    near[i] = {dx * dx + dy * dy + dz * dz, i};
  }
  const auto at = [&](std::size_t n) { return near.begin() + static_cast<std::ptrdiff_t>(std::min(n, near.size())); };
  if (near.size() > params.outer) std::nth_element(near.begin(), at(params.outer), near.end());
  std::nth_element(near.begin(), at(params.inner), at(params.outer));
  Indices ring;
  for (auto n = at(params.inner); n < at(params.outer); ++n) ring.push_back(n->second);
  std::sort(ring.begin(), ring.end());  // the order within the ring must not depend on the selection's
  return ring;
}

class Search {
 public:
  Search(Points points, const RoofRansacParams& params) : points_(points), params_(params), rng_(params.key) {
    result_.label.assign(points.size, 0);
  }

  PlaneSegments run() {
    for (;;) {
      const Remaining rest = remaining_points(points_, result_.label);
      if (rest.index.size() < std::max(params_.min_remaining, params_.outer) || !take_one(rest)) break;
    }
    return std::move(result_);
  }

 private:
  std::optional<PlaneHypothesis> draw(Points p) {
    const auto centre = static_cast<std::uint32_t>(rng_.below(p.size));
    const Indices ring = ring_around(p, centre, params_);
    std::array<Vec3, 3> v;
    for (Vec3& q : v) {
      const std::uint32_t i = ring[rng_.below(ring.size())];
      q = {p.x[i], p.y[i], p.z[i]};
    }
    const Vec3 a = v[1] - v[0], b = v[2] - v[0], n = cross(a, b);
    // Derived: 6 degrees; at less, noise turns the plane of three points freely.
    constexpr double kThinnest = 0.1;  // sine of the angle at the first point
    const double length = norm(n);
    if (!(length > kThinnest * norm(a) * norm(b))) return std::nullopt;
    const Vec3 unit = (1 / length) * n;
    return PlaneHypothesis{static_cast<float>(unit.x), static_cast<float>(unit.y), static_cast<float>(unit.z),
                           static_cast<float>(-dot(unit, v[0]))};
  }

  // Draws until a plane with enough connected points is found. Returns false after too many draws in a row without one.
  bool take_one(const Remaining& rest) {
    std::vector<PlaneHypothesis> hypotheses;
    for (std::uint32_t d = 0; d < params_.draws; ++d)
      if (const auto h = draw(rest.points())) hypotheses.push_back(*h);
    std::vector<std::uint32_t> counts(hypotheses.size());
    count_inliers({rest.points()}, hypotheses, {static_cast<float>(params_.epsilon), 0}, counts);
    Indices order(hypotheses.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t a, std::uint32_t b) { return counts[a] > counts[b]; });
    for (const std::uint32_t h : order) {
      if (counts[h] < params_.min_points) break;
      const PlaneHypothesis& p = hypotheses[h];
      if (take(rest, {{p[0], p[1], p[2]}, p[3]})) return true;
    }
    return false;
  }

  Indices without_strays(const Indices& members) const {
    const Clusters clusters = euclidean_clusters(points_, members, params_.stray_gap);
    Indices size(clusters.count, 0), part;
    for (const std::uint32_t c : clusters.id) ++size[c];
    if (size.empty()) return part;
    const auto largest = static_cast<std::uint32_t>(std::max_element(size.begin(), size.end()) - size.begin());
    for (std::size_t i = 0; i < members.size(); ++i)
      if (clusters.id[i] == largest) part.push_back(members[i]);
    return part;
  }

  bool take(const Remaining& rest, const Plane& start) {
    const RefineParams refine{params_.epsilon, 0, params_.min_points};
    Indices members = without_strays(consensus_set({points_}, rest.index, start, refine));
    if (members.size() < params_.min_points) return false;
    const PlaneFit fit = fit_plane(moments_of(points_, members));
    if (!fit.unique) return false;
    const RefinedPlane r = refine_plane({points_}, rest.index, fit.plane, refine);
    members = without_strays(r.members);
    if (members.size() < params_.min_points) return false;
    result_.planes.push_back(r.plane);
    for (const std::uint32_t i : members) result_.label[i] = static_cast<std::uint32_t>(result_.planes.size());
    return true;
  }

  Points points_;
  RoofRansacParams params_;
  Rng rng_;
  PlaneSegments result_;
};

// Removes the labels of planes with too few points, and closes up the numbers.
void drop_small(PlaneSegments& s, std::uint32_t min_points) {
  std::vector<std::uint32_t> size(s.planes.size() + 1, 0), number(s.planes.size() + 1, 0);
  for (const std::uint32_t l : s.label) ++size[l];
  std::vector<Plane> planes;
  for (std::size_t p = 1; p < size.size(); ++p) {
    if (size[p] < min_points) continue;
    planes.push_back(s.planes[p - 1]);
    number[p] = static_cast<std::uint32_t>(planes.size());
  }
  for (std::uint32_t& l : s.label) l = number[l];
  s.planes = std::move(planes);
}

}  // namespace

PlaneSegments roof_ransac(Points points, const NeighbourLists& neighbours, const RoofRansacParams& params) {
  assert(params.outer > params.inner + 2 && params.min_points >= 3);
  PlaneSegments s = Search(points, params).run();
  for (Plane& p : s.planes) {
    const bool down = p.n.z < 0 || (p.n.z == 0 && (p.n.y < 0 || (p.n.y == 0 && p.n.x < 0)));
    if (down) p = {-1.0 * p.n, -p.d};
  }
  relabel_islands(points, neighbours, {params.epsilon, params.stray_gap}, s);
  drop_small(s, params.min_points);
  return s;
}

}  // namespace ilot
