// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/leaves/standing_leaves.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <utility>

#include "kernels/core/quantile.h"
#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

// Choice: a wide leaf of a door stands out by as much.
constexpr double kFarthestTip = 1.2;  // metres before the wall; segments that go on farther are none
constexpr double kShortestLeaf = 0.15, kLongestLeaf = 1.2;  // Choice: metres from the hinge to the tip
constexpr double kLowestLeaf = 0.4;                         // Choice: metres; brackets and the ends of sills are lower
// Derived: tangent of ten degrees: nearer to the wall a leaf is a flat plate.
constexpr double kLeastTurn = 0.17;  // tangent of the angle to the wall
// Choice: sides of bays, balconies and pilasters are square to the wall within three degrees; so is a leaf in thirty.
constexpr double kLeastSlant = 0.05;  // tangent of the angle to the normal of the wall
// Derived: normal noise stays within three standard deviations; louvres and panels add a centimetre.
constexpr double kLeafNoise = 3, kLeafRelief = 0.01;
constexpr double kLeafTail = 0.01;     // Choice: one point in a hundred at each end may be an outlier
constexpr double kLeafFill = 0.6;      // Choice: a majority; what stands before a leaf hides a third
constexpr std::size_t kLeafCells = 8;  // along each axis; a sixty-fourth of a leaf has points where a leaf has
constexpr std::size_t kFewestOnLeaf = 40;
constexpr std::uint64_t kMostOnLeaves = 1 << 18;  // points; more do not improve the result
// Choice: the two of a pair are made alike; one in five may hide a part of itself.
constexpr double kSameLength = 0.25;  // share of the length
// Choice: half a window each; narrow leaves leave a gap between them.
constexpr double kLeastPair = 1.6, kMostPair = 4;  // lengths of a leaf between both hinges
constexpr double kMostOfWidth = 1.1;  // Choice: a window with one leaf; lengths of a leaf over the width of its window
constexpr double kHingePlace = 0.02;  // Choice: as the comment of kHinge in openings.cpp has it: metres beside the jamb
constexpr double kSeenWall = 0.25;    // Choice: share of a place that is wall: none is between leaves of a window
constexpr double kLessThanWall = 0.06;  // Choice: metres beside a hinge that are not looked at for wall

struct LeafPoint {
  double u, v, w;
};

double quantile_of(std::vector<double> values, double share) {
  return lower_quantile(values, share);
}

// The leaf of a segment; no result where it is none.
std::optional<StandingLeaf> leaf_of(const std::vector<LeafPoint>& points, double noise, double step) {
  const auto count = static_cast<double>(points.size());
  double u = 0, w = 0, uu = 0, uw = 0, ww = 0;
  for (const LeafPoint& p : points) u += p.u / count, w += p.w / count;
  for (const LeafPoint& p : points)
    uu += (p.u - u) * (p.u - u), uw += (p.u - u) * (p.w - w), ww += (p.w - w) * (p.w - w);
  // The direction of the greatest scatter in the plan.
  const double half = (uu - ww) / 2, root = norm(FlatPoint{half, uw});
  double du = half + root, dw = uw;
  if (norm(FlatPoint{du, dw}) == 0) du = 0, dw = 1;
  const double length = norm(FlatPoint{du, dw});
  du /= length, dw /= length;
  if (dw < 0) du = -du, dw = -dw;
  const double rms = std::sqrt(std::max(0.0, (uu + ww) / 2 - root) / count);
  if (dw < kLeastTurn * std::abs(du) || std::abs(du) < kLeastSlant * dw ||
      rms > std::max(kLeafRelief, kLeafNoise * noise))
    return std::nullopt;
  std::vector<double> along, up;
  for (const LeafPoint& p : points) along.push_back((p.u - u) * du + (p.w - w) * dw), up.push_back(p.v);
  const double t0 = quantile_of(along, kLeafTail), t1 = quantile_of(along, 1 - kLeafTail);
  StandingLeaf leaf;
  leaf.low = quantile_of(up, kLeafTail), leaf.high = quantile_of(up, 1 - kLeafTail);
  leaf.hinge = {u + t0 * du, w + t0 * dw}, leaf.tip = {u + t1 * du, w + t1 * dw};
  leaf.error = step + 2 * noise + kHingePlace;
  leaf.points = points.size();
  const double high = leaf.high - leaf.low;
  if (leaf.hinge.v > kFlatRelief || t1 - t0 < kShortestLeaf || t1 - t0 > kLongestLeaf || high < kLowestLeaf ||
      high < t1 - t0)
    return std::nullopt;
  std::vector<std::uint8_t> cells(kLeafCells * kLeafCells, 0);
  const auto cell_of = [](double x, double from, double to) {
    return std::min(kLeafCells - 1, static_cast<std::size_t>(std::max(0.0, (x - from) / (to - from) * kLeafCells)));
  };
  for (std::size_t i = 0; i < points.size(); ++i)
    cells[cell_of(up[i], leaf.low, leaf.high) * kLeafCells + cell_of(along[i], t0, t1)] = 1;
  const auto filled = static_cast<double>(std::count(cells.begin(), cells.end(), 1));
  return filled >= kLeafFill * static_cast<double>(cells.size()) ? std::optional(leaf) : std::nullopt;
}

