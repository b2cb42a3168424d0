// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/openings/pointed_top.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <span>
#include <vector>

#include "engine/products/facades/openings/head_places.h"
#include "kernels/core/portable_math.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Derived: an arch whose centres are at the opposite jambs is 0.87 times its width high. Heads of lancets that are
// higher than this limit are cut off below.
constexpr double kHighestPoint = 1.1;  // times the width: no point is higher
// Choice: the cells of the wall end up to this far below the crown, where the point is narrower than a few cells.
constexpr double kAbovePoint = 0.2;  // metres
constexpr std::size_t kRows = 16;    // across each half
// Choice: a jamb that a leaf or a plant hides is found up to a tenth of the width beside its place, which moves the
// middle by half of that.
constexpr double kOffMiddle = 0.05;  // share of the width: the crown of arcs is so near the middle between the jambs
constexpr int kCrowns = 5;           // places on each side of the middle that are tried
constexpr std::size_t kLeastOfHalf = 4;
// Choice: as for arches; flatter points are drawn straight.
constexpr double kLeastPoint = 0.04;  // metres that each half rises
// Choice: 11 degrees on each side; rounder arches are arcs.
constexpr double kLeastKink = 0.2;  // slope of an arc at the crown
// Choice: 60 degrees; steeper lines are jambs.
constexpr double kSteepestHead = 1.75;
// Choice: half of the residuals of an arc that has one parameter less.
constexpr double kBetterThanArc = 0.5;
// Choice: 45 degrees, and a fifth more or less, so that both serve between.
constexpr double kSteepForSlice = 1.2, kFlatForRow = 0.8;
// Derived: three standard deviations, as the median of the distances says them.
constexpr double kFarthest = 3 * 1.4826;
// Choice: brackets, lamps and bars end a third of the slices elsewhere.
constexpr double kLeastKept = 0.65;  // share of the places that the fit keeps
// Derived: three quarters of the places of a point that rises by kLeastPoint are up to three eighths of it off its
// middle.
constexpr double kLevel = kLeastPoint / 4;  // metres within which three quarters of the ends of a level head are
// Choice: the first arcs may be off by two gaps of 4 cm, as round ones.
constexpr double kBesidePoint = 0.08;  // metres

struct HeadEnds {
  std::vector<PlanePoint> slices, rows;  // ends of upright slices and of level rows; u from the middle of the opening
  double half_gap = 0;
};

struct HeadFit {
  PointedTop top;
  double crown = 0, rms = INFINITY;
  std::vector<PlanePoint> places;  // to which it was fitted
  bool found = false;
};

// The height of the head at a place.
double height_of(const HeadFit& fit, double u) {
  const double x = u - fit.top.crown_u;
  if (fit.top.radius == 0) return fit.crown + (x < 0 ? fit.top.left_slope : fit.top.right_slope) * x;
  const double across = std::abs(x) - fit.top.centre.u, up2 = fit.top.radius * fit.top.radius - across * across;
  return fit.crown + fit.top.centre.v + std::sqrt(std::max(0.0, up2));
}

double slope_of(const HeadFit& fit, double u) {
  const double x = u - fit.top.crown_u;
  if (fit.top.radius == 0) return std::abs(x < 0 ? fit.top.left_slope : fit.top.right_slope);
  const double across = std::abs(x) - fit.top.centre.u, up2 = fit.top.radius * fit.top.radius - across * across;
  return up2 > 0 ? std::abs(across) / std::sqrt(up2) : INFINITY;
}

double distance_to(const HeadFit& fit, PlanePoint p) {
  const double x = p.x - fit.top.crown_u;
  if (fit.top.radius == 0) {
    const double slope = x < 0 ? fit.top.left_slope : fit.top.right_slope;
    return std::abs(p.y - fit.crown - slope * x) / std::sqrt(1 + slope * slope);
  }
  const double across = std::abs(x) - fit.top.centre.u, up = p.y - fit.crown - fit.top.centre.v;
  return std::abs(std::sqrt(across * across + up * up) - fit.top.radius);
}

