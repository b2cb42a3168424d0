// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/facade_model.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/facades/side_faces.h"
#include "engine/facades/slices.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr double kDoorSill = 0.4, kDoorHeight = 1.8;  // metres above the foot of the wall; least
constexpr double kDoorLine = 0.25;                    // metres between the tops of doors in one row
constexpr double kBesideOpening = 0.25;               // metres between an opening and its sill or lintel
constexpr double kUnder = 0.7;                        // share of the opening's width that it spans
constexpr double kLongerThanHigh = 2.5;               // of sills and lintels
constexpr double kBandShare = 0.4, kBalcony = 0.3;    // of the wall's width; metres before the wall
constexpr double kParapet = 1.5, kRail = 0.05;        // metres: balconies are lower, nothing thinner is built of stone
constexpr double kSameThing = 0.8;                    // of an area, that what is found twice has in common
constexpr double kStraight = 0.02;                    // metres: a side's ends before and behind, of one that leans not
constexpr double kMostOf = 0.5;                       // of a thing: what is no more than a part lends it no sides
constexpr double kSamePatch = 0.5;                    // of a patch, that lies within an irregularity
constexpr std::array<const char*, 11> kNames{"window", "door",  "sill",       "lintel", "balcony", "band",
                                             "bulge",  "stone", "protrusion", "recess", "eaves"};

bool is_opening(ThingKind kind) {
  return kind == ThingKind::window || kind == ThingKind::door;
}

bool is_door(const FoundRectangle& r) {
  const Box2 box = r.box();
  return box.v0 < kDoorSill && box.height() > kDoorHeight;
}

// A door goes down to the foot of the wall; where its lower part is hidden, its top is in line with other doors'.
ThingKind kind_of_opening(const FoundRectangle& r, const std::vector<FoundRectangle>& openings) {
  if (is_door(r)) return ThingKind::door;
  if (r.side(Side::bottom).status == DrawnStatus::seen || r.at(Side::top) < kDoorHeight) return ThingKind::window;
  const bool in_line = std::any_of(openings.begin(), openings.end(), [&](const FoundRectangle& o) {
    return is_door(o) && std::abs(o.at(Side::top) - r.at(Side::top)) < kDoorLine;
  });
  return in_line && r.at(Side::bottom) - r.error(Side::bottom) < kDoorSill ? ThingKind::door : ThingKind::window;
}

ThingKind kind_of_relief(const FoundRectangle& r, const std::vector<FoundRectangle>& openings, double wall_width) {
  const Box2 box = r.box();
  const bool flat = box.width() > kLongerThanHigh * box.height();
  if (flat && box.width() > kBandShare * wall_width) return r.depth > kBalcony ? ThingKind::balcony : ThingKind::band;
  for (const FoundRectangle& o : openings) {
    const Box2 hole = o.box();
    const double common = std::min(hole.u1, box.u1) - std::max(hole.u0, box.u0);
    if (!flat || r.depth > kBalcony || common < kUnder * hole.width() || box.width() > 2 * hole.width()) continue;
    if (std::abs(box.v1 - hole.v0) < kBesideOpening && box.v0 < hole.v0) return ThingKind::sill;
    if (std::abs(box.v0 - hole.v1) < kBesideOpening && box.v1 > hole.v1) return ThingKind::lintel;
  }
  return r.depth > kBalcony ? ThingKind::balcony : ThingKind::bulge;
}

Vec3 place_of(const FacadeSite& site, double u, double v, double w) {
  const double units = 1 / site.metres_per_unit;
  return site.axes.origin + (u * units) * site.axes.right + (v * units) * site.axes.up + (w * units) * site.axes.out;
}

std::vector<Vec3> ring_of(const FacadeSite& site, const Box2& box, double w) {
  return {place_of(site, box.u0, box.v0, w), place_of(site, box.u1, box.v0, w), place_of(site, box.u1, box.v1, w),
          place_of(site, box.u0, box.v1, w)};
}

// The corners of an opening under an arc, from the lower left on, and which side each edge belongs to.
struct ArchedRing {
  std::vector<Vec3> corners;
  std::vector<Side> sides;
  FacadeArc arc;
};

