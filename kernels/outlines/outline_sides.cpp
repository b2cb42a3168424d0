// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/outline_sides.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"
#include "kernels/outlines/side_split.h"

namespace ilot {
namespace {

using Loop = std::vector<Point2>;

constexpr int kMostDirections = 3;
// Choice: the error of edges of five steps; houses whose sides differ by less in direction become rectangular.
constexpr double kAgreeing = 8;  // degrees between edges that vote for one main direction
// Choice: an edge that would turn by more has a direction of its own.
constexpr double kMostTurn = 20;  // degrees that an edge is turned at most
// Derived: at 15 degrees the corner is 4 tolerances away, the bound of regularise.cpp.
constexpr double kSharpest = 15;  // degrees; lines that meet at less have no corner of their own
// Derived: an edge of 4 tolerances has a direction to 14 degrees, below kMostTurn.
constexpr double kLongEnough = 4;  // tolerances; edges that can call for a direction of their own

// Choice: 0.23 (1 / 1.25 / sqrt(12)) for boundary points that end anywhere within a step of their edge, where the
// tolerance is 1.25 steps, and as much for walls that are not quite straight. With 0.23 alone sides are cut by steps
// that no one draws, with 0.7 bays are lost.
constexpr double kScatter = 0.35;  // tolerances; standard deviation of boundary points across an edge

// Multiplies as complex numbers, so angles add.
FlatPoint times(FlatPoint a, FlatPoint b) {
  return {a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x};
}
// Halves the angle of a unit vector, which is within (-180, 180] degrees.
FlatPoint half_angle(FlatPoint a) {
  const double c = std::sqrt(std::max(0.0, (1 + a.x) / 2)), s = std::sqrt(std::max(0.0, (1 - a.x) / 2));
  return {c, a.y < 0 ? -s : s};
}
FlatPoint unit(FlatPoint a) {
  const double n = norm(a);
  return n > 0 ? (1 / n) * a : FlatPoint{1, 0};
}
FlatPoint flat(Point2 p) {
  return {static_cast<double>(p.x), static_cast<double>(p.y)};
}

// Returns the vertex of [first, last) of the ring that is farthest from the edge between their ends. Indices continue
// beyond the end of the ring.
std::size_t farthest(const Loop& ring, std::size_t first, std::size_t last, double& most) {
  const FlatPoint a = flat(ring[first % ring.size()]), b = flat(ring[last % ring.size()]);
  std::size_t best = first;
  most = 0;
  for (std::size_t i = first + 1; i < last; ++i) {
    const double d2 = squared_distance(flat(ring[i % ring.size()]), {a, b});
    if (d2 > most) most = d2, best = i;
  }
  return best;
}

// Returns ascending vertices between which the ring stays within the tolerance of straight edges.
std::vector<std::size_t> break_points(const Loop& ring, double tolerance) {
  const std::size_t n = ring.size();
  const auto far_from = [&](std::size_t from) {
    std::size_t best = from;
    for (std::size_t i = 0; i < n; ++i)
      if (squared_distance(ring[from], ring[i]) > squared_distance(ring[from], ring[best])) best = i;
    return best;
  };
  const auto squared = [](double v) { return v * v; };
  const std::size_t a = far_from(0), b = far_from(a);
  std::vector<std::size_t> breaks{std::min(a, b), std::max(a, b)};
  std::vector<std::pair<std::size_t, std::size_t>> stack{{breaks[0], breaks[1]}, {breaks[1], breaks[0] + n}};
  while (!stack.empty()) {
    const auto [first, last] = stack.back();
    stack.pop_back();
    double most = 0;
    const std::size_t at = farthest(ring, first, last, most);
    if (most <= squared(tolerance)) continue;
    breaks.push_back(at % n);
    stack.push_back({first, at});
    stack.push_back({at, last});
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

// Fits a line to the vertices of an edge by total least squares. The ends belong to corners and count only where there
// are few other vertices.
OutlineSide fit_side(const Loop& ring, std::size_t first, std::size_t last) {
  const std::size_t n = ring.size();
  OutlineSide side;
  side.from = flat(ring[first % n]);
  side.to = flat(ring[last % n]);
  side.length = norm(side.to - side.from);
  side.direction = unit(side.to - side.from);
  if (last - first >= 4) ++first, --last;
  FlatPoint sum;
  for (std::size_t i = first; i <= last; ++i) sum = sum + flat(ring[i % n]);
  side.centre = (1 / static_cast<double>(last - first + 1)) * sum;
  if (last - first < 2) return side;
  double xx = 0, yy = 0, xy = 0;
  for (std::size_t i = first; i <= last; ++i) {
    const FlatPoint d = flat(ring[i % n]) - side.centre;
    xx += d.x * d.x;
    yy += d.y * d.y;
    xy += d.x * d.y;
  }
  const FlatPoint twice{xx - yy, 2 * xy};
  if (!(norm(twice) > 0)) return side;
  const FlatPoint fitted = half_angle(unit(twice));
  const double along = dot(fitted, side.direction);
  if (std::abs(along) > 0.7) side.direction = along > 0 ? fitted : -1 * fitted;
  if (last - first >= 3)
    side.scatter2 = std::max(0.0, (xx + yy - norm(twice)) / 2 / static_cast<double>(last - first + 1));
  return side;
}

// Returns four times the angle, so that perpendicular directions are the same.
FlatPoint fourfold(FlatPoint direction) {
  const FlatPoint twice = times(direction, direction);
  return times(twice, twice);
}

// Finds the direction of most of the length of sides without a family, with four times its angle. Returns false when
// fewer than `least` sides agree.
bool main_direction(const std::vector<std::vector<OutlineSide>>& rings, double least_length, int least,
                    FlatPoint& fourfold_of) {
  const double agreeing = cos_degrees(4 * kAgreeing);
  std::vector<std::pair<FlatPoint, double>> voters;
  for (const auto& sides : rings)
    for (const OutlineSide& s : sides)
      if (s.family < 0 && s.length >= least_length) voters.emplace_back(fourfold(s.direction), s.length * s.length);
  double best = 0;
  for (const auto& [candidate, unused] : voters) {
    double votes = 0;
    int count = 0;
    FlatPoint sum;
    for (const auto& [q, weight] : voters) {
      if (dot(q, candidate) < agreeing) continue;
      votes += weight;
      sum = sum + weight * q;
      ++count;
    }
    if (count < least || votes <= best) continue;
    best = votes;
    fourfold_of = unit(sum);
  }
  return best > 0;
}

// Turns the sides parallel or perpendicular to the direction where that moves their ends by no more than the tolerance.
void turn_sides(std::vector<std::vector<OutlineSide>>& rings, FlatPoint direction, int family, double tolerance) {
  const double most_turn = cos_degrees(kMostTurn);
  const FlatPoint axes[4]{
      direction, {-direction.y, direction.x}, {-direction.x, -direction.y}, {direction.y, -direction.x}};
  for (auto& sides : rings) {
    for (OutlineSide& s : sides) {
      if (s.family >= 0) continue;
      for (const FlatPoint axis : axes) {
        if (dot(axis, s.direction) < most_turn) continue;
        if (std::abs(cross(axis, s.direction)) * s.length / 2 > tolerance) continue;
        s.direction = axis;
        s.family = family;
        break;
      }
    }
  }
}

// Returns the main directions of rough sides, each followed by the direction perpendicular to it.
std::vector<FlatPoint> main_axes(std::span<const Loop> rings, double tolerance) {
  std::vector<std::vector<OutlineSide>> rough;
  for (const Loop& ring : rings) {
    auto& sides = rough.emplace_back();
    const std::vector<std::size_t> breaks = break_points(ring, tolerance);
    for (std::size_t i = 0; i < breaks.size(); ++i)
      sides.push_back(fit_side(ring, breaks[i], i + 1 < breaks.size() ? breaks[i + 1] : breaks[0] + ring.size()));
  }
  std::vector<FlatPoint> axes;
  for (int family = 0; family < kMostDirections; ++family) {
    FlatPoint q;
    if (!main_direction(rough, family == 0 ? 0 : kLongEnough * tolerance, family == 0 ? 1 : 2, q)) break;
    const FlatPoint direction = half_angle(half_angle(q));
    turn_sides(rough, direction, family, tolerance);
    axes.push_back(direction);
    axes.push_back({-direction.y, direction.x});
  }
  return axes;
}

// The side of a stretch of the ring, on an axis or in the direction of its vertices.
OutlineSide side_of(const Loop& ring, const SideSpan& span, std::span<const FlatPoint> axes) {
  const std::size_t n = ring.size(), last = span.first + span.count - 1;
  OutlineSide side = fit_side(ring, span.first, last);
  side.from = 0.5 * (flat(ring[(span.first + n - 1) % n]) + flat(ring[span.first]));
  side.to = 0.5 * (flat(ring[last % n]) + flat(ring[(last + 1) % n]));
  side.length = norm(side.to - side.from);
  if (span.axis == kOwnDirection) {
    if (span.count == 1) side.direction = unit(side.to - side.from);
    return side;
  }
  const FlatPoint axis = axes[static_cast<std::size_t>(span.axis)];
  side.direction = dot(side.to - side.from, axis) < 0 ? -1 * axis : axis;
  side.family = span.axis / 2;
  return side;
}

}  // namespace

// Computes where two lines meet. Returns false when they are too nearly parallel.
bool meet(const OutlineSide& a, const OutlineSide& b, FlatPoint& at) {
  static const double kLeast = std::sqrt(1 - cos_degrees(kSharpest) * cos_degrees(kSharpest));
  const double sine = cross(a.direction, b.direction);
  if (std::abs(sine) < kLeast) return false;
  at = a.centre + (cross(b.centre - a.centre, b.direction) / sine) * a.direction;
  return true;
}

bool parallel(const OutlineSide& a, const OutlineSide& b) {
  return a.family >= 0 && a.family == b.family && std::abs(cross(a.direction, b.direction)) < 0.5;
}

std::vector<std::vector<OutlineSide>> sides_of(std::span<const Loop> rings, double tolerance) {
  const std::vector<FlatPoint> axes = main_axes(rings, tolerance);
  std::vector<std::vector<OutlineSide>> all;
  std::vector<FlatPoint> vertices;
  for (const Loop& ring : rings) {
    vertices.clear();
    for (const Point2 p : ring) vertices.push_back(flat(p));
    auto& sides = all.emplace_back();
    for (const SideSpan& span : split_sides(vertices, axes, kScatter * tolerance))
      sides.push_back(side_of(ring, span, axes));
  }
  return all;
}

}  // namespace ilot