// The share of a box that is wall.
double wall_share(const RaySamples& samples, const Box2& box) {
  if (box.width() <= 0 || box.height() <= 0) return 0;
  double wall = 0;
  for (const Ray& ray : samples.near(box)) wall += samples.on_wall(ray) && box.contains(samples.crossing(ray, 0));
  const Place2 steps = samples.step_at({(box.u0 + box.u1) / 2, (box.v0 + box.v1) / 2});
  return wall * steps.u * steps.v / (box.width() * box.height());
}

bool same_span(double a0, double a1, double b0, double b1, double within) {
  return std::abs(a0 - b0) <= within && std::abs(a1 - b1) <= within;
}

FoundRectangle rectangle_of_leaf(const StandingLeaf& leaf) {
  FoundRectangle r;
  r.side(Side::left) = {std::min(leaf.hinge.u, leaf.tip.u), leaf.error};
  r.side(Side::right) = {std::max(leaf.hinge.u, leaf.tip.u), leaf.error};
  r.side(Side::bottom) = {leaf.low, leaf.error};
  r.side(Side::top) = {leaf.high, leaf.error};
  for (LocatedEdge& edge : r.sides) edge.inner = edge.at, edge.points = leaf.points;
  r.depth = leaf.tip.v, r.depth_error = leaf.error;
  r.points = leaf.points;
  return r;
}

FoundRectangle window_of_pair(const StandingLeaf& a, const StandingLeaf& b) {
  FoundRectangle window;
  const auto put = [&](Side side, double at, double error) {
    window.side(side) = {at, error};
    window.side(side).inner = at;
    window.side(side).points = a.points + b.points;
  };
  put(Side::left, a.hinge.u, a.error), put(Side::right, b.hinge.u, b.error);
  put(Side::bottom, std::min(a.low, b.low), std::max(a.error, b.error));
  put(Side::top, std::max(a.high, b.high), std::max(a.error, b.error));
  window.points = a.points + b.points;
  return window;
}

bool are_pair(const RaySamples& samples, const StandingLeaf& a, const StandingLeaf& b, double alike) {
  const double apart = b.hinge.u - a.hinge.u, longer = std::max(a.length(), b.length());
  if (apart < kLeastPair * longer || apart > kMostPair * longer ||
      std::abs(a.length() - b.length()) > kSameLength * longer ||
      !same_span(a.low, a.high, b.low, b.high, alike + a.error + b.error))
    return false;
  const Box2 between{a.hinge.u + kLessThanWall, b.hinge.u - kLessThanWall, std::max(a.low, b.low) + kLessThanWall,
                     std::min(a.high, b.high) - kLessThanWall};
  return wall_share(samples, between) <= kSeenWall;
}

