// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/sides/located_edge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/products/facades/sides/edge_bounds.h"
#include "engine/products/facades/sides/face_cluster.h"
#include "kernels/core/quantile.h"
#include "kernels/outlines/edge_split.h"

namespace ilot {
namespace {

// Choice: rounded corners and mixed pixels; of an opening of 0.3 m 4 cm are left out.
constexpr double kCornerShare = 0.12, kCornerMost = 0.15;  // share of a side, and metres, left out at its ends
// Derived: even steps leave gaps of one, a lost ray of two; wider gaps have a cause.
constexpr double kStepsOfShadow = 3;  // a gap wider than so many steps is a laser shadow
// Choice: half of a beam of 4 mm, as terrestrial scanners have at 10 m; wider beams blur edges more.
constexpr double kBeam = 0.002;  // metres: echoes from the rim of a beam lie behind the edge that they came from
// Choice: rays of two stations at one wall seldom differ by more than 30 degrees; half of the depth is their offset
// then.
constexpr double kGuessed = 0.5;  // share of the depth: possible error of a ray whose station was chosen among several
// Choice: a storey: the side may be anywhere within it.
constexpr double kNothingKnown = 3;  // metres: possible error of a hidden side
// Choice: two steps of 1 cm.
constexpr double kBesideGap = 0.02;  // metres beside the gap in which points of the face may lie
// Choice: the depth of usual sills; of deeper ones the part next to them counts.
constexpr double kCornerDeep = 0.1;  // metres before an element in which points of the face at which it ends may lie
// Choice: two steps of 1 cm.
constexpr double kCornerReach = 0.02;  // metres beside its last points
// Derived: two neighbouring scan lines are one step apart; two steps contain one line always.
constexpr double kSlotSteps = 2;  // steps along a side in which one scan line ends, at least
// Derived: 4 standard deviations, plus and minus two: 95 % of normal noise.
constexpr double kFaceWidths = 4;  // times the noise: width of the interval that contains the points of a face
// Derived: 95 % of normal errors. The arris of a wall is as rough as its face.
constexpr double kBoundOfNoise = 2;              // times the noise of the wall
constexpr std::uint64_t kMostSamples = 1 << 16;  // of a side; more do not improve the result; 70 bytes each

// The samples around one side; t is positive outwards.
struct SideSamples {
  std::vector<double> inside, outside;
  std::vector<double> inside_along, outside_along;  // place along the side of each of these
  std::vector<FacePoint> face, corner;
  std::vector<FacePoint> rim;  // echoes of beams that the edge of an element split, where their rays cross its plane
  int level = 0;               // above 0: only the samples that are kept at this level
  std::vector<double> before;  // rays that end before the plane
  std::size_t through = 0;     // number of rays that go through the plane, kept or not
  std::size_t hidden = 0;      // number of rays that end before the plane, beyond the side
  std::size_t deep = 0;        // number of rays beside an element that go far behind the wall
  double lean = 1;  // tangent of the angle between the rays to the face and the normal of the plane, at least 1
};

struct SideSpan {
  double t, s0, s1;
  double in, out;  // metres on the inner and on the outer side of it that are searched
  bool has(double at) const { return at - t <= out && t - at <= in; }
};

SideSpan span_of(const SideSearch& q, Side side) {
  const Box2& box = q.box;
  const double t = side == Side::left ? box.u0 : side == Side::right ? box.u1 : side == Side::top ? box.v1 : box.v0;
  double s0 = along_u(side) ? box.v0 : box.u0, s1 = along_u(side) ? box.v1 : box.u1;
  const double corner = std::min(kCornerMost, kCornerShare * (s1 - s0));
  return {t * outwards(side), s0 + corner, s1 - corner, q.reach, q.reach};
}

// Whether a side face at t can be seen from the eye. A face that looks outwards is seen from beyond it, any other face
// from before it.
bool turns_to(const Vec3* eye, Side side, double t, bool looks_outwards) {
  if (eye == nullptr) return true;
  const double beyond = outwards(side) * (along_u(side) ? eye->x : eye->y) - t;
  return looks_outwards ? beyond > 0 : beyond < 0;
}

// The innermost place of a ray beside an element, on its way from the plane of the element to where the ray ended, to
// the foot of the element, or past its ends. This whole way is outside. A ray that met the side face crosses the plane
// beyond the edge; the distance depends on how oblique the ray is.
double innermost(const RaySamples& rays, const Ray& ray, const SideSearch& q, Side side, const SideSpan& span) {
  const auto across = [&](Place2 p) { return outwards(side) * (along_u(side) ? p.u : p.v); };
  const auto along = [&](Place2 p) { return along_u(side) ? p.v : p.u; };
  const Place2 at = rays.crossing(ray, q.depth);
  const double w = ray.at.w, t = across(at), s = along(at);
  if (w >= q.depth || q.face_from >= q.depth) return t;
  const Place2 end = rays.crossing(ray, std::max(w, q.face_from));
  const double way = along(end) - s, left = (way > 0 ? span.s1 : span.s0) - s;
  const double share = std::abs(way) > std::abs(left) ? left / way : 1;
  return std::min(t, t + share * (across(end) - t));
}

// Whether a point behind the plane of an element is a mixed pixel and no surface: it is on no segment, and its station
// does not see the side face. A beam that the edge splits gives an echo between the element and what is behind it.
bool is_mixed_echo(const RaySamples& rays, const Ray& ray, const SideSearch& q, Side side, double at_plane) {
  if (q.hole || !rays.oblique() || ray.at.plane != 0) return false;
  return !turns_to(rays.eye_of(ray), side, at_plane, true);
}

// How much the noise along a ray moves a point along the plane, compared with its movement out of the plane.
double lean_of(const Vec3* eye, Side side, double t, double w) {
  if (eye == nullptr || eye->z <= w) return 1;
  return std::max(1.0, std::abs(outwards(side) * (along_u(side) ? eye->x : eye->y) - t) / (eye->z - w));
}

std::size_t slots_of(const SideSpan& span, double step_along) {
  return static_cast<std::size_t>(std::clamp((span.s1 - span.s0) / (kSlotSteps * step_along), 1.0, 1e4));
}

std::size_t slot_of(double s, const SideSpan& span, std::size_t slots) {
  const double at = (s - span.s0) / (span.s1 - span.s0) * static_cast<double>(slots);
  return std::min(slots - 1, static_cast<std::size_t>(std::max(0.0, at)));
}

// What one ray shows about a side.
struct SideHit {
  bool face = false, corner = false, rim = false, solid = false, through = false, before = false;
  bool hidden = false, deep = false;
  double t = 0, at_plane = 0, s = 0;  // the place where it crosses the plane
  double point_t = 0, point_s = 0;    // the place where it ends
  double lean = 1;

