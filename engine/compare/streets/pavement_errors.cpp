// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/streets/pavement_errors.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <optional>

namespace ilot {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kAtKerb = 0.5;     // metres between a width's beginning and the true kerb
constexpr double kStrip = 1;        // metres of kerb for which a width stands
constexpr double kWidest = 6;       // metres; pavements that end farther off are not judged
constexpr double kRight = 0.1;      // metres; a width that is as near is right
constexpr double kBuilt = 0.25;     // metres; likewise, of the pavement as built
constexpr double kWidestRoad = 30;  // metres

struct FlatPoint {
  double x = 0, y = 0;  // metres: away from the kerb, along it
};

// A place on a kerb and the direction away from the road, in the CRS.
struct Across {
  Vec3 at;
  double dx = 0, dy = 1;
};

// What the true pavement is like at a place.
struct TrueWidth {
  double built = 0, end = kInfinity, passable = 0;  // metres
  bool moving = false;  // something that moves, or was not always there, reaches into the strip
};

// The part of a convex ring on one side: where f is at most 0.
template <class Side>
std::vector<FlatPoint> cut(const std::vector<FlatPoint>& ring, const Side& f) {
  std::vector<FlatPoint> out;
  for (std::size_t i = 0; i < ring.size(); ++i) {
    const FlatPoint a = ring[i], b = ring[(i + 1) % ring.size()];
    const double fa = f(a), fb = f(b);
    if (fa <= 0) out.push_back(a);
    if ((fa < 0 && fb > 0) || (fa > 0 && fb < 0)) {
      const double t = fa / (fa - fb);
      out.push_back({a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)});
    }
  }
  return out;
}

class PavementTruth {
 public:
  PavementTruth(const Truth& truth, double metres) : truth_(truth), metres_(metres) {}

  // The nearest true pavement within kAtKerb of a place.
  const TruePavement* at(Vec3 p) const {
    const TruePavement* best = nullptr;
    double least = kAtKerb;
    for (const TruePavement& pavement : truth_.pavements)
      for (std::size_t i = 0; i + 1 < pavement.line.size(); ++i) {
        const Vec3 a = pavement.line[i], d = pavement.line[i + 1] - a;
        const double square = d.x * d.x + d.y * d.y;
        const double t = square > 0 ? std::clamp(((p.x - a.x) * d.x + (p.y - a.y) * d.y) / square, 0.0, 1.0) : 0;
        const double off = std::hypot(a.x + t * d.x - p.x, a.y + t * d.y - p.y) * metres_;
        if (off < least) least = off, best = &pavement;
      }
    return best;
  }

  TrueWidth width_at(const Across& across, const TruePavement& pavement) const {
    TrueWidth width;
    width.built = pavement.width_m;
    if (pavement.to_facade_m > 0) width.end = pavement.to_facade_m;
    struct Reach {
      double from, to;
      bool moves;
    };
    std::vector<Reach> reaches;
    for (const TrueOutline& outline : truth_.outlines) {
      const auto [from, to] = reach_of(outline, across);
      if (to <= 0 || from >= kWidest) continue;
      if (outline.is_boundary && !outline.moves && (from + to) / 2 >= width.built)
        width.end = std::min(width.end, from);
      reaches.push_back({from, to, outline.moves});
    }
    if (width.end > kWidest) width.end = kInfinity;
    std::sort(reaches.begin(), reaches.end(), [](const Reach& a, const Reach& b) { return a.from < b.from; });
    double free_from = 0;
    for (const Reach& r : reaches) {
      if (r.from >= width.end) break;
      width.moving = width.moving || r.moves;
      if (r.moves) continue;
      width.passable = std::max(width.passable, r.from - free_from);
      free_from = std::max(free_from, r.to);
    }
    width.passable = std::max(width.passable, width.end - free_from);
    return width;
  }

  // The way across the road to the next true pavement; infinity without one.
  double road_at(const Across& across) const {
    double least = kInfinity;
    for (const TruePavement& pavement : truth_.pavements)
      for (std::size_t i = 0; i + 1 < pavement.line.size(); ++i) {
        const Vec3 a = pavement.line[i] - across.at, d = pavement.line[i + 1] - pavement.line[i];
        const double turn = across.dx * d.y - across.dy * d.x;
        if (turn == 0) continue;
        const double way = -(a.x * d.y - a.y * d.x) / turn * metres_;
        const double share = (a.x * across.dy - a.y * across.dx) / turn;
        if (way > kAtKerb && way <= kWidestRoad && share >= 0 && share <= 1) least = std::min(least, way);
      }
    return least;
  }