void set_rms(std::span<const PlanePoint> places, HeadFit& fit) {
  double squares = 0;
  for (const PlanePoint& p : places) squares += distance_to(fit, p) * distance_to(fit, p);
  fit.rms = std::sqrt(squares / static_cast<double>(places.size()));
  fit.places.assign(places.begin(), places.end());
}

std::vector<PlanePoint> folded(std::span<const PlanePoint> places, double crown_u) {
  std::vector<PlanePoint> out;
  for (const PlanePoint& p : places) out.push_back({std::abs(p.x - crown_u), p.y});
  return out;
}

// The head whose right arc is part of this circle of folded places.
HeadFit arcs_of(const CircleFit& circle, double crown_u) {
  HeadFit fit;
  if (!circle.found || circle.centre.x >= 0 || -circle.centre.x >= circle.radius) return fit;
  const double up = std::sqrt(circle.radius * circle.radius - circle.centre.x * circle.centre.x);
  fit.top.crown_u = crown_u;
  fit.top.radius = circle.radius;
  fit.top.centre = {circle.centre.x, -up};
  fit.crown = circle.centre.y + up;
  fit.found = -circle.centre.x >= kLeastKink * up;
  return fit;
}

// Two equal arcs: one circle of the places that are folded along the crown. The crown is searched within `off` of the
// middle, because one jamb may be found less well than the other.
HeadFit fit_arcs(std::span<const PlanePoint> places, double off) {
  HeadFit best;
  const auto try_at = [&](double crown_u) {
    const CircleFit circle = fit_circle(folded(places, crown_u));
    HeadFit fit = arcs_of(circle, crown_u);
    if (fit.found && circle.rms < best.rms) best = fit, best.rms = circle.rms;
  };
  double step = off / kCrowns;
  for (int i = -kCrowns; i <= kCrowns; ++i) try_at(step * i);
  for (int round = 0; round < 5; ++round) {
    step /= 2;
    const double at = best.top.crown_u;
    try_at(at - step), try_at(at + step);
  }
  if (best.found) set_rms(places, best);
  return best;
}

CircleFit circle_through(PlanePoint a, PlanePoint b, PlanePoint c) {
  const double bx = b.x - a.x, by = b.y - a.y, cx = c.x - a.x, cy = c.y - a.y, twice = 2 * (bx * cy - by * cx);
  if (twice == 0) return {};
  const double b2 = bx * bx + by * by, c2 = cx * cx + cy * cy;
  const double x = (cy * b2 - by * c2) / twice, y = (bx * c2 - cx * b2) / twice;
  return {{a.x + x, a.y + y}, std::sqrt(x * x + y * y), 0, true};
}

// Of all arcs about a crown through three of the places, those of which the nearest kLeastKept of the places are least
// far away (Rousseeuw 1984, with that share); their distance.
double nearest_arcs(std::span<const PlanePoint> places, double crown_u, double least, HeadFit& best) {
  constexpr std::size_t kTriples = 12;  // places of which triples are taken; more do not improve the result
  const std::vector<PlanePoint> half = folded(places, crown_u);
  const std::size_t every = half.size() / kTriples + 1;
  std::vector<double> off(places.size());
  for (std::size_t a = 0; a < half.size(); a += every)
    for (std::size_t b = a + every; b < half.size(); b += every)
      for (std::size_t c = b + every; c < half.size(); c += every) {
        const HeadFit fit = arcs_of(circle_through(half[a], half[b], half[c]), crown_u);
        if (!fit.found) continue;
        for (std::size_t i = 0; i < places.size(); ++i) off[i] = distance_to(fit, places[i]);
        const double most = lower_quantile(off, kLeastKept);
        if (most < least) least = most, best = fit;
      }
  return least;
}

// The places near the arcs that most places are near: bars and sills inside of the opening end slices too.
std::vector<PlanePoint> places_near_arcs(const std::vector<PlanePoint>& places, double off, double noise) {
  HeadFit best;
  double least = INFINITY;
  for (int i = -kCrowns; i <= kCrowns; ++i) least = nearest_arcs(places, off * i / kCrowns, least, best);
  std::vector<PlanePoint> near;
  if (!best.found) return near;
  for (const PlanePoint& p : places)
    if (distance_to(best, p) <= std::max(2 * noise, 2 * least)) near.push_back(p);
  return near;
}

