// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/elements/facade_elements.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>

#include "engine/products/facades/elements/element_kinds.h"
#include "engine/products/facades/openings/pointed_top.h"
#include "engine/products/facades/walls/side_faces.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr std::array<const char*, 13> kNames{"window", "door",    "sill",    "lintel",     "balcony", "band", "bulge",
                                             "stone",  "bracket", "shutter", "protrusion", "recess",  "eaves"};

Vec3 place_of(const FacadeSite& site, double u, double v, double w) {
  const double units = 1 / site.metres_per_unit;
  return site.axes.origin + (u * units) * site.axes.right + (v * units) * site.axes.up + (w * units) * site.axes.out;
}

std::vector<Vec3> ring_of(const FacadeSite& site, const Box2& box, double w) {
  return {place_of(site, box.u0, box.v0, w), place_of(site, box.u1, box.v0, w), place_of(site, box.u1, box.v1, w),
          place_of(site, box.u0, box.v1, w)};
}

// The four corners in which neighbouring sides meet.
std::vector<Vec3> leaning_ring(const FacadeSite& site, const FoundRectangle& r) {
  const Box2 box = r.box();
  const double um = (box.u0 + box.u1) / 2, vm = (box.v0 + box.v1) / 2;
  const auto corner = [&](Side upright, Side level) {
    const double a = r.lean_of(upright), b = r.lean_of(level);
    const double u = (r.at(upright) + a * (r.at(level) - b * um - vm)) / (1 - a * b);
    return place_of(site, u, r.at(level) + b * (u - um), 0);
  };
  return {corner(Side::left, Side::bottom), corner(Side::right, Side::bottom), corner(Side::right, Side::top),
          corner(Side::left, Side::top)};
}

// The corners of an opening under an arch or a point, from the lower left on, and the side of each edge.
struct HeadedRing {
  std::vector<Vec3> corners;
  std::vector<Side> sides;
  std::vector<FacadeArc> arcs;

  void add(const FacadeSite& site, Place2 at, Side side) {
    corners.push_back(place_of(site, at.u, at.v, 0));
    sides.push_back(side);
  }
  // Adds the chords of an arc without its ends.
  void add_chords(const FacadeSite& site, Place2 centre, double radius, double from, double to) {
    // Derived: the sagitta of a chord of 5 degrees is 1e-3 of the radius, 0.5 mm of an arch with a radius of half a
    // metre.
    constexpr double kLongestChord = 5;  // degrees
    const int chords = std::max(2, static_cast<int>(std::ceil((to - from) / kLongestChord)));
    for (int i = 1; i < chords; ++i) {
      const double angle = from + (to - from) * i / chords;
      add(site, {centre.u + radius * cos_degrees(angle), centre.v + radius * cos_degrees(angle - 90)}, Side::top);
    }
    arcs.push_back({place_of(site, centre.u, centre.v, 0), radius, from, to});
  }
};

HeadedRing arched_ring(const FacadeSite& site, const FoundRectangle& r) {
  const Box2 box = r.box();
  const double u = r.arc->centre.u, v = box.v1 - r.arc->radius, radius = r.arc->radius;
  // A jamb that is a tangent within its error meets the arc at the height of the centre. The intersection of the two
  // would move by centimetres for each millimetre there.
  const auto springing = [&](double at, Side jamb) {
    const double up2 = radius * radius - (at - u) * (at - u);
    const bool tangent = std::abs(std::abs(at - u) - radius) <= r.error(jamb) + r.arc->error;
    return v + (up2 > 0 && !tangent ? std::sqrt(up2) : 0);
  };
  const double right = springing(box.u1, Side::right), left = springing(box.u0, Side::left);
  const double from = direction_degrees(box.u1 - u, right - v), to = direction_degrees(box.u0 - u, left - v);
  HeadedRing ring;
  ring.add(site, {box.u0, box.v0}, Side::bottom);
  ring.add(site, {box.u1, box.v0}, Side::right);
  ring.add(site, {box.u1, right}, Side::top);
  ring.add_chords(site, {u, v}, radius, from, to);
  ring.add(site, {box.u0, left}, Side::left);
  return ring;
}