 private:
  // How far an outline reaches into the strip, from and to, from the kerb; nothing is beyond kWidest.
  std::pair<double, double> reach_of(const TrueOutline& outline, const Across& across) const {
    std::vector<FlatPoint> ring;
    for (const Vec3& p : outline.ring) {
      const double x = (p.x - across.at.x) * metres_, y = (p.y - across.at.y) * metres_;
      ring.push_back({x * across.dx + y * across.dy, y * across.dx - x * across.dy});
    }
    ring = cut(ring, [](FlatPoint p) { return p.y - kStrip / 2; });
    ring = cut(ring, [](FlatPoint p) { return -p.y - kStrip / 2; });
    if (ring.empty()) return {kInfinity, kInfinity};
    const auto [from, to] =
        std::minmax_element(ring.begin(), ring.end(), [](FlatPoint a, FlatPoint b) { return a.x < b.x; });
    return {from->x, to->x};
  }

  const Truth& truth_;
  double metres_;
};

bool has_end(const PavementWidth& w) {
  return w.end != PavementEnd::open && w.end != PavementEnd::unsure;
}

std::optional<Across> across_of(const PavementWidth& w) {
  const Vec3 d = w.to - w.from;
  const double length = std::hypot(d.x, d.y);
  if (length == 0) return std::nullopt;
  return Across{w.from, d.x / length, d.y / length};
}

double share_of(const std::vector<double>& errors, double most) {
  if (errors.empty()) return 0;
  const auto right = std::count_if(errors.begin(), errors.end(), [&](double e) { return std::abs(e) <= most; });
  return static_cast<double>(right) / static_cast<double>(errors.size());
}

}  // namespace

PavementResult evaluate_pavements(const KerbSight& sight, const Truth& truth, std::span<const PavementWidth> found,
                                  double metres_per_unit) {
  PavementResult result;
  const PavementTruth of(truth, metres_per_unit);
  std::vector<double> width, passable, road;
  std::uint64_t within = 0, with_error = 0;
  for (const PavementWidth& w : found) {
    const auto across = across_of(w);
    if (!across || !has_end(w)) continue;
    ++result.stated;
    const TruePavement* pavement = of.at(w.from);
    if (pavement == nullptr) {
      ++result.away;
      continue;
    }
    if (const double r = of.road_at(*across); w.road_m > 0 && std::isfinite(r)) road.push_back(w.road_m - r);
    const TrueWidth t = of.width_at(*across, *pavement);
    result.built += std::abs(w.width_m - t.built) <= kBuilt ? 1 : 0;
    if (!std::isfinite(t.end)) {
      ++result.endless;
      continue;
    }
    width.push_back(w.width_m - t.end);
    if (w.error_m > 0) ++with_error, within += std::abs(w.width_m - t.end) <= w.error_m ? 1 : 0;
    if (!t.moving) passable.push_back(w.passable_m - t.passable);
  }
  double complete = 0;
  for (const KerbSight::Place& place : sight.places()) {
    const TruePavement* pavement = place.is_seen() ? of.at(place.at) : nullptr;
    if (pavement == nullptr) continue;
    // Kerbs of the truth have no side; both are tried, and the pavement is where the end is.
    const auto reaches_end = [&](double sign) {
      return std::isfinite(of.width_at({place.at, -sign * place.along_y, sign * place.along_x}, *pavement).end);
    };
    if (!reaches_end(1) && !reaches_end(-1)) continue;
    result.true_m += place.length_m;
    const bool has = std::any_of(found.begin(), found.end(), [&](const PavementWidth& w) {
      const double dx = (w.from.x - place.at.x) * metres_per_unit, dy = (w.from.y - place.at.y) * metres_per_unit;
      return has_end(w) && dx * dx + dy * dy <= kStrip * kStrip;
    });
    complete += has ? place.length_m : 0;
  }
  result.complete = result.true_m > 0 ? complete / result.true_m : 0;
  result.near = share_of(width, kRight), result.passable_near = share_of(passable, kRight);
  result.within_stated = with_error > 0 ? static_cast<double>(within) / static_cast<double>(with_error)
                                        : std::numeric_limits<double>::quiet_NaN();
  result.width = sizes_of(width), result.passable = sizes_of(passable), result.road = sizes_of(road);
  return result;
}

}  // namespace ilot
