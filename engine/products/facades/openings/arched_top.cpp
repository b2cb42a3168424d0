// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/arched_top.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "engine/products/facades/openings/head_places.h"
#include "kernels/core/portable_math.h"
#include "kernels/core/quantile.h"
#include "kernels/outlines/circle_fit.h"

namespace ilot {
namespace {

// Derived: a semicircle is 0.5 times its width high; the rest allows for stilted arches. Higher heads are pointed
// (pointed_top.h) or become straight.
constexpr double kHighest = 0.65;  // times the width: no arch is higher
// Choice: the crown was found as the quantile of a flat top, which is lower by up to this.
constexpr double kAbove = 0.2;  // metres above the known top that are searched
// Choice: the error of the first circle; rampant arches are not found.
constexpr double kOffCentre = 0.2;  // share of the width: an arch may be so far from the middle of its opening
// Choice: three errors of an edge of 1 cm and some; flatter segments are drawn straight.
constexpr double kLeastRise = 0.04;  // metres; flatter tops are straight
// Choice: three errors of an edge of 1 cm.
constexpr double kBesideArc = 0.03;  // metres beside the first arc in which points of the soffit lie
constexpr std::size_t kLeastSoffit = 60;
constexpr std::uint64_t kMostSoffit = 1 << 16;  // more points do not improve the result

// The height of the upper half of a circle; NaN beside it.
double height_at(const CircleFit& fit, double u) {
  const double x = u - fit.centre.x;
  return fit.centre.y + std::sqrt(fit.radius * fit.radius - x * x);
}

// Whether two circles are near each other over the opening. Their radii are not compared: the radius of a flat arch
// changes by a sixth for one centimetre at the crown.
bool together(const CircleFit& a, const CircleFit& b, const Box2& opening) {
  // Choice: near the jambs, where the first arc is least known.
  constexpr double kEnd = 0.1;  // share of the width
  const auto near = [&](double share) {
    const double u = opening.u0 + share * opening.width();
    return std::abs(height_at(a, u) - height_at(b, u)) <= 2 * kBesideArc;
  };
  return near(kEnd) && near(0.5) && near(1 - kEnd);
}

// The tops across the arc, sector by sector: slices are inclined to the arc near the jambs.
HeadPlaces tops_of_sectors(const RaySamples& samples, const Box2& search, const CircleFit& first) {
  // Choice: the first arc may be off by two gaps of 4 cm.
  constexpr double kBeside = 0.08;  // metres
  const double half = std::min(search.width() / 2 / first.radius, 1.0);
  const double from = degrees_of_cosine(half) + 4, width = (180 - 2 * from) / kHeadSlices;
  const auto sectors = head_slices(samples, search, kHeadSlices, [&](Place2 p) {
    const double x = p.u - first.centre.x, y = p.v - first.centre.y, r = std::sqrt(x * x + y * y);
    const bool beside = y > 0 && std::abs(r - first.radius) <= kBeside;
    return std::pair(beside ? slice_at((direction_degrees(x, y) - from) / width, kHeadSlices) : kNoSlice, r);
  });
  HeadPlaces tops;
  for (std::size_t s = 0; s < kHeadSlices; ++s) {
    const HeadEnd end = end_of_slice(samples, sectors[s]);
    if (!end.found) continue;
    const double angle = from + width * (static_cast<double>(s) + 0.5);
    tops.add({first.centre.x + end.at * cos_degrees(angle), first.centre.y + end.at * cos_degrees(angle - 90)},
             end.half_gap);
  }
  return tops;
}

// Fits the circle to the points of the soffit beside a first arc; no result where there are too few points.
std::optional<CircleFit> refined(const RaySamples& samples, const FoundRectangle& opening, const Box2& search,
                                 const CircleFit& first) {
  const FacadeSite& site = samples.site();
  const double front = -std::max(0.015, 2 * site.epsilon), back = opening.depth + 0.03;
  const auto off = [](const CircleFit& fit, const PlanePoint& p) {
    const double x = p.x - fit.centre.x, y = p.y - fit.centre.y;
    return std::sqrt(x * x + y * y) - fit.radius;
  };
  std::vector<PlanePoint> soffit;
  const auto is_soffit = [&](const Ray& ray) {
    const PlanePoint at{ray.at.u, ray.at.v};
    return ray.at.w <= front && ray.at.w >= back && !samples.in_joint(ray) &&
           at.y >= first.centre.y + 0.1 * first.radius && at.x > search.u0 && at.x < search.u1 &&
           std::abs(off(first, at)) < kBesideArc;
  };
  Rays near = samples.near(search.grown(std::abs(opening.depth)));
  const int level = thinning_level(near, kMostSoffit, is_soffit);
  for (const Ray& ray : near)
    if (is_soffit(ray) && is_kept(ray, level)) soffit.push_back({ray.at.u, ray.at.v});
  CircleFit fit = first;
  double beside = kBesideArc;
  for (int round = 0; round < 4; ++round) {
    std::vector<PlanePoint> kept;
    std::vector<double> offs;
    for (const PlanePoint& p : soffit) offs.push_back(off(fit, p));
    if (offs.size() < kLeastSoffit) return std::nullopt;
    const double middle = round == 0 ? upper_median(std::vector(offs)) : 0;
    for (std::size_t i = 0; i < soffit.size(); ++i)
      if (std::abs(offs[i] - middle) < beside) kept.push_back(soffit[i]);
    if (kept.size() < kLeastSoffit) return std::nullopt;
    const CircleFit next = fit_circle(kept);
    if (!next.found || !together(next, first, search)) return std::nullopt;
    fit = next;
    beside = std::max(beside / 2, 4 * site.noise);
  }
  return fit;
}

// The circle through the ends of slices, where they rise from both jambs to the middle.
std::optional<CircleFit> arch_of(const FoundRectangle& opening, const HeadPlaces& tops, double most_misfit) {
  const double width = opening.at(Side::right) - opening.at(Side::left);
  double low = INFINITY, high = -INFINITY, mean = 0, level = 0;
  for (const PlanePoint& p : tops.at) {
    low = std::min(low, p.y), high = std::max(high, p.y);
    mean += p.y / static_cast<double>(tops.at.size());
  }
  for (const PlanePoint& p : tops.at) level += (p.y - mean) * (p.y - mean) / static_cast<double>(tops.at.size());
  if (high - low < kLeastRise) return std::nullopt;
  const CircleFit fit = fit_circle(tops.at);
  if (!fit.found || fit.rms > most_misfit * std::sqrt(level) || fit.centre.y > high || fit.radius < width / 2 - 0.05)
    return std::nullopt;
  if (std::abs(fit.centre.x - (opening.at(Side::left) + width / 2)) > kOffCentre * width) return std::nullopt;
  return fit;
}

}  // namespace

FoundTop find_top(const RaySamples& samples, const FoundRectangle& opening, double most_misfit) {
  const double width = opening.at(Side::right) - opening.at(Side::left), noise = samples.site().noise;
  const Box2 search{opening.at(Side::left), opening.at(Side::right),
                    std::max(opening.at(Side::bottom) + 0.1, opening.at(Side::top) - kHighest * width),
                    opening.at(Side::top) + kAbove};
  HeadPlaces tops = tops_of_slices(samples, search);
  if (tops.at.size() < kLeastHeadSlices) return {};
  FoundTop found;
  double squares = 0;
  for (const PlanePoint& p : tops.at) squares += (p.y - opening.at(Side::top)) * (p.y - opening.at(Side::top));
  found.off = kBoundOfHead * std::sqrt(squares / static_cast<double>(tops.at.size()));
  const std::optional<CircleFit> arch = arch_of(opening, tops, most_misfit);
  if (!arch) return found;
  CircleFit fit = *arch;
  for (int round = 0; round < 2; ++round) {
    HeadPlaces across = tops_of_sectors(samples, search, fit);
    const CircleFit next = across.at.size() < kLeastHeadSlices ? CircleFit{} : fit_circle(across.at);
    if (next.found && together(next, fit, search)) fit = next, tops = std::move(across);
  }
  const std::optional<CircleFit> soffit = refined(samples, opening, search, fit);
  if (soffit) fit = *soffit;
  TopArc arc;
  arc.centre = {fit.centre.x, fit.centre.y};
  arc.radius = fit.radius;
  arc.rms = fit.rms;
  arc.points = tops.at.size();
  arc.error = noise / 2 + fit.rms / std::sqrt(static_cast<double>(kLeastHeadSlices));
  // Arches are no exact circles: what the ends of the slices are off by belongs to the error of each place of the arc.
  arc.off = kBoundOfHead * (fit.rms + noise) + (soffit ? 0 : tops.half_gap + kBeamRadius);
  found.arc = arc;
  return found;
}

double rise_of(const FoundRectangle& o) {
  if (o.pointed) {
    const double to = o.box().width() / 2 - o.pointed->crown_u, beside = to - o.pointed->centre.u;
    const double radius = o.pointed->radius;
    const double at_jamb = radius > 0
                               ? o.pointed->centre.v + std::sqrt(std::max(0.0, radius * radius - beside * beside))
                               : o.pointed->right_slope * to;
    return std::max(0.0, -at_jamb);
  }
  if (!o.arc) return 0;
  const double half = o.box().width() / 2, radius = o.arc->radius;
  return radius - std::sqrt(std::max(0.0, radius * radius - half * half));
}

}  // namespace ilot