HeadedRing pointed_ring(const FacadeSite& site, const FoundRectangle& r) {
  const Box2 box = r.box();
  const PointedTop& top = *r.pointed;
  const Place2 crown{(box.u0 + box.u1) / 2 + top.crown_u, box.v1};
  const Place2 right{box.u1, springing_of(r, Side::right)}, left{box.u0, springing_of(r, Side::left)};
  // The centre of the arc on one side, and the direction from it to a place.
  const auto centre = [&](double sign) { return Place2{crown.u + sign * top.centre.u, crown.v + top.centre.v}; };
  const auto direction = [](Place2 from, Place2 to) { return direction_degrees(to.u - from.u, to.v - from.v); };
  HeadedRing ring;
  ring.add(site, {box.u0, box.v0}, Side::bottom);
  ring.add(site, {box.u1, box.v0}, Side::right);
  ring.add(site, right, Side::top);
  if (top.radius > 0)
    ring.add_chords(site, centre(1), top.radius, direction(centre(1), right), direction(centre(1), crown));
  ring.add(site, crown, Side::top);
  if (top.radius > 0)
    ring.add_chords(site, centre(-1), top.radius, direction(centre(-1), crown), direction(centre(-1), left));
  ring.add(site, left, Side::left);
  return ring;
}

double both(double a, double b) {
  return std::sqrt(a * a + b * b);
}

// Families of one member are none.
void dissolve_families_of_one(std::vector<FacadeElement>& elements) {
  std::map<std::uint32_t, std::size_t> members;
  for (const FacadeElement& e : elements) ++members[e.family];
  for (FacadeElement& e : elements)
    if (members[e.family] == 1) e.family = 0;
}

// Whether the edges of an element after the second one are the chords of a head and then its left side.
bool is_headed(const FacadeElement& e) {
  return e.edges.size() > kSides.size() && (e.opening || !e.arcs.empty());
}

// What is said of an opening a part of which is empty. That rays crossed it is known of stations only.
std::string words_of_silence(const FacadeSite& site, const FoundRectangle& r) {
  const bool has_points = r.points > 0 && r.depth != 0;
  if (site.stations.empty()) return has_points ? "a part of it has no points" : "no points in it";
  return has_points ? "no echo came back through a part of it" : "no echo came back through it";
}

}  // namespace

FacadeElement element_of(const FacadeSite& site, const ElementCandidate& candidate) {
  const FoundRectangle& r = candidate.shape;
  FacadeElement e;
  e.kind = kNames[static_cast<std::size_t>(candidate.kind)];
  e.opening = is_opening(candidate.kind);
  e.family = candidate.family;
  e.row = candidate.row;
  e.column = candidate.column;
  std::vector<Side> sides(kSides.begin(), kSides.end());
  if (r.arc || r.pointed) {
    HeadedRing headed = r.arc ? arched_ring(site, r) : pointed_ring(site, r);
    e.ring = std::move(headed.corners);
    e.arcs = std::move(headed.arcs);
    sides = std::move(headed.sides);
  } else if (r.leans()) {
    e.ring = leaning_ring(site, r);
  } else {
    const bool in_wall = e.opening || candidate.kind >= ElementKind::protrusion;
    e.ring = ring_of(site, r.box(), in_wall ? 0 : r.depth);
  }
  for (const Side side : sides) {
    const LocatedEdge& edge = r.side(side);
    e.edges.push_back({edge.status, edge.points, edge.rms, std::max(edge.error, edge.form), edge.moved});
  }
  const auto hidden = static_cast<std::size_t>(std::count_if(
      r.sides.begin(), r.sides.end(), [](const LocatedEdge& edge) { return edge.status == DrawnStatus::occluded; }));
  e.reason = candidate.reason;
  if (r.few_echoes)
    e.reason = std::string("its pane sent back few of the rays") + (e.reason.empty() ? "" : "; ") + e.reason;
  if (r.no_echo) e.reason = words_of_silence(site, r) + (e.reason.empty() ? "" : "; ") + e.reason;
  if (hidden == r.sides.size()) e.status = DrawnStatus::occluded;
  e.width_m = r.box().width();
  e.height_m = r.box().height();
  e.depth_m = r.depth;
  state_size_errors(e);
  e.depth_error_m = r.depth_error;
  e.points = r.points;
  if (r.is_rectangle() && r.depth != 0 && r.end) e.body = body_between(site, r.box(), 0, *r.end, r.depth);
  return e;
}

FacadeElement wall_of(const RaySamples& samples, const WallOutline& outline) {
  const FacadeSite& site = samples.site();
  FacadeElement e;
  e.kind = "outline";
  e.region = FacadeRegion::facade;
  e.edges = outline.edges;
  for (const Place2& p : outline.ring) e.ring.push_back(place_of(site, p.u, p.v, 0));
  const Box2 box = box_of(outline.ring);
  e.width_m = box.width(), e.height_m = box.v1;
  e.width_error_m = e.height_error_m = site.step;
  e.points = samples.points_on_wall();
  return e;
}

