// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/opening_odds.h"

#include <algorithm>
#include <array>

#include "engine/products/facades/elements/element_box.h"
#include "engine/products/facades/elements/facade_elements.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

// Choice: the height of a lintel; rows and sizes that differ by more are others.
constexpr double kSameHeight = 0.15;  // metres between two feet, or two heads, of one row
// Choice: the stated errors of two sides.
constexpr double kSameSize = 0.1,
                 kSameShare = 0.05;  // metres, and share of a size, by which sizes that are alike differ
// Choice: three to five cells.
constexpr double kTouches = 0.1;  // metres between an opening and a part of the wall that nobody saw

bool is_measured_opening(const FacadeElement& e) {
  return e.opening && e.region == FacadeRegion::element && !e.ring.empty() && e.status != DrawnStatus::occluded;
}

bool is_alike(double a, double b) {
  return std::abs(a - b) <= kSameSize + kSameShare * a;
}

// The distance between two boxes; 0 where they overlap.
double gap_between(const Box2& a, const Box2& b) {
  const double u = std::max({a.u0 - b.u1, b.u0 - a.u1, 0.0}), v = std::max({a.v0 - b.v1, b.v0 - a.v1, 0.0});
  return std::sqrt(u * u + v * v);
}

struct Placed {
  const FacadeElement* element;
  Box2 box;
};

void compare(const Placed& other, const Placed& own, OpeningEvidence& evidence) {
  const Box2 &a = own.box, &b = other.box;
  if (!is_measured_opening(*other.element)) {
    evidence.beside_unseen |= gap_between(a, b) < kTouches;
    return;
  }
  evidence.in_row += std::abs(a.v0 - b.v0) < kSameHeight && std::abs(a.v1 - b.v1) < kSameHeight;
  evidence.alike += is_alike(own.element->width_m, other.element->width_m) &&
                    is_alike(own.element->height_m, other.element->height_m);
  evidence.gap = std::min(evidence.gap, gap_between(a, b));
  evidence.off_column = std::min(evidence.off_column, std::abs(a.u0 + a.u1 - b.u0 - b.u1) / 2);
}

FacadeElement possible_element(const Facade& f, const FacadeElement& opening, double metres_per_unit) {
  FacadeSite site;
  site.axes = {f.origin, f.right, f.up, f.out};
  site.metres_per_unit = metres_per_unit;
  const Box2 box = local_box(f, opening, metres_per_unit);
  UnseenArea area;
  area.ring = {{box.u0, box.v0}, {box.u1, box.v0}, {box.u1, box.v1}, {box.u0, box.v1}};
  area.straight = area.hidden = true;
  for (const FacadeEdge& edge : opening.edges) area.error = std::max(area.error, edge.error_m);
  FacadeElement e = unseen_of(site, area);
  e.reason = "an opening of its size, errors and neighbours is more likely none";
  return e;
}

}  // namespace

std::vector<OpeningEvidence> opening_evidence(const Facade& facade, double metres_per_unit) {
  std::vector<Placed> placed;
  for (const FacadeElement& e : facade.elements)
    if (is_measured_opening(e) || (is_unseen_place(e) && !e.ring.empty()))
      placed.push_back({&e, local_box(facade, e, metres_per_unit)});
  std::vector<OpeningEvidence> all;
  for (const Placed& own : placed) {
    const FacadeElement& e = *own.element;
    if (!is_measured_opening(e) || e.edges.empty()) continue;
    OpeningEvidence evidence;
    evidence.element = static_cast<std::size_t>(&e - facade.elements.data());
    evidence.width = e.width_m, evidence.height = e.height_m, evidence.depth = e.depth_m;
    const auto [least, greatest] = std::minmax_element(
        e.edges.begin(), e.edges.end(), [](const FacadeEdge& a, const FacadeEdge& b) { return a.error_m < b.error_m; });
    evidence.least_error = least->error_m, evidence.greatest_error = greatest->error_m;
    for (const Placed& other : placed)
      if (&other != &own) compare(other, own, evidence);
    all.push_back(evidence);
  }
  return all;
}

double opening_log_odds(const OpeningEvidence& e) {
  const auto log_within = [](double value, double low, double high) {
    return natural_log(std::clamp(value, low, high));
  };
  const auto log_of_count = [](std::size_t n) {
    return natural_log(1.0 + static_cast<double>(std::min<std::size_t>(n, 7)));
  };
  // Each value lies in the range that it had for nearly all openings that this was learnt from, few of which are lower
  // than 0.9 m.
  const double least_size = std::max(std::min(e.width, e.height), 0.3);
  const std::array<double, 10> values{log_within(e.greatest_error / least_size, 0.005, 3),
                                      log_within(e.least_error, 0.003, 0.3),
                                      log_of_count(e.in_row),
                                      log_of_count(e.alike),
                                      std::clamp(e.height, 0.9, 1.2),
                                      std::min(std::abs(e.depth), 0.5),
                                      log_within(e.gap, 0.05, 2),
                                      std::min(e.off_column, 1.0),
                                      std::abs(log_within(e.height / e.width, 0.22, 4.5)),
                                      e.beside_unseen ? 1.0 : 0.0};
  // Measured: bench/wild/opening_odds.py, seeds 10000000 to 10000074, 5531 openings of which 629 are in vain.
  constexpr std::array<double, 10> kWeights{-0.227, -0.631, 0.899, 0.655, 8.073, 2.667, 0.846, -0.975, -1.105, -0.718};
  // Measured: the same run.
  constexpr double kAtZero = -8.410;  // log odds where all values are 0
  double sum = kAtZero;
  for (std::size_t i = 0; i < values.size(); ++i) sum += kWeights[i] * values[i];
  return sum;
}

std::uint64_t keep_likely_openings(Facade& facade, double metres_per_unit) {
  std::vector<bool> dropped(facade.elements.size(), false);
  std::vector<FacadeElement> possible;
  std::uint64_t unseen = 0;
  for (const OpeningEvidence& evidence : opening_evidence(facade, metres_per_unit)) {
    if (!(opening_log_odds(evidence) < 0)) continue;
    const FacadeElement& e = facade.elements[evidence.element];
    dropped[evidence.element] = true;
    possible.push_back(possible_element(facade, e, metres_per_unit));
    unseen += unseen_sides(e);
  }
  for (FacadeElement& e : possible) facade.elements.push_back(std::move(e)), dropped.push_back(false);
  remove_elements(dropped, facade.elements);
  return unseen;
}

}  // namespace ilot