struct Line {
  double at = 0, slope = 0, squares = 0;  // v at u = 0; sum of the squared residuals
};

Line fit_line(std::span<const PlanePoint> places) {
  const double n = static_cast<double>(places.size());
  double mx = 0, my = 0, xx = 0, xy = 0, yy = 0;
  for (const PlanePoint& p : places) mx += p.x / n, my += p.y / n;
  for (const PlanePoint& p : places)
    xx += (p.x - mx) * (p.x - mx), xy += (p.x - mx) * (p.y - my), yy += (p.y - my) * (p.y - my);
  if (!(xx > 0)) return {my, 0, INFINITY};
  const double slope = xy / xx;
  return {my - slope * mx, slope, std::max(0.0, yy - slope * xy)};
}

// Two lines that meet between two neighbouring places: of all such pairs the one with the least residuals. O(n^2).
HeadFit fit_lines(std::span<const PlanePoint> places) {
  HeadFit best;
  double least = INFINITY;
  for (std::size_t split = kLeastOfHalf; split + kLeastOfHalf <= places.size(); ++split) {
    const Line left = fit_line(places.first(split)), right = fit_line(places.subspan(split));
    const double squares = left.squares + right.squares;
    if (!(squares < least) || !(left.slope > 0) || !(right.slope < 0)) continue;
    const double crown_u = (right.at - left.at) / (left.slope - right.slope);
    const double beside = 2 * (places[split].x - places[split - 1].x);
    if (crown_u < places[split - 1].x - beside || crown_u > places[split].x + beside) continue;
    least = squares;
    best.top = {crown_u, 0, {}, left.slope, right.slope};
    best.crown = left.at + left.slope * crown_u;
    best.found = left.slope <= kSteepestHead && -right.slope <= kSteepestHead;
  }
  if (best.found) set_rms(places, best);
  return best;
}

// The number of a slice of one half: even ones are left of the crown.
std::size_t in_half(double place, bool left) {
  const std::size_t slice = slice_at(place, kRows);
  return slice == kNoSlice ? kNoSlice : 2 * slice + (left ? 0 : 1);
}

// The ends of level rows, in each half of the opening: where the head is steep they are more exact than slices.
void add_rows(const RaySamples& samples, const Box2& search, double highest, HeadEnds& ends) {
  const double middle = (search.u0 + search.u1) / 2, tall = (highest - search.v0) / kRows;
  const auto rows = head_slices(samples, search, 2 * kRows, [&](Place2 p) {
    const bool inside = p.u >= search.u0 && p.u <= search.u1;
    return std::pair(inside ? in_half((p.v - search.v0) / tall, p.u < middle) : kNoSlice, std::abs(p.u - middle));
  });
  for (std::size_t r = 0; r < rows.size(); ++r)
    if (const HeadEnd end = end_of_slice(samples, rows[r]); end.found)
      ends.rows.push_back({r % 2 == 0 ? -end.at : end.at, search.v0 + (static_cast<double>(r / 2) + 0.5) * tall});
}

// The ends of sectors across the arcs.
std::vector<PlanePoint> ends_of_sectors(const RaySamples& samples, const Box2& search, const HeadFit& fit) {
  const double crown = (search.u0 + search.u1) / 2 + fit.top.crown_u, centre = fit.crown + fit.top.centre.v;
  const double from = 2, to = direction_degrees(-fit.top.centre.u, -fit.top.centre.v);
  if (!(to > 2 * from)) return {};
  const double width = (to - from) / kRows;
  const auto sectors = head_slices(samples, search, 2 * kRows, [&](Place2 p) {
    const double x = std::abs(p.u - crown) - fit.top.centre.u, y = p.v - centre, r = std::sqrt(x * x + y * y);
    const bool beside = p.u >= search.u0 && p.u <= search.u1 && y > 0 && std::abs(r - fit.top.radius) <= kBesidePoint;
    return std::pair(beside ? in_half((direction_degrees(x, y) - from) / width, p.u < crown) : kNoSlice, r);
  });
  std::vector<PlanePoint> places;
  for (std::size_t s = 0; s < sectors.size(); ++s) {
    const HeadEnd end = end_of_slice(samples, sectors[s]);
    if (!end.found) continue;
    const double angle = from + width * (static_cast<double>(s / 2) + 0.5);
    const double x = fit.top.centre.u + end.at * cos_degrees(angle), y = centre + end.at * cos_degrees(angle - 90);
    places.push_back({fit.top.crown_u + (s % 2 == 0 ? -x : x), y});
  }
  return places;
}