ArchedRing arched_ring(const FacadeSite& site, const FoundRectangle& r) {
  constexpr double kLongestChord = 5;  // degrees
  const Box2 box = r.box();
  const double u = r.arc->centre.u, v = box.v1 - r.arc->radius, radius = r.arc->radius;
  const auto springing = [&](double at) {
    const double up2 = radius * radius - (at - u) * (at - u);
    return v + (up2 > 0 ? std::sqrt(up2) : 0);
  };
  const double right = springing(box.u1), left = springing(box.u0);
  const double from = direction_degrees(box.u1 - u, right - v), to = direction_degrees(box.u0 - u, left - v);
  ArchedRing ring;
  const auto add = [&](double at_u, double at_v, Side side) {
    ring.corners.push_back(place_of(site, at_u, at_v, 0));
    ring.sides.push_back(side);
  };
  add(box.u0, box.v0, Side::bottom);
  add(box.u1, box.v0, Side::right);
  add(box.u1, right, Side::top);
  const int chords = std::max(2, static_cast<int>(std::ceil((to - from) / kLongestChord)));
  for (int i = 1; i < chords; ++i) {
    const double angle = from + (to - from) * i / chords;
    add(u + radius * cos_degrees(angle), v + radius * cos_degrees(angle - 90), Side::top);
  }
  add(box.u0, left, Side::left);
  ring.arc = {place_of(site, u, v, 0), radius, from, to};
  return ring;
}

double common_area(const Box2& a, const Box2& b) {
  return std::max(0.0, std::min(a.u1, b.u1) - std::max(a.u0, b.u0)) *
         std::max(0.0, std::min(a.v1, b.v1) - std::max(a.v0, b.v0));
}

double both(double a, double b) {
  return std::sqrt(a * a + b * b);
}

FacadeElement element_of(const FacadeSite& site, const FacadeThing& thing) {
  const FoundRectangle& r = thing.shape;
  FacadeElement e;
  e.kind = kNames[static_cast<std::size_t>(thing.kind)];
  e.opening = is_opening(thing.kind);
  e.family = thing.family;
  e.row = thing.row;
  e.column = thing.column;
  std::vector<Side> sides(kSides.begin(), kSides.end());
  if (r.arc) {
    ArchedRing arched = arched_ring(site, r);
    e.ring = std::move(arched.corners);
    e.arcs = {arched.arc};
    sides = std::move(arched.sides);
  } else {
    const bool in_wall = e.opening || thing.kind >= ThingKind::protrusion;
    e.ring = ring_of(site, r.box(), in_wall ? 0 : r.depth);
  }
  for (const Side side : sides) {
    const LocatedEdge& edge = r.side(side);
    e.edges.push_back({edge.status, edge.points, edge.rms, edge.error, edge.moved});
  }
  const auto hidden = static_cast<std::size_t>(std::count_if(
      r.sides.begin(), r.sides.end(), [](const LocatedEdge& edge) { return edge.status == DrawnStatus::occluded; }));
  e.reason = thing.reason;
  if (hidden == r.sides.size()) e.status = DrawnStatus::occluded;
  e.width_m = r.box().width();
  e.height_m = r.box().height();
  e.depth_m = r.depth;
  e.width_error_m = std::min(r.width_error, both(r.error(Side::left), r.error(Side::right)));
  e.height_error_m = std::min(r.height_error, both(r.error(Side::bottom), r.error(Side::top)));
  e.depth_error_m = r.depth_error;
  e.points = r.points;
  if (!r.arc && r.depth != 0 && r.end) e.body = body_between(site, r.box(), 0, *r.end, r.depth);
  return e;
}

FacadeElement wall_of(const FacadeSite& site) {
  FacadeElement e;
  e.kind = "outline";
  e.region = FacadeRegion::facade;
  e.ring = ring_of(site, {0, site.width, 0, site.height}, 0);
  e.width_m = site.width;
  e.height_m = site.height;
  e.width_error_m = e.height_error_m = site.step;
  for (const FacadePoint& p : site.points) e.points += std::abs(static_cast<double>(p.w)) <= site.epsilon;
  return e;
}

