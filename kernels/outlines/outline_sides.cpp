// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/outline_sides.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/portable_math.h"

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
// Derived: a cut across a right corner by one tolerance on either side is 1.4 long; the rest allows for noise.
constexpr double kShortCut = 2.5;  // tolerances; a shorter edge between two others may be a cut across their corner
// Derived: an edge of 4 tolerances has a direction to 14 degrees, below kMostTurn.
constexpr double kLongEnough = 4;  // tolerances; edges that can call for a direction of their own

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

void square_up(std::vector<std::vector<OutlineSide>>& rings, double tolerance) {
  for (int family = 0; family < kMostDirections; ++family) {
    FlatPoint q;
    if (!main_direction(rings, family == 0 ? 0 : kLongEnough * tolerance, family == 0 ? 1 : 2, q)) return;
    turn_sides(rings, half_angle(half_angle(q)), family, tolerance);
  }
}

// Removes short edges that only cut the corner of their neighbours.
void take_out_cuts(std::vector<OutlineSide>& sides, double tolerance) {
  while (sides.size() > 3) {
    const std::size_t n = sides.size();
    std::size_t cut = n;
    for (std::size_t i = 0; i < n; ++i) {
      const OutlineSide &before = sides[(i + n - 1) % n], &after = sides[(i + 1) % n];
      const double limit = kShortCut * tolerance;
      if (sides[i].length > limit || before.length < sides[i].length || after.length < sides[i].length) continue;
      FlatPoint corner;
      if (!meet(before, after, corner) || norm(corner - sides[i].centre) > limit) continue;
      if (cut == n || sides[i].length < sides[cut].length) cut = i;
    }
    if (cut == n) return;
    const FlatPoint middle = sides[cut].centre;
    sides[(cut + n - 1) % n].to = middle;
    sides[(cut + 1) % n].from = middle;
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(cut));
  }
}

OutlineSide merged(const OutlineSide& a, const OutlineSide& b) {
  OutlineSide side = a.length >= b.length ? a : b;
  const double whole = a.length + b.length;
  side.centre = (a.length / whole) * a.centre + (b.length / whole) * b.centre;
  side.length = whole;
  if (a.scatter2 >= 0 && b.scatter2 >= 0)
    side.scatter2 = (a.length * a.scatter2 + b.length * b.scatter2) / whole;
  else
    side.scatter2 = std::max(a.scatter2, b.scatter2);
  side.from = a.from;
  side.to = b.to;
  return side;
}

// Joins sides that continue each other.
void join_sides(std::vector<OutlineSide>& sides, double tolerance) {
  for (std::size_t i = 0; i < sides.size() && sides.size() > 3;) {
    const std::size_t next = (i + 1) % sides.size();
    const OutlineSide &a = sides[i], &b = sides[next];
    const bool goes_on = parallel(a, b) && dot(a.direction, b.direction) > 0 &&
                         std::abs(cross(a.direction, b.centre - a.centre)) <= tolerance;
    if (!goes_on) {
      ++i;
      continue;
    }
    sides[i] = merged(a, b);
    sides.erase(sides.begin() + static_cast<std::ptrdiff_t>(next));
    if (next < i) --i;
    if (i > 0) --i;
  }
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
  std::vector<std::vector<OutlineSide>> all;
  for (const Loop& ring : rings) {
    auto& sides = all.emplace_back();
    const std::vector<std::size_t> breaks = break_points(ring, tolerance);
    for (std::size_t i = 0; i < breaks.size(); ++i) {
      const std::size_t last = i + 1 < breaks.size() ? breaks[i + 1] : breaks[0] + ring.size();
      sides.push_back(fit_side(ring, breaks[i], last));
    }
  }
  square_up(all, tolerance);
  for (auto& sides : all) {
    take_out_cuts(sides, tolerance);
    join_sides(sides, tolerance);
  }
  return all;
}

}  // namespace ilot