std::vector<PlanePoint> in_order(std::vector<PlanePoint> places) {
  std::sort(places.begin(), places.end(),
            [](PlanePoint a, PlanePoint b) { return a.x != b.x ? a.x < b.x : a.y < b.y; });
  return places;
}

// The ends that show a head well: slices where it is flat, rows where it is steep. In the order of u.
std::vector<PlanePoint> good_places(const HeadEnds& ends, const HeadFit& fit) {
  std::vector<PlanePoint> places;
  for (const PlanePoint& p : ends.slices)
    if (!fit.found || slope_of(fit, p.x) <= kSteepForSlice) places.push_back(p);
  for (const PlanePoint& p : ends.rows)
    if (fit.found && slope_of(fit, p.x) >= kFlatForRow) places.push_back(p);
  return in_order(std::move(places));
}

// The ends that are no jambs: in the order of u.
std::vector<PlanePoint> inner_places(const HeadEnds& ends, double half) {
  std::vector<PlanePoint> places = ends.slices;
  for (const PlanePoint& p : ends.rows)
    if (std::abs(p.x) < (1 - 2 * kJamb) * half) places.push_back(p);
  return in_order(std::move(places));
}

bool both_halves(std::span<const PlanePoint> places, double crown_u) {
  const auto left = std::count_if(places.begin(), places.end(), [&](PlanePoint p) { return p.x < crown_u; });
  return left >= static_cast<std::ptrdiff_t>(kLeastOfHalf) &&
         static_cast<std::ptrdiff_t>(places.size()) - left >= static_cast<std::ptrdiff_t>(kLeastOfHalf);
}

using Fitter = std::function<HeadFit(std::span<const PlanePoint>)>;

// Fits again without the places that are far off. Fewer than kLeastKept of them: there is no such head.
HeadFit trimmed(std::vector<PlanePoint> places, const Fitter& fitter, double noise) {
  const std::size_t all = places.size();
  HeadFit fit;
  for (int round = 0; round < 3; ++round) {
    if (places.size() < kLeastHeadSlices) return {};
    fit = fitter(places);
    if (!fit.found) return fit;
    std::vector<double> off;
    for (const PlanePoint& p : places) off.push_back(distance_to(fit, p));
    const double most = std::max(2 * noise, kFarthest * upper_median(std::vector(off)));
    std::erase_if(places, [&](PlanePoint p) { return distance_to(fit, p) > most; });
    if (static_cast<double>(places.size()) < kLeastKept * static_cast<double>(all)) return {};
  }
  return fit;
}

// `first`: the places of the first fit.
HeadFit best_fit(const HeadEnds& ends, std::vector<PlanePoint> first, const Fitter& fitter, double noise) {
  HeadFit fit = trimmed(std::move(first), fitter, noise);
  for (int round = 0; round < 2 && fit.found; ++round) fit = trimmed(good_places(ends, fit), fitter, noise);
  fit.found = fit.found && both_halves(fit.places, fit.top.crown_u);
  return fit;
}

bool is_level(const HeadPlaces& tops) {
  std::vector<double> heights, off;
  for (const PlanePoint& p : tops.at) heights.push_back(p.y);
  const double middle = upper_median(heights);
  for (const double v : heights) off.push_back(std::abs(v - middle));
  return lower_quantile(off, 0.75) <= kLevel;
}

