// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/regular_planes.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numeric>
#include <vector>

#include "engine/products/roofs/faces/outline_directions.h"

namespace ilot {
namespace {

// Choice: the mean square residual grows by a quarter at most, which nobody sees; what is built more crooked stays so.
constexpr double kOfResidual = 0.5;  // the greatest movement, of the root mean square residual
// Derived: two standard errors contain 95 % of normal errors.
constexpr double kStandardErrors = 2;
// Derived: a plane has three numbers.
constexpr double kNumbersOfPlane = 3;
// Choice: what a plane of few points is blurred by is better known from the whole roof.
constexpr double kPriorPoints = 10;  // points of the whole roof that count for each plane
// Choice: shorter sides are steps of the drawing of the outline.
constexpr double kLeastSide = 0.1;                                 // of the length of all sides
constexpr std::size_t kMostMainDirections = 16, kMostSlopes = 16;  // of the largest planes; a bound of the time

using Slope = FlatPoint;  // rise for a metre along x and along y

// A plane and the spread of its points, in metres.
struct Measured {
  double points = 0;
  FlatPoint centre;
  double xx = 0, xy = 0, yy = 0;  // sums of squares about the centre
  double residual2 = 0;           // sum of the squared distances from the plane
};

std::vector<Measured> measured(std::span<const Vec3> points, const RoofPlanes& planes) {
  std::vector<Measured> all(planes.planes.size());
  const auto each = [&](const auto& add) {
    for (std::size_t i = 0; i < points.size(); ++i)
      if (const std::uint32_t label = planes.of_point[i]; label != 0)
        add(all[label - 1], planes.planes[label - 1], points[i]);
  };
  each([](Measured& m, const RoofPlane&, const Vec3& p) {
    m.points += 1;
    m.centre = {m.centre.x + p.x, m.centre.y + p.y};
  });
  for (Measured& m : all)
    if (m.points > 0) m.centre = {m.centre.x / m.points, m.centre.y / m.points};
  each([](Measured& m, const RoofPlane& plane, const Vec3& p) {
    const double x = p.x - m.centre.x, y = p.y - m.centre.y, off = p.z - plane.at(p.x, p.y);
    m.xx += x * x;
    m.xy += x * y;
    m.yy += y * y;
    m.residual2 += off * off / (1 + plane.gx * plane.gx + plane.gy * plane.gy);
  });
  return all;
}

// A slope that a plane may take. `numbers` of it are free: not given by anything else of the roof.
struct Candidate {
  Slope slope;
  int numbers;
  double moved2;  // mean square movement at the points
};

class Regularizer {
 public:
  Regularizer(const SitePolygon& outline, std::span<const Vec3> points, RoofPlanes& planes)
      : planes_(planes.planes), measured_(measured(points, planes)) {
    double residual2 = 0, total = 0, sides = 0;
    for (const Measured& m : measured_) residual2 += m.residual2, total += m.points;
    mean_residual2_ = total > 0 ? residual2 / total : 0;
    const std::vector<WeightedDirection> directions = outline_directions(outline);
    for (const WeightedDirection& d : directions) sides += d.weight;
    for (const WeightedDirection& d : directions)
      if (d.weight >= kLeastSide * sides && directions_.size() < kMostMainDirections) directions_.push_back(d.along);
  }

  void run() {
    std::vector<std::uint32_t> order(planes_.size());
    std::iota(order.begin(), order.end(), 0u);
    std::stable_sort(order.begin(), order.end(),
                     [&](std::uint32_t p, std::uint32_t q) { return measured_[p].points > measured_[q].points; });
    for (const std::uint32_t p : order) {
      const int numbers = turn(p);
      done_.push_back(p);
      const Slope s{planes_[p].gx, planes_[p].gy};
      const double size = std::sqrt(dot(s, s));
      if (numbers > 1 && directions_.size() + 1 < kMostMainDirections && size > 0) {
        directions_.push_back({s.x / size, s.y / size});
        directions_.push_back({-s.y / size, s.x / size});
      }
      if (numbers > 0 && steepness_.size() < kMostSlopes) steepness_.push_back(size);
    }
  }

 private:
  double allowed2(const Measured& m) const {
    const double residual2 = (m.residual2 + kPriorPoints * mean_residual2_) / (m.points + kPriorPoints);
    return residual2 * std::max(kOfResidual * kOfResidual,
                                kStandardErrors * kStandardErrors * kNumbersOfPlane / std::max(m.points, 1.0));
  }

  double moved2(std::uint32_t p, Slope to) const {
    const Measured& m = measured_[p];
    const RoofPlane& plane = planes_[p];
    const double x = to.x - plane.gx, y = to.y - plane.gy;
    return (x * x * m.xx + 2 * x * y * m.xy + y * y * m.yy) / std::max(m.points, 1.0) /
           (1 + plane.gx * plane.gx + plane.gy * plane.gy);
  }

  std::vector<Candidate> candidates(std::uint32_t p) const {
    const Slope own{planes_[p].gx, planes_[p].gy};
    std::vector<Candidate> all;
    const auto add = [&](Slope to, int numbers) { all.push_back({to, numbers, moved2(p, to)}); };
    add({0, 0}, 0);
    for (const FlatPoint d : directions_) {
      const double along = dot(own, d);
      add({along * d.x, along * d.y}, 1);
      for (const double steepness : steepness_) {
        const double steep = std::copysign(steepness, along);
        add({steep * d.x, steep * d.y}, 0);
      }
    }
    return all;
  }

  // Turns a plane. Returns how many numbers of its slope nothing else gave.
  int turn(std::uint32_t p) {
    if (measured_[p].points < kNumbersOfPlane) return 0;
    const double allowed = allowed2(measured_[p]);
    const Slope own{planes_[p].gx, planes_[p].gy};
    Candidate best{own, 2, 0};
    for (const Candidate& c : candidates(p))
      if (c.moved2 <= allowed && (c.numbers < best.numbers || (c.numbers == best.numbers && c.moved2 < best.moved2)))
        best = c;
    RoofPlane& plane = planes_[p];
    const FlatPoint centre = measured_[p].centre;
    const double height = plane.at(centre.x, centre.y);
    plane.gx = best.slope.x;
    plane.gy = best.slope.y;
    plane.c = height - plane.gx * centre.x - plane.gy * centre.y;
    level_with_others(plane, centre, allowed - best.moved2);
    return best.numbers;
  }

  // Moves a plane to the height of the nearest earlier one of its slope, where the rest of what is allowed suffices.
  void level_with_others(RoofPlane& plane, FlatPoint centre, double rest2) const {
    const double stretch2 = 1 + plane.gx * plane.gx + plane.gy * plane.gy;
    double nearest2 = rest2 * stretch2, c = plane.c;
    for (const std::uint32_t q : done_) {
      if (planes_[q].gx != plane.gx || planes_[q].gy != plane.gy) continue;
      const double rise = planes_[q].at(centre.x, centre.y) - plane.at(centre.x, centre.y);
      if (rise * rise > nearest2) continue;
      nearest2 = rise * rise;
      c = planes_[q].c;
    }
    plane.c = c;
  }

  std::vector<RoofPlane>& planes_;
  std::vector<Measured> measured_;
  double mean_residual2_ = 0;
  std::vector<FlatPoint> directions_;  // of unit length
  std::vector<double> steepness_;      // of earlier planes, each once
  std::vector<std::uint32_t> done_;    // planes that have their position
};

}  // namespace

void make_regular(const SitePolygon& outline, std::span<const Vec3> points, RoofPlanes& planes) {
  Regularizer(outline, points, planes).run();
}

}  // namespace ilot
