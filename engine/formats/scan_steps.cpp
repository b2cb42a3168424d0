// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/scan_steps.h"

#include <algorithm>
#include <cmath>
#include <tuple>
#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr double kLeastStep = 1e-6, kMostStep = 0.0873;
constexpr double kLeastLevel = 0.2;    // sine of the angle from the axis
constexpr double kMostAngle = 0.3;     // radians, approximate; between the points of a pair
constexpr std::size_t kBaseline = 16;  // greatest number of places between the points of a pair
constexpr std::size_t kLeastPairs = 8;

// The components from which the angles of a ray are computed.
struct Angles {
  double x = 0, y = 0;       // unit vector of the horizontal part
  double level = 0, up = 0;  // cosine and sine of the elevation
  bool usable = false;
};

Angles angles_of(Vec3 ray) {
  const double level = std::sqrt(ray.x * ray.x + ray.y * ray.y), length = norm(ray);
  if (!std::isfinite(length) || !(level > kLeastLevel * length)) return {};
  return {ray.x / level, ray.y / level, level / length, ray.z / length, true};
}

// Returns the angle of a sine, below kMostAngle; the series is exact to a millionth.
double small_angle(double sine) {
  const double s2 = sine * sine;
  return sine * (1 + s2 * (1.0 / 6 + s2 * (3.0 / 40 + s2 * 15.0 / 336)));
}

// The signed angles from one ray to another.
struct Turn {
  double azimuth = 0, elevation = 0;
  bool small = false;
};

Turn turn_between(const Angles& a, const Angles& b) {
  const double sa = a.x * b.y - a.y * b.x, ca = a.x * b.x + a.y * b.y;
  const double se = b.up * a.level - a.up * b.level, ce = a.level * b.level + a.up * b.up;
  const bool small = ca > 0 && ce > 0 && std::abs(sa) < kMostAngle && std::abs(se) < kMostAngle;
  return {small_angle(sa), small_angle(se), small};
}

double median(std::vector<double>& values) {
  return values.size() < kLeastPairs ? 0 : upper_median(values);
}

AngularSteps known_steps(AngularSteps s) {
  const auto usable = [](double v) { return v >= kLeastStep && v <= kMostStep; };
  return usable(s.azimuth) && usable(s.elevation) ? s : AngularSteps{};
}

// A point on a line of the grid.
struct Place {
  std::int64_t line = 0, at = 0;
  Angles angles;
};

// Returns the median angles between neighbouring places of the lines.
AngularSteps steps_along(std::vector<Place>& places) {
  std::sort(places.begin(), places.end(),
            [](const Place& a, const Place& b) { return std::tie(a.line, a.at) < std::tie(b.line, b.at); });
  std::vector<double> azimuth, elevation;
  for (std::size_t i = 0; i < places.size(); ++i) {
    for (std::size_t ahead = kBaseline; ahead > 0; ahead /= 2) {
      if (i + ahead >= places.size()) continue;
      const Place &a = places[i], &b = places[i + ahead];
      const std::int64_t apart = b.at - a.at;
      if (a.line != b.line || apart <= 0 || apart > 4 * static_cast<std::int64_t>(kBaseline)) continue;
      const Turn turn = turn_between(a.angles, b.angles);
      if (!turn.small) continue;
      azimuth.push_back(std::abs(turn.azimuth) / static_cast<double>(apart));
      elevation.push_back(std::abs(turn.elevation) / static_cast<double>(apart));
      break;
    }
  }
  return {median(azimuth), median(elevation)};
}

// Points in the order of their measurement.
using Sequence = std::vector<Angles>;

// Tells whether the elevation changes more than the azimuth in at least half of the moves from a point to the next.
bool runs_up(const Sequence& points) {
  std::size_t up = 0, round = 0;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Turn turn = turn_between(points[i - 1], points[i]);
    if (!turn.small) continue;
    ++(std::abs(turn.elevation) > std::abs(turn.azimuth) ? up : round);
  }
  return up >= round;
}