  bool has_place() const { return face || corner || rim || solid || through || before; }
};

SideHit hit_of(const RaySamples& rays, const Ray& ray, const SideSearch& q, Side side, const SideSpan& span) {
  const bool u = along_u(side);
  const double sign = outwards(side), w = ray.at.w;
  const double corner_from = q.depth + 2 * q.epsilon, corner_to = q.hole ? corner_from : q.depth + kCornerDeep;
  const Place2 at = rays.crossing(ray, q.depth);
  SideHit hit;
  hit.at_plane = sign * (u ? at.u : at.v);
  hit.s = u ? at.v : at.u;
  hit.point_t = sign * static_cast<double>(u ? ray.at.u : ray.at.v);
  hit.point_s = u ? ray.at.v : ray.at.u;
  const bool at_face = w > q.face_from && w<q.face_to, at_corner = w> corner_from && w < corner_to;
  if ((at_face || at_corner) && span.has(hit.point_t) && hit.point_s >= span.s0 && hit.point_s <= span.s1 &&
      turns_to(rays.eye_of(ray), side, hit.point_t, at_face && !q.hole)) {
    hit.face = at_face;
    hit.corner = !at_face;
    if (at_face && !q.hole) hit.lean = lean_of(rays.eye_of(ray), side, hit.point_t, w);
  }
  if (hit.s < span.s0 || hit.s > span.s1) return hit;
  hit.t = q.hole ? hit.at_plane : innermost(rays, ray, q, side, span);
  if (!span.has(hit.t)) return hit;
  hit.rim = at_face && is_mixed_echo(rays, ray, q, side, hit.at_plane);
  const RayOutcome met = rays.met(ray, q.depth, q.epsilon);
  const bool foreign = ray.at.plane != 0 && !std::binary_search(q.planes.begin(), q.planes.end(), ray.at.plane);
  if (!q.hole && met == RayOutcome::solid && foreign) return hit;
  hit.solid = met == RayOutcome::solid;
  hit.through = met == RayOutcome::through;
  hit.before = met == RayOutcome::before;
  hit.hidden = hit.before && hit.t > span.t;
  hit.deep = !q.hole && met == RayOutcome::through && w < -q.face_from;
  return hit;
}

void keep(const SideHit& hit, double w, bool hole, SideSamples& out) {
  if (hit.face) out.face.push_back({hit.point_t, w, hit.point_s});
  if (hit.corner) out.corner.push_back({hit.point_t, w, hit.point_s});
  if (hit.rim) out.rim.push_back({hit.at_plane, w, hit.s});
  if (!hit.solid && !hit.through) return;
  const bool inside = hit.solid != hole;
  (inside ? out.inside : out.outside).push_back(hit.t);
  (inside ? out.inside_along : out.outside_along).push_back(hit.s);
}

SideSamples samples_of(const RaySamples& rays, const SideSearch& q, Side side, const SideSpan& span) {
  // Rays that cross the plane here cross the wall elsewhere. Their angle to the normal is less than about 45 degrees.
  Rays near = rays.near(q.box.grown(std::max(span.in, span.out) + 1.5 * std::abs(q.depth)));
  SideSamples out;
  out.level =
      thinning_level(near, kMostSamples, [&](const Ray& ray) { return hit_of(rays, ray, q, side, span).has_place(); });
  for (const Ray& ray : near) {
    const SideHit hit = hit_of(rays, ray, q, side, span);
    out.through += hit.through, out.hidden += hit.hidden, out.deep += hit.deep;
    if (hit.before && is_kept(ray, out.level)) out.before.push_back(hit.t);
    out.lean = std::max(out.lean, hit.lean);
    if (hit.has_place() && is_kept(ray, out.level)) keep(hit, ray.at.w, q.hole, out);
  }
  return out;
}

// The last solid point in each of `slots` intervals along a side, towards the side: sign 1 for the points of an
// element, -1 for those of the wall around a hole.
std::vector<double> ends_of(const std::vector<double>& solid, const std::vector<double>& along, double sign,
                            const SideSpan& span, std::size_t slots) {
  std::vector<double> ends(slots, -INFINITY);
  for (std::size_t i = 0; i < solid.size(); ++i) {
    double& end = ends[slot_of(along[i], span, slots)];
    end = std::max(end, sign * solid[i]);
  }
  return ends;
}

// Drops rays that come from another direction. A ray perpendicular to the plane would have met the element before it
// reached what is behind. So what they show there does not give the edge.
void drop_hidden(SideSamples& around, const SideSpan& span, std::size_t slots) {
  const std::vector<double> ends = ends_of(around.inside, around.inside_along, 1, span, slots);
  std::size_t kept = 0;
  for (std::size_t i = 0; i < around.outside.size(); ++i)
    if (around.outside[i] >= ends[slot_of(around.outside_along[i], span, slots)])
      around.outside[kept++] = around.outside[i];
  around.outside.resize(kept);
}

// Whether the samples of one side are so few that they may be stray points: then the edge was not seen.
bool are_stray(const std::vector<double>& samples, const std::vector<double>& others) {
  // Choice: a curtain or a railing leaves one ray in ten.
  constexpr double kFewOf = 0.07;  // share of the samples of the other side
  return samples.size() < 2 || static_cast<double>(samples.size()) < kFewOf * static_cast<double>(others.size());
}

void use_face(const FaceLine& face, double noise, LocatedEdge& edge) {
  edge.at = face.at;
  edge.error = kBoundOfNoise * noise + 2 * face.rms * face.error_factor;
  edge.rms = face.rms;
  edge.points = face.points;
  edge.status = DrawnStatus::seen;
  edge.by_face = true;
}

// One side of an element and how it was scanned.
struct SideView {
  const RaySamples& samples;
  const SideSearch& q;
  Side side;
  SideSpan span;
  Place2 steps;  // metres between rays across the side and along it
  double noise = samples.site().noise;
  bool oblique = samples.oblique();
  double beam = oblique ? kBeam : 0;
};

SideView view_of(const RaySamples& samples, const SideSearch& q, Side side) {
  const SideSpan span = span_of(q, side);
  const double t = outwards(side) * span.t, s = (span.s0 + span.s1) / 2;
  const Place2 steps = samples.step_at(along_u(side) ? Place2{t, s} : Place2{s, t});
  return {samples, q, side, span, along_u(side) ? steps : Place2{steps.v, steps.u}};
}

// An element ends where a face stands out of it. The edge is where their planes meet, whichever of the two the points
// near the corner were assigned to.
void use_corner(const SideSamples& around, double about, double beside, const SideView& view, LocatedEdge& edge) {
  const double length = view.span.s1 - view.span.s0;
  const FaceSearch f{about - beside, about + beside, kFaceWidths * view.noise, kCornerDeep, length};
  const FaceLine face = find_face(densest_cluster(around.corner, f), f, view.q.depth);
  if (face.points > 0) use_face(face, view.noise, edge);
}

// Finds the end of an element with nothing behind it, or of the wall at a hole without an echo, from the last points of
// the scan lines. If the lines cross the side one after the other, they end anywhere within one step of it. If all end
// at one place, the side is up to one step farther on. An echo from the rim of a beam lies beyond by the radius of the
// beam.
void set_end(const SideSamples& around, bool hole, const SideView& view, LocatedEdge& edge) {
  const double step = view.steps.u;
  const std::vector<double>& solid = hole ? around.outside : around.inside;
  const double sign = hole ? -1 : 1;
  std::vector<double> ends = ends_of(solid, hole ? around.outside_along : around.inside_along, sign, view.span,
                                     slots_of(view.span, view.steps.v));
  const double last = *std::max_element(ends.begin(), ends.end());
  std::erase_if(ends, [&](double end) { return !(end > last - kStepsOfShadow * step); });
  const double high = lower_quantile(ends, 1 - kTailOfEnds);
  const double open =
      std::max(0.0, step - (high - lower_quantile(ends, kTailOfEnds)));  // part of a step in which no line ended
  edge.at = sign * (high + open / 2 - view.beam);
  edge.error = open / 2 + view.beam;
  edge.points = solid.size() << around.level;
}

// Finds where the wall ends at a hole without an echo; from the points of its side face where there are enough. What
// stands before the wall may hide its end, as a sill does: then it is anywhere behind that.
void set_end_of_wall(const SideSamples& around, const SideView& view, LocatedEdge& edge) {
  set_end(around, true, view, edge);
  edge.error += kBoundOfNoise * view.noise;
  edge.inner = edge.at;
  const double beside = edge.error + kBesideGap;
  const FaceSearch f{edge.at - beside, edge.at + beside, kFaceWidths * view.noise * around.lean,
                     view.q.face_to - view.q.face_from, view.span.s1 - view.span.s0};
  const FaceLine face = find_face(densest_cluster(around.face, f), f, view.q.depth);
  if (face.points > 0) return use_face(face, view.noise, edge);
  std::vector<double> hiding;
  for (const double t : around.before)
    if (t < edge.at) hiding.push_back(t);
  if (static_cast<double>(hiding.size()) < kHiding * static_cast<double>(around.outside.size())) return;
  edge.inner = lower_quantile(hiding, kTailOfEnds);
  edge.at = (edge.at + edge.inner) / 2;
  edge.error += edge.at - edge.inner;
  edge.status = DrawnStatus::occluded;
}

// Divides the samples of a side. An edge with so few samples on one side that they may be stray was not seen.
EdgeSplit split_of(const SideSamples& around, const SideView& view) {
  EdgeSplit split = split_edge(around.inside, around.outside);
  if (view.q.hole && view.oblique &&
      (are_stray(around.outside, around.inside) || (view.q.silent && are_stray(around.inside, around.outside))))
    split.found = false;
  return split;
}

// The end of an element with nothing behind it.
void set_end_of_element(const SideSamples& around, const SideView& view, LocatedEdge& edge) {
  set_end(around, false, view, edge);
  edge.error += kBoundOfNoise * view.noise;
  edge.status = around.hidden > 0 ? DrawnStatus::occluded : DrawnStatus::seen;
  use_corner(around, edge.at, kCornerReach + view.steps.u, view, edge);
  edge.inner = edge.at;
}

// Finds the side face at a split from its points, or from the echoes of beams that the edge split. Before a hole, the
// echo of a split beam may be anywhere. Before the wall, it is as far on one side of the edge as on the other.
FaceLine face_at(SideSamples& around, const EdgeSplit& split, double beside, const SideView& view) {
  const SideSearch& q = view.q;
  const FaceSearch f{split.at - beside, split.at + beside, kFaceWidths * view.noise * around.lean,
                     q.face_to - q.face_from, view.span.s1 - view.span.s0};
  const FaceLine face = find_face(densest_cluster(around.face, f), f, q.depth);
  if (face.points > 0 || q.hole || !view.oblique) return face;
  if (2 * around.deep < around.through)
    for (const FacePoint& p : around.rim)
      if (std::abs(p.t - split.at) <= split.half_gap + view.noise + view.beam) around.face.push_back(p);
  return find_touches(densest_cluster(std::move(around.face), f), f, view.noise);
}

// Places the edge between the samples of its two sides, or where points of a face show it.
void set_split(SideSamples& around, const EdgeSplit& split, const SideView& view, LocatedEdge& edge) {
  const SideSearch& q = view.q;
  const double step = view.steps.u, noise = kBoundOfNoise * view.noise;
  edge.at = split.at;
  const EdgeRange within{view.span.t - view.span.in, view.span.t + view.span.out};
  edge.error = noise + view.beam +
               std::max(split.half_gap + blur_at(around.inside, around.outside, split.at, split.half_gap + 2 * step),
                        farthest_from(split, edge_range(around.inside, around.outside, within.from, within.to)));
  if (!q.hole && along_u(view.side) && view.samples.guessed()) edge.error += kGuessed * std::abs(q.depth);
  edge.points = (around.inside.size() + around.outside.size() - split.wrong) << around.level;
  if (!view.oblique) {  // what is behind is hidden beside the edge: the edge is half a step from the solid side
    edge.at = q.hole ? split.at + split.half_gap - step / 2 : split.at - split.half_gap + step / 2;
    edge.error = step / 2 + noise;
    if (q.hole) {
      const double half = half_of_relief(around.before, around.outside.size(), split, edge.at);
      edge.at -= half, edge.error += half;
    }
  } else if (2 * split.half_gap > kStepsOfShadow * step) {
    edge.status = DrawnStatus::occluded;
  }
  edge.inner = split.at - split.half_gap;
  const double beside = split.half_gap + kBesideGap;
  const FaceLine face = face_at(around, split, beside, view);
  if (face.points > 0)
    use_face(face, view.noise, edge);
  else
    use_corner(around, split.at, beside, view, edge);
}

}  // namespace

LocatedEdge locate_edge(const RaySamples& samples, const SideSearch& q, Side side) {
  // Choice: where no point of the far side was found, the search grows once towards that side by this factor; an edge
  // hidden over a wider strip stays unknown. Bars in an opening are farther in.
  constexpr double kWider = 2.4;
  const SideView view = view_of(samples, q, side);
  SideSamples around = samples_of(samples, q, side, view.span);
  if ((q.hole ? around.outside : around.inside).empty()) {
    SideSpan wider = view.span;
    (q.hole ? wider.out : wider.in) *= kWider;
    around = samples_of(samples, q, side, wider);
  }
  if (!q.hole && !view.oblique) drop_hidden(around, view.span, slots_of(view.span, view.steps.v));
  LocatedEdge edge;
  const EdgeSplit split = split_of(around, view);
  const bool wide = 2 * split.half_gap > kStepsOfShadow * view.steps.u;
  if (!split.found && !q.hole && !around.inside.empty()) {
    set_end_of_element(around, view, edge);
  } else if (q.hole && q.silent && !around.outside.empty() && (!split.found || (view.oblique && wide))) {
    set_end_of_wall(around, view, edge);
  } else if (split.found) {
    set_split(around, split, view, edge);
  } else {
    edge.at = edge.inner = view.span.t;
    edge.error = kNothingKnown;
    edge.status = DrawnStatus::occluded;
  }
  edge.at *= outwards(side);
  edge.inner *= outwards(side);
  return edge;
}

}  // namespace ilot