// A bulge or a hollow: its outline in the wall, its surface as a mesh [C11].
FacadeElement irregularity_of(const FacadeSite& site, const Irregularity& i) {
  FacadeElement e;
  e.kind = "bulge";
  e.region = FacadeRegion::irregularity;
  Box2 box{INFINITY, -INFINITY, INFINITY, -INFINITY};
  for (const Place2& p : i.ring) {
    e.ring.push_back(place_of(site, p.u, p.v, 0));
    e.edges.push_back({DrawnStatus::seen, 0, 0, site.step, 0});
    box = {std::min(box.u0, p.u), std::max(box.u1, p.u), std::min(box.v0, p.v), std::max(box.v1, p.v)};
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

// What is not a part of an irregularity: its patches of plane are no things of their own, and nothing else is in it.
std::vector<Box2> boxes_of_elements(const std::vector<FacadeThing>& things) {
  std::vector<Box2> boxes;
  for (const FacadeThing& t : things)
    if (t.kind != ThingKind::bulge) boxes.push_back(t.shape.box());
  return boxes;
}

void drop_patches(std::vector<FacadeThing>& things, const std::vector<Irregularity>& irregular) {
  std::erase_if(things, [&](const FacadeThing& t) {
    const Box2 own = t.shape.box();
    return t.kind == ThingKind::bulge && std::any_of(irregular.begin(), irregular.end(), [&](const Irregularity& i) {
             Box2 box{INFINITY, -INFINITY, INFINITY, -INFINITY};
             for (const Place2& p : i.ring)
               box = {std::min(box.u0, p.u), std::max(box.u1, p.u), std::min(box.v0, p.v), std::max(box.v1, p.v)};
             return common_area(box, own) >= kSamePatch * own.width() * own.height();
           });
  });
}

// The order in which elements are numbered.
bool comes_before(const FacadeThing& a, const FacadeThing& b) {
  const Box2 p = a.shape.box(), q = b.shape.box();
  if (a.kind != b.kind) return a.kind < b.kind;
  if (a.row != b.row) return a.row < b.row;
  if (p.u0 != q.u0) return p.u0 < q.u0;
  return p.v0 != q.v0 ? p.v0 < q.v0 : a.shape.depth < b.shape.depth;
}

// Bulges that overlap are patches of one.
void merge_bulges(std::vector<FacadeThing>& things) {
  const auto overlap = [](const FacadeThing& a, const FacadeThing& b) {
    const Box2 p = a.shape.box(), q = b.shape.box();
    return a.kind == ThingKind::bulge && b.kind == ThingKind::bulge && p.u0 < q.u1 && q.u0 < p.u1 && p.v0 < q.v1 &&
           q.v0 < p.v1;
  };
  for (bool more = true; more;) {
    more = false;
    for (std::size_t a = 0; a < things.size(); ++a)
      for (std::size_t b = a + 1; b < things.size();) {
        if (!overlap(things[a], things[b])) {
          ++b;
          continue;
        }
        FoundRectangle &p = things[a].shape, &q = things[b].shape;
        const auto outer = [&](Side side, bool low) {
          if (low ? q.at(side) < p.at(side) : q.at(side) > p.at(side)) p.side(side) = q.side(side);
        };
        outer(Side::left, true), outer(Side::bottom, true), outer(Side::right, false), outer(Side::top, false);
        if (q.depth > p.depth) p.depth = q.depth, p.depth_error = q.depth_error;
        p.points += q.points;
        things.erase(things.begin() + static_cast<std::ptrdiff_t>(b));
        more = true;
      }
  }
}

// Sides that points of side faces tell are known better than those between points of the wall and what is behind. An
// opening that nothing fills has no depth of its own: a niche has.
void take_better_sides(FoundRectangle& known, const FoundRectangle& found) {
  if (known.depth == 0) known.depth = found.depth, known.depth_error = found.depth_error, known.end = found.end;
  for (const Side side : kSides)
    if (found.side(side).by_face && !known.side(side).by_face && found.error(side) < known.error(side))
      known.side(side) = found.side(side);
}

// What stands out above the wall is eaves; a balcony is long, no storey high and stands out as far as one can stand on.
ThingKind kind_of_large(const FoundRectangle& r, double wall_height) {
  const Box2 box = r.box();
  if (r.depth < 0) return ThingKind::recess;
  if ((box.v0 + box.v1) / 2 > wall_height) return ThingKind::eaves;
  const bool flat = box.width() > kLongerThanHigh * box.height() && box.height() < kParapet;
  return flat && r.depth > kBalcony ? ThingKind::balcony : ThingKind::protrusion;
}

// Rails and bars before windows and along balconies.
bool is_rail(const FacadeThing& t) {
  const Box2 box = t.shape.box();
  const bool unnamed = t.kind == ThingKind::bulge || t.kind == ThingKind::balcony;
  return unnamed && std::min(box.width(), box.height()) < kRail;
}

// What is large and not found yet, in place of what is only a part of it: the front of a bay.
void add_large_relief(std::vector<FacadeThing>& things, const std::vector<FoundRectangle>& large, double wall_height) {
  for (const FoundRectangle& r : large) {
    const Box2 box = r.box();
    const auto same_side = [&](const FacadeThing& t) {
      return (t.shape.depth > 0) == (r.depth > 0) && t.kind != ThingKind::stone;
    };
    const auto known = std::find_if(things.begin(), things.end(), [&](const FacadeThing& t) {
      return same_side(t) && common_area(box, t.shape.box()) >= kSameThing * box.width() * box.height();
    });
    if (known != things.end()) {
      const Box2 own = known->shape.box();
      if (common_area(box, own) >= kMostOf * own.width() * own.height()) take_better_sides(known->shape, r);
      continue;
    }
    // Openings within a recess stay: they go on from its back.
    std::erase_if(things, [&](const FacadeThing& t) {
      const Box2 own = t.shape.box();
      return r.depth > 0 && same_side(t) && common_area(box, own) >= kSameThing * own.width() * own.height();
    });
    things.push_back({r, kind_of_large(r, wall_height), 0, 0, 0, {}});
  }
}

std::vector<FacadeThing> things_of(const RaySamples& samples, const FacadeParams& params) {
  const std::vector<FoundRectangle> openings = find_openings(samples, params.openings);
  std::vector<FacadeThing> things;
  for (const FoundRectangle& o : openings) things.push_back({o, kind_of_opening(o, openings), 0, 0, 0, {}});
  for (const FoundRectangle& r : find_relief(samples, params.relief))
    things.push_back({r, kind_of_relief(r, openings, samples.site().width), 0, 0, 0, {}});
  for (const FoundRectangle& s : find_stones(samples)) things.push_back({s, ThingKind::stone, 0, 0, 0, {}});
  merge_bulges(things);
  std::erase_if(things, is_rail);
  add_large_relief(things, find_large_relief(samples, params.large), samples.site().height);
  return things;
}

// Sides that do not lean end where the outline is drawn.
Box2 straightened(const Box2& end, const Box2& measured, const Box2& drawn) {
  const auto side = [](double at, double from, double now) { return std::abs(at - from) < kStraight ? now : at; };
  return {side(end.u0, measured.u0, drawn.u0), side(end.u1, measured.u1, drawn.u1), side(end.v0, measured.v0, drawn.v0),
          side(end.v1, measured.v1, drawn.v1)};
}

// What a thing comes down to at its depth [C10], where its sides are seen to lean.
void find_ends(std::vector<FacadeThing>& things, const RaySamples& samples) {
  constexpr double kMargin = 0.05;  // metres around its outline that its end may reach
  for (FacadeThing& t : things) {
    FoundRectangle& r = t.shape;
    const Box2 box = r.box();
    if (r.end) r.end = straightened(*r.end, box, box);
    if (r.end || r.arc || t.kind == ThingKind::stone || r.depth == 0) continue;
    const double about = 1.5 * SliceParams{}.spacing;
    const std::optional<FacadeSlice> end =
        end_slice(slices_of(samples, box.grown(kMargin), r.depth - about, r.depth + about));
    if (!end) continue;
    const SideFaces faces = side_faces(samples, box, end->extent.grown(samples.site().step / 2), r.depth);
    r.end = straightened(faces.end, faces.outline, box);
  }
}

}  // namespace

FoundFacade find_facade(const FacadeSite& site, const FacadeParams& params) {
  const RaySamples samples(site);
  std::vector<FacadeThing> things = things_of(samples, params);
  const std::vector<Irregularity> irregular = find_irregularities(samples, boxes_of_elements(things), params.irregular);
  drop_patches(things, irregular);
  group_things(things, params.regular);
  if (params.regularise) {
    regularise_things(things, params.regular);
    complete_things(things, params.regular);
    group_things(things, params.regular);
  }
  find_ends(things, samples);
  std::sort(things.begin(), things.end(), comes_before);

  FoundFacade found;
  Facade& f = found.facade;
  f.crs = site.crs;
  f.origin = site.axes.origin;
  f.right = site.axes.right;
  f.up = site.axes.up;
  f.out = site.axes.out;
  f.width_m = site.width;
  f.height_m = site.height;
  f.elements.push_back(wall_of(site));
  for (const FacadeThing& thing : things) {
    f.elements.push_back(element_of(site, thing));
    for (const LocatedEdge& edge : thing.shape.sides) found.occluded_edges += edge.status != DrawnStatus::seen;
  }
  for (const Irregularity& i : irregular) f.elements.push_back(irregularity_of(site, i));
  for (std::uint32_t i = 0; i < f.elements.size(); ++i) f.elements[i].id = i + 1;
  return found;
}

}  // namespace ilot