// Root mean square distance of places from what is drawn without a point: the arc, or a level line.
double rms_without(std::span<const PlanePoint> places, const FoundRectangle& opening) {
  double squares = 0, mean = 0;
  const Box2 box = opening.box();
  for (const PlanePoint& p : places) mean += p.y / static_cast<double>(places.size());
  for (const PlanePoint& p : places) {
    double off = p.y - mean;
    if (opening.arc) {
      const double x = p.x + (box.u0 + box.u1) / 2 - opening.arc->centre.u, y = p.y - opening.arc->centre.v;
      off = std::sqrt(x * x + y * y) - opening.arc->radius;
    }
    squares += off * off;
  }
  return std::sqrt(squares / static_cast<double>(places.size()));
}

}  // namespace

std::optional<FoundPoint> find_pointed_top(const RaySamples& samples, const FoundRectangle& opening, double highest,
                                           double most_misfit) {
  const Box2 box = opening.box();
  const double middle = (box.u0 + box.u1) / 2, half = box.width() / 2, noise = samples.site().noise;
  const Box2 search{box.u0, box.u1, std::max(box.v0 + 0.1, highest - kHighestPoint * box.width()),
                    highest + kAbovePoint};
  if (!(search.v0 < highest)) return std::nullopt;
  const HeadPlaces tops = tops_of_slices(samples, search);
  if (tops.at.size() < kLeastHeadSlices || is_level(tops)) return std::nullopt;
  HeadEnds ends;
  ends.half_gap = tops.half_gap;
  for (const PlanePoint& p : tops.at) ends.slices.push_back({p.x - middle, p.y});
  add_rows(samples, search, highest, ends);
  HeadFit lines = best_fit(ends, good_places(ends, {}), fit_lines, noise);
  const double off = kOffMiddle * box.width();
  const Fitter both_arcs = [&](std::span<const PlanePoint> places) { return fit_arcs(places, off); };
  HeadFit arcs = best_fit(ends, places_near_arcs(inner_places(ends, half), off, noise), both_arcs, noise);
  if (arcs.found) {
    const HeadFit finer = trimmed(ends_of_sectors(samples, search, arcs), both_arcs, noise);
    if (finer.found && std::abs(finer.crown - arcs.crown) <= kBesidePoint) arcs = finer;
  }
  const HeadFit& fit = arcs.found && (!lines.found || arcs.rms < lines.rms) ? arcs : lines;
  if (!fit.found) return std::nullopt;
  if (fit.crown - height_of(fit, -half) < kLeastPoint || fit.crown - height_of(fit, half) < kLeastPoint ||
      std::abs(fit.top.crown_u) >= half || fit.crown > search.v1)
    return std::nullopt;
  const double without = rms_without(fit.places, opening);
  if (fit.rms > (opening.arc ? kBetterThanArc : most_misfit) * without) return std::nullopt;
  // Residuals beyond the gaps between the rays on both sides are those of something else.
  if (fit.rms > ends.half_gap + kBoundOfHead * noise) return std::nullopt;
  FoundPoint found;
  found.top = fit.top;
  found.crown = fit.crown;
  found.rms = fit.rms;
  found.places = fit.places.size();
  found.error = noise / 2 + fit.rms / std::sqrt(static_cast<double>(kLeastHeadSlices));
  found.off = kBoundOfHead * (fit.rms + noise) + ends.half_gap + kBeamRadius;
  return found;
}

double springing_of(const FoundRectangle& opening, Side jamb) {
  const PointedTop& top = *opening.pointed;
  const Box2 box = opening.box();
  const double crown_u = (box.u0 + box.u1) / 2 + top.crown_u, x = opening.at(jamb) - crown_u;
  if (top.radius == 0) return std::max(box.v0, box.v1 + (x < 0 ? top.left_slope : top.right_slope) * x);
  const double across = std::abs(x) - top.centre.u, up2 = top.radius * top.radius - across * across;
  const bool tangent = std::abs(across - top.radius) <= opening.error(jamb) + opening.error(Side::top);
  return std::max(box.v0, box.v1 + top.centre.v + (up2 > 0 && !tangent ? std::sqrt(up2) : 0));
}

}  // namespace ilot
