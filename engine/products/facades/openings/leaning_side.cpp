// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/leaning_side.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/outlines/edge_split.h"

namespace ilot {
namespace {

constexpr std::size_t kStretches = 24, kLeastStretches = 10;
// Choice: the share that arched_top.cpp leaves out at jambs.
constexpr double kCorner = 0.04;  // share of the side that is left out at each end
// Choice: a side that leans by more than a third of the opening is a triangle and is not found.
constexpr double kMostReach = 0.35;  // share of the size of the opening that is searched on either side
// Choice: three steps of 2 cm, as for arches.
constexpr double kMostLeaningGap = 0.06;  // metres; intervals whose place is less exact are left out
// Choice: as facades.arch_misfit; of a straight jamb a line by chance has 0.8 and more.
constexpr double kStraighter = 0.35;  // greatest residuals of the line, as a share of those of the straight side
// Choice: three errors of an edge of 1 cm.
constexpr double kLeastLean = 0.03;  // metres from end to end
// Derived: tan 42 degrees; roofs of 45 degrees are no jambs.
constexpr double kMostLean = 0.9;                       // tangent of the angle
constexpr std::uint64_t kMostLeaningSamples = 1 << 17;  // points of a side; more do not improve the result

struct Stretch {
  std::vector<double> inside, outside;
};

struct Place {
  double s, t;
};

// Whether the ray meets the wall, or something on it that hides nothing of the opening: see arched_top.
bool is_solid(const RaySamples& samples, const Ray& ray) {
  return samples.in_joint(ray) || samples.met(ray, 0, samples.site().epsilon) == RayOutcome::solid;
}
bool is_open(const RaySamples& samples, const Ray& ray) {
  return !samples.in_joint(ray) && samples.met(ray, 0, samples.site().epsilon) == RayOutcome::through;
}

std::vector<Place> places_along(const RaySamples& samples, const FoundRectangle& opening, Side side) {
  const bool upright = side == Side::left || side == Side::right;
  const double sign = outwards(side);
  const Box2 box = opening.box();
  const double low = upright ? box.v0 : box.u0, length = upright ? box.height() : box.width();
  const double reach = kMostReach * (upright ? box.width() : box.height()), at = opening.at(side);
  const double margin = kCorner * length, width = (length - 2 * margin) / kStretches;
  std::vector<Stretch> stretches(kStretches);
  const auto place_of = [&](const Ray& ray) {
    const Place2 p = samples.crossing(ray, 0);
    return Place{((upright ? p.v : p.u) - low - margin) / width, upright ? p.u : p.v};
  };
  const auto is_beside = [&](const Ray& ray) {
    const Place p = place_of(ray);
    return p.s >= 0 && p.s < kStretches && std::abs(p.t - at) <= reach;
  };
  Rays near = samples.near(box.grown(reach));
  const int level = thinning_level(near, kMostLeaningSamples, is_beside);
  for (const Ray& ray : near) {
    if (!is_beside(ray) || !is_kept(ray, level)) continue;
    const Place p = place_of(ray);
    Stretch& stretch = stretches[static_cast<std::size_t>(p.s)];
    if (is_open(samples, ray)) stretch.inside.push_back(sign * p.t);
    if (is_solid(samples, ray)) stretch.outside.push_back(sign * p.t);
  }
  std::vector<Place> places;
  for (std::size_t k = 0; k < kStretches; ++k) {
    const EdgeSplit split = split_edge(stretches[k].inside, stretches[k].outside);
    if (!split.found || (samples.oblique() && split.half_gap > kMostLeaningGap)) continue;
    const double t = samples.oblique() ? split.at : split.at + split.half_gap - samples.site().step / 2;
    places.push_back({(static_cast<double>(k) + 0.5) * width + margin - length / 2, sign * t});
  }
  return places;
}

}  // namespace

std::optional<LeaningSide> find_leaning_side(const RaySamples& samples, const FoundRectangle& opening, Side side) {
  const std::vector<Place> places = places_along(samples, opening, side);
  if (places.size() < kLeastStretches) return std::nullopt;
  const double n = static_cast<double>(places.size());
  double ms = 0, mt = 0, ss = 0, st = 0, tt = 0;
  for (const Place& p : places) ms += p.s / n, mt += p.t / n;
  for (const Place& p : places)
    ss += (p.s - ms) * (p.s - ms), st += (p.s - ms) * (p.t - mt), tt += (p.t - mt) * (p.t - mt);
  LeaningSide line;
  line.lean = st / ss;
  line.at = mt - line.lean * ms;
  const double straight = std::sqrt(tt / n);
  line.rms = std::sqrt(std::max(0.0, (tt - line.lean * st) / n));
  line.error = samples.site().noise / 2 + 2 * line.rms / std::sqrt(static_cast<double>(kLeastStretches));
  const double length = side == Side::left || side == Side::right ? opening.box().height() : opening.box().width();
  const double leans = std::abs(line.lean) * length;
  if (leans < std::max(kLeastLean, 2 * opening.error(side)) || std::abs(line.lean) > kMostLean) return std::nullopt;
  if (line.rms > kStraighter * straight) return std::nullopt;
  return line;
}

}  // namespace ilot
