// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/dormers.h"

#include <algorithm>
#include <cmath>

#include "engine/products/facades/elements/facade_elements.h"

namespace ilot {
namespace {

// Choice: three rows of tiles; a dormer whose cheek hides them keeps no proof of a roof.
constexpr double kBelowFront = 0.3;  // metres below a front in which the roof would be seen
// Choice: at 45 degrees, the roof is within the height of a low front.
constexpr double kRoofDepth = 1;  // metres before and behind a front in which the roof may be
// Choice: oblique tiles get a fifth of the points of a wall; sparser roofs are not seen.
constexpr double kSeenBelow = 0.2;  // share of the points that a wall would have there

void shift(FoundRectangle& r, double du, double dv) {
  for (const Side side : kSides) {
    LocatedEdge& edge = r.side(side);
    const double by = side == Side::left || side == Side::right ? du : dv;
    edge.at += by, edge.inner += by;
  }
  if (r.arc) r.arc->centre = {r.arc->centre.u + du, r.arc->centre.v + dv};
  if (r.end) *r.end = {r.end->u0 + du, r.end->u1 + du, r.end->v0 + dv, r.end->v1 + dv};
}

// The place of the origin of a front in the axes of the facade, in metres.
Vec3 place_in(const Facade& facade, const FacadeSite& front) {
  const Vec3 d = front.metres_per_unit * (front.axes.origin - facade.origin);
  return {dot(d, facade.right), dot(d, facade.up), dot(d, facade.out)};
}

bool foot_is_hidden(const RaySamples& samples) {
  const FacadeSite& front = samples.site();
  std::uint64_t seen = 0;
  for (const Ray& ray : samples.at_places({0, front.width, -kBelowFront, -front.step})) {
    const FacadePoint& p = ray.at;
    seen += p.u >= 0 && p.u <= front.width && p.v < -front.step && p.v >= -kBelowFront &&
            std::abs(static_cast<double>(p.w)) < kRoofDepth;
  }
  return static_cast<double>(seen) < kSeenBelow * front.width * kBelowFront / (front.step * front.step);
}

FacadeElement outline_of(const RaySamples& samples, const DormerParams& params) {
  const FacadeSite& front = samples.site();
  FacadeElement e = wall_of(samples, wall_outline(samples, params.outline));
  e.kind = "dormer";
  e.region = FacadeRegion::element;
  e.depth_error_m = front.noise;
  if (e.edges.empty())
    for (std::size_t i = 0; i < e.ring.size(); ++i) e.edges.push_back({DrawnStatus::seen, 0, 0, front.step, 0});
  if (foot_is_hidden(samples)) {
    e.edges[0].status = DrawnStatus::occluded;
    e.reason = "its foot is hidden by what stands below it";
  }
  return e;
}

// An opening of a front, in the axes of the front, and the place of these in the axes of the facade.
struct DormerOpening {
  const FacadeSite* front;
  Vec3 at;
  FoundRectangle shape;
};

// The openings of all fronts together, in the axes of the facade.
std::vector<ElementCandidate> completed(const std::vector<DormerOpening>& openings, const DormerParams& params) {
  std::vector<ElementCandidate> candidates;
  for (const DormerOpening& o : openings) {
    candidates.push_back({o.shape, ElementKind::window, 0, 0, 0, {}});
    shift(candidates.back().shape, o.at.x, o.at.y);
  }
  group_elements(candidates, params.regular);
  if (!params.regularise) return candidates;
  regularise_elements(candidates, params.regular);
  complete_elements(candidates, params.regular);
  return candidates;
}

// Rows, columns and families are formed of all fronts together. Their numbers follow those of the facade itself. What
// is only possible comes last and belongs to none.
std::vector<FacadeElement> elements_of(const std::vector<DormerOpening>& openings, const Facade& facade,
                                       const DormerParams& params) {
  std::uint32_t rows = 0, families = 0;
  for (const FacadeElement& e : facade.elements) rows = std::max(rows, e.row), families = std::max(families, e.family);
  std::vector<ElementCandidate> all = completed(openings, params), sure;
  std::vector<const DormerOpening*> of_sure;
  std::vector<FacadeElement> elements, possible;
  for (std::size_t i = 0; i < all.size(); ++i) {
    const DormerOpening& o = openings[i];
    if (!all[i].possible) {
      sure.push_back(std::move(all[i])), of_sure.push_back(&o);
    } else if (area_of(all[i].shape.box()) > 0) {
      shift(all[i].shape, -o.at.x, -o.at.y);
      possible.push_back(unseen_of(*o.front, possible_area(all[i])));
    }
  }
  group_elements(sure, params.regular);
  for (std::size_t i = 0; i < sure.size(); ++i) {
    shift(sure[i].shape, -of_sure[i]->at.x, -of_sure[i]->at.y);
    sure[i].row += rows;
    if (sure[i].family != 0) sure[i].family += families;
    elements.push_back(element_of(*of_sure[i]->front, sure[i]));
  }
  for (FacadeElement& e : possible) elements.push_back(std::move(e));
  return elements;
}

}  // namespace

DormerFront find_dormer(const RaySamples& samples, const DormerParams& params) {
  DormerFront front{samples.site(), {}, find_openings(samples, params.openings)};
  front.site.points = {};
  front.site.from = {};
  if (!front.openings.empty()) front.outline = outline_of(samples, params);
  return front;
}

std::uint64_t add_dormers(const std::vector<DormerFront>& fronts, Facade& facade, const DormerParams& params) {
  std::vector<FacadeElement> added;
  std::vector<DormerOpening> openings;
  for (const DormerFront& front : fronts) {
    if (front.openings.empty()) continue;
    const Vec3 at = place_in(facade, front.site);
    added.push_back(front.outline);
    added.back().depth_m = at.z;
    for (const FoundRectangle& r : front.openings) openings.push_back({&front.site, at, r});
  }
  for (FacadeElement& e : elements_of(openings, facade, params)) added.push_back(std::move(e));
  std::uint64_t hidden = 0;
  for (FacadeElement& e : added) {
    if (e.status != DrawnStatus::occluded || e.opening) hidden += unseen_sides(e);
    e.id = static_cast<std::uint32_t>(facade.elements.size() + 1);
    facade.elements.push_back(std::move(e));
  }
  return hidden;
}

}  // namespace ilot