FacadeElement unseen_of(const FacadeSite& site, const UnseenArea& area) {
  FacadeElement e;
  e.kind = area.straight ? "possible opening" : "not seen";
  e.region = FacadeRegion::facade;
  e.status = DrawnStatus::occluded;
  // Without stations no ray is known; that there are no points is all that can be said.
  const char* const bare = site.stations.empty() ? "no points there" : "no ray reached it";
  e.reason = area.straight ? "a hole with straight sides that no free ray is known to have crossed" : bare;
  if (area.hidden) e.reason = "too little of this opening was seen";
  const Box2 box = box_of(area.ring);
  for (const Place2& p : area.ring) {
    e.ring.push_back(place_of(site, p.u, p.v, 0));
    e.edges.push_back({DrawnStatus::occluded, 0, 0, area.error, 0});
  }
  e.width_m = box.width();
  e.height_m = box.height();
  e.width_error_m = e.height_error_m = both(area.error, area.error);
  return e;
}

UnseenArea possible_area(const ElementCandidate& opening) {
  const Box2 box = opening.shape.box();
  UnseenArea area;
  area.ring = {{box.u0, box.v0}, {box.u1, box.v0}, {box.u1, box.v1}, {box.u0, box.v1}};
  area.straight = area.hidden = true;
  for (const LocatedEdge& edge : opening.shape.sides) area.error = std::max(area.error, edge.error);
  return area;
}

FacadeElement irregularity_of(const FacadeSite& site, const Irregularity& i) {
  FacadeElement e;
  e.kind = "bulge";
  e.region = FacadeRegion::irregularity;
  const Box2 box = box_of(i.ring);
  for (const Place2& p : i.ring) {
    e.ring.push_back(place_of(site, p.u, p.v, 0));
    e.edges.push_back({DrawnStatus::seen, 0, 0, site.step, 0});
  }
  e.width_m = box.width();
  e.height_m = box.height();
  e.depth_m = i.rise;
  e.width_error_m = e.height_error_m = both(site.step, site.step);
  e.depth_error_m = i.rise_error;
  e.points = i.points;
  for (const Vec3& p : i.vertices) e.body.vertices.push_back(place_of(site, p.x, p.y, p.z));
  for (const auto& t : i.triangles) e.body.faces.push_back({t[0], t[1], t[2]});
  return e;
}

std::uint64_t unseen_sides(const FacadeElement& e) {
  const auto unseen = [](const FacadeEdge& edge) {
    return edge.status == DrawnStatus::completed || edge.status == DrawnStatus::occluded;
  };
  if (!is_headed(e)) return static_cast<std::uint64_t>(std::count_if(e.edges.begin(), e.edges.end(), unseen));
  // The edges of a head lie between the right side and the left side, which is the last one.
  return static_cast<std::uint64_t>(unseen(e.edges[0])) + unseen(e.edges[1]) + unseen(e.edges[2]) +
         unseen(e.edges.back());
}

void remove_elements(const std::vector<bool>& removed, std::vector<FacadeElement>& elements) {
  if (std::find(removed.begin(), removed.end(), true) == removed.end()) return;
  std::vector<FacadeElement> left;
  for (std::size_t i = 0; i < elements.size(); ++i)
    if (!removed[i]) left.push_back(std::move(elements[i]));
  elements = std::move(left);
  dissolve_families_of_one(elements);
  for (std::uint32_t k = 0; k < elements.size(); ++k) elements[k].id = k + 1;
}

void state_size_errors(FacadeElement& e) {
  if (e.edges.size() != kSides.size() && !is_headed(e)) return;
  // 0 where one of the two was set by hand, which has no stated error.
  const auto of_two = [](const FacadeEdge& a, const FacadeEdge& b) {
    const bool by_hand = a.status == DrawnStatus::by_hand || b.status == DrawnStatus::by_hand;
    return by_hand ? 0 : both(a.error_m, b.error_m);
  };
  const auto less = [](const FacadeEdge& a, const FacadeEdge& b) { return a.error_m < b.error_m; };
  e.width_error_m = of_two(e.edges[1], e.edges.back());
  e.height_error_m = of_two(e.edges[0], *std::max_element(e.edges.begin() + 2, e.edges.end() - 1, less));
}

void add_registration(double error, std::span<FacadeElement> elements) {
  const double of_two = both(error, error);
  for (FacadeElement& e : elements) {
    for (FacadeEdge& edge : e.edges)
      if (edge.error_m > 0) edge.error_m = both(edge.error_m, error);
    for (double* size : {&e.width_error_m, &e.height_error_m})
      if (*size > 0) *size = both(*size, of_two);
  }
}

}  // namespace ilot