// Widens an opening to the hinge of a leaf that hides its side; no result where they do not belong together.
bool widen_to(const RaySamples& samples, const StandingLeaf& leaf, double alike, FoundRectangle& o) {
  const double within = alike + leaf.error + std::max(o.error(Side::top), o.error(Side::bottom));
  // Leaves end where an arch begins, at most half of the width below its crown, or all of it below a point.
  const double top = o.at(Side::top) - (o.pointed ? 1 : o.arc ? 0.5 : 0) * o.box().width();
  if (std::abs(leaf.low - o.at(Side::bottom)) > within || leaf.high > o.at(Side::top) + within ||
      leaf.high < top - within)
    return false;
  for (const Side side : {Side::left, Side::right}) {
    const double beyond = outwards(side) * (leaf.hinge.u - o.at(side));
    if (beyond < -within || beyond > leaf.length()) continue;
    if (leaf.length() > kMostOfWidth * (o.box().width() + std::max(0.0, beyond))) continue;
    if (beyond <= o.error(side)) return true;
    const double from = std::min(leaf.hinge.u, o.at(side)), to = std::max(leaf.hinge.u, o.at(side));
    if (wall_share(samples, {from, to, leaf.low, leaf.high}) > kSeenWall) continue;
    LocatedEdge& edge = o.side(side);
    edge = {leaf.hinge.u, leaf.error};
    edge.inner = edge.at, edge.points = leaf.points;
    return true;
  }
  return false;
}

}  // namespace

std::vector<StandingLeaf> find_standing_leaves(const RaySamples& samples) {
  const FacadeSite& site = samples.site();
  std::vector<std::uint32_t> known = site.wall;
  for (const ParallelPlane& p : site.parallel) known.push_back(p.id);
  std::sort(known.begin(), known.end());
  const double least = std::max(0.02, 2 * site.epsilon);
  const auto counts = [&](const Ray& ray) {
    const double w = ray.at.w;
    return ray.at.plane != 0 && w > least && w < 2 * kFarthestTip &&
           !std::binary_search(known.begin(), known.end(), ray.at.plane);
  };
  Rays all = samples.all();
  const int level = thinning_level(all, kMostOnLeaves, counts);
  std::map<std::uint32_t, std::vector<LeafPoint>> segments;
  for (const Ray& ray : all)
    if (counts(ray) && is_kept(ray, level)) segments[ray.at.plane].push_back({ray.at.u, ray.at.v, ray.at.w});
  std::vector<StandingLeaf> leaves;
  for (const auto& [id, points] : segments) {
    if (points.size() < kFewestOnLeaf) continue;
    const auto leaf = leaf_of(points, site.noise, site.step);
    if (leaf) leaves.push_back(*leaf);
  }
  std::sort(leaves.begin(), leaves.end(), [](const StandingLeaf& a, const StandingLeaf& b) {
    return std::pair(a.hinge.u, a.low) < std::pair(b.hinge.u, b.low);
  });
  return leaves;
}

HalfOpen windows_of_leaves(const RaySamples& samples, const std::vector<StandingLeaf>& leaves, double alike,
                           std::vector<FoundRectangle>& openings) {
  HalfOpen half;
  std::vector<bool> taken(leaves.size(), false);
  for (std::size_t a = 0; a < leaves.size(); ++a)
    for (std::size_t b = a + 1; b < leaves.size() && !taken[a]; ++b) {
      if (taken[b] || !are_pair(samples, leaves[a], leaves[b], alike)) continue;
      taken[a] = taken[b] = true;
      half.leaves.push_back(rectangle_of_leaf(leaves[a]));
      half.leaves.push_back(rectangle_of_leaf(leaves[b]));
      FoundRectangle window = window_of_pair(leaves[a], leaves[b]);
      const Box2 box = window.box();
      const auto inside = [&](const FoundRectangle& o) {
        const Box2 own = o.box();
        return 2 * common_area(own, box) > own.width() * own.height();
      };
      for (const FoundRectangle& o : openings)
        if (inside(o)) {
          window.depth = o.depth, window.depth_error = o.depth_error, window.no_echo |= o.no_echo;
          // A head that was seen above the leaves is that of the window.
          if (o.at(Side::top) > window.at(Side::top)) {
            window.side(Side::top) = o.side(Side::top);
            window.arc = o.arc, window.pointed = o.pointed;
          }
          if (o.at(Side::bottom) < window.at(Side::bottom)) window.side(Side::bottom) = o.side(Side::bottom);
        }
      std::erase_if(openings, inside);
      half.windows.push_back(window);
    }
  for (std::size_t i = 0; i < leaves.size(); ++i) {
    if (taken[i]) continue;
    const auto of = std::find_if(openings.begin(), openings.end(),
                                 [&](FoundRectangle& o) { return widen_to(samples, leaves[i], alike, o); });
    if (of != openings.end()) half.leaves.push_back(rectangle_of_leaf(leaves[i]));
  }
  return half;
}

}  // namespace ilot