// Returns the points as a grid. A profile is a column; the steps along it show how many places are between its points.
std::vector<GridPoint> gridded(const Sequence& points, const std::vector<Vec3>& rays, bool up) {
  const auto along = [&](const Turn& t) { return up ? t.elevation : t.azimuth; };
  std::vector<double> moves;
  for (std::size_t i = 1; i < points.size(); ++i) {
    const Turn turn = turn_between(points[i - 1], points[i]);
    if (turn.small) moves.push_back(std::abs(along(turn)));
  }
  const double step = median(moves);
  if (!(step >= kLeastStep)) return {};
  std::vector<GridPoint> out;
  std::int64_t profile = 0, place = 0;
  double direction = 0;  // direction of this profile
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Turn turn = i == 0 ? Turn{} : turn_between(points[i - 1], points[i]);
    const double move = along(turn);
    const bool goes_on = i > 0 && turn.small && move * direction >= 0 && std::abs(move) > step / 2;
    if (goes_on) {
      place += std::max<std::int64_t>(1, std::llround(std::abs(move) / step));
      direction = move;
    } else if (i > 0) {
      ++profile;
      place = 0;
      direction = 0;
    }
    out.push_back({place, profile, rays[i]});
  }
  return out;
}

// Returns the median angle across from a profile to the next, for profiles with enough points. Two profiles that differ
// by less than `least` are two parts of one profile.
double step_across(const std::vector<GridPoint>& points, bool up, double least) {
  constexpr std::size_t kLeastPoints = 8;
  std::vector<Angles> middle;  // of profiles
  for (std::size_t first = 0; first < points.size();) {
    std::size_t end = first;
    while (end < points.size() && points[end].column == points[first].column) ++end;
    if (end - first >= kLeastPoints) {
      Vec3 sum;
      for (std::size_t i = first; i < end; ++i) {
        const Angles a = angles_of(points[i].ray);
        sum = up ? sum + Vec3{a.x, a.y, 0} : sum + Vec3{a.level, 0, a.up};
      }
      middle.push_back(up ? angles_of(sum) : Angles{1, 0, sum.x / norm(sum), sum.z / norm(sum), true});
    }
    first = end;
  }
  std::vector<double> turns;
  for (std::size_t i = 1; i < middle.size(); ++i) {
    const Turn turn = turn_between(middle[i - 1], middle[i]);
    const double across = std::abs(up ? turn.azimuth : turn.elevation);
    if (turn.small && across >= least) turns.push_back(across);
  }
  return median(turns);
}

}  // namespace

AngularSteps steps_of_grid(std::span<const GridPoint> points) {
  std::vector<Place> columns, rows;
  for (const GridPoint& p : points) {
    const Angles angles = angles_of(p.ray);
    if (!angles.usable) continue;
    columns.push_back({p.column, p.row, angles});
    rows.push_back({p.row, p.column, angles});
  }
  const AngularSteps down = steps_along(columns), across = steps_along(rows);
  return known_steps({std::max(down.azimuth, across.azimuth), std::max(down.elevation, across.elevation)});
}

AngularSteps steps_of_sequence(std::span<const Vec3> rays) {
  Sequence points;
  std::vector<Vec3> used;
  for (const Vec3 ray : rays) {
    const Angles angles = angles_of(ray);
    if (!angles.usable) continue;
    points.push_back(angles);
    used.push_back(ray);
  }
  const bool up = runs_up(points);
  const std::vector<GridPoint> grid = gridded(points, used, up);
  std::vector<Place> profiles;
  for (std::size_t i = 0; i < grid.size(); ++i) profiles.push_back({grid[i].column, grid[i].row, points[i]});
  const AngularSteps along = steps_along(profiles);
  const double across = step_across(grid, up, std::max(up ? along.elevation : along.azimuth, kLeastStep) / 8);
  return known_steps(up ? AngularSteps{across, along.elevation} : AngularSteps{along.azimuth, across});
}

}  // namespace ilot
