// SPDX-License-Identifier: Apache-2.0
#include "engine/facades/located_edge.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/outlines/edge_split.h"

namespace ilot {
namespace {

constexpr double kCornerShare = 0.12, kCornerMost = 0.15;  // of a side, metres: left out at its ends
constexpr double kStepsOfShadow = 3;                       // a gap wider than so many steps is a shadow
constexpr double kBeam = 0.002;        // metres: echoes from the rim of a beam hang behind the edge that they came from
constexpr double kGuessed = 0.5;       // of the depth: how far a ray may be off whose station is guessed among several
constexpr double kNothingKnown = 3;    // metres: how far a hidden side may be
constexpr double kBesideGap = 0.02;    // metres beside the gap that points of the face may lie
constexpr double kCornerDeep = 0.1;    // metres before a thing that points of what it ends at may lie
constexpr double kCornerReach = 0.02;  // metres beside its last points
constexpr double kSlotSteps = 2;       // steps along a side that one scan line ends in, at least
constexpr double kTailOfEnds = 0.05;   // of scan lines that end at one place or the other by chance
constexpr std::size_t kLeastFacePoints = 12;
constexpr double kFaceWidths = 4;      // noise: width of the stretch that holds a face's points
constexpr double kLeastSpread = 0.35;  // share of the face's depth, and of the side's length, that points cover
constexpr double kSteepest = 0.1;      // of a side face against the wall's normal

bool along_u(Side side) {
  return side == Side::left || side == Side::right;
}
double outwards(Side side) {
  return side == Side::right || side == Side::top ? 1 : -1;
}

struct FacePoint {
  double t, w, s;  // across the side, out of the wall, along the side
};

// What is around one side, t growing outwards.
struct SideSamples {
  std::vector<double> inside, outside;
  std::vector<double> along;  // the side, of those inside
  std::vector<FacePoint> face, corner;
  std::size_t hidden = 0;  // rays that end before the plane, beyond the side
};

struct SideSpan {
  double t, s0, s1;
};

SideSpan span_of(const Box2& box, Side side) {
  const double t = side == Side::left ? box.u0 : side == Side::right ? box.u1 : side == Side::top ? box.v1 : box.v0;
  double s0 = along_u(side) ? box.v0 : box.u0, s1 = along_u(side) ? box.v1 : box.u1;
  const double corner = std::min(kCornerMost, kCornerShare * (s1 - s0));
  return {t * outwards(side), s0 + corner, s1 - corner};
}

// Whether a side face at t can be seen from there: one that looks outwards from beyond it, else from before it.
bool turns_to(const Vec3* eye, Side side, double t, bool looks_outwards) {
  if (eye == nullptr) return true;
  const double beyond = outwards(side) * (along_u(side) ? eye->x : eye->y) - t;
  return looks_outwards ? beyond > 0 : beyond < 0;
}

SideSamples samples_of(const RaySamples& rays, const SideSearch& q, Side side, const SideSpan& span, double reach) {
  const bool u = along_u(side);
  const double sign = outwards(side);
  const double corner_from = q.depth + 2 * q.epsilon, corner_to = q.hole ? corner_from : q.depth + kCornerDeep;
  SideSamples out;
  // Rays that cross the plane here cross the wall elsewhere: they lean by less than 45 degrees or so.
  for (const std::uint32_t i : rays.near(q.box.grown(reach + 1.5 * std::abs(q.depth)))) {
    const FacadePoint& p = rays.site().points[i];
    const Place2 at = rays.crossing(i, q.depth);
    const double t = sign * (u ? at.u : at.v), s = u ? at.v : at.u;
    const double w = p.w;
    const bool at_face = w > q.face_from && w<q.face_to, at_corner = w> corner_from && w < corner_to;
    if (at_face || at_corner) {
      const double pt = sign * static_cast<double>(u ? p.u : p.v), ps = u ? p.v : p.u;
      if (std::abs(pt - span.t) <= reach && ps >= span.s0 && ps <= span.s1 &&
          turns_to(rays.eye_of(i), side, pt, at_face && !q.hole))
        (at_face ? out.face : out.corner).push_back({pt, w, ps});
    }
    if (std::abs(t - span.t) > reach || s < span.s0 || s > span.s1) continue;
    const Met met = rays.met(i, q.depth, q.epsilon);
    const bool foreign = p.plane != 0 && !std::binary_search(q.planes.begin(), q.planes.end(), p.plane);
    if (!q.hole && met == Met::solid && foreign) continue;
    if (met == Met::solid) (q.hole ? out.outside : out.inside).push_back(t);
    if (met == Met::solid && !q.hole) out.along.push_back(s);
    out.hidden += met == Met::before && t > span.t;
    if (met == Met::through) (q.hole ? out.inside : out.outside).push_back(t);
  }
  return out;
}

double quantile(std::vector<double>& values, double share) {
  const auto at = values.begin() + static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
  std::nth_element(values.begin(), at, values.end());
  return *at;
}

double spread(const std::vector<FacePoint>& points, std::size_t first, std::size_t last, double FacePoint::*field) {
  std::vector<double> values;
  for (std::size_t i = first; i < last; ++i) values.push_back(points[i].*field);
  const double high = quantile(values, 0.95);
  return high - quantile(values, 0.05);
}

struct FaceLine {
  double at = 0, rms = 0;
  std::size_t points = 0;
};

// t = at + slope (w - depth) by least squares.
FaceLine fit_face(const std::vector<FacePoint>& points, std::size_t first, std::size_t last, double depth) {
  double n = 0, sw = 0, st = 0, sww = 0, swt = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double w = points[i].w - depth;
    n += 1, sw += w, st += points[i].t, sww += w * w, swt += w * points[i].t;
  }
  const double slope = std::clamp((n * swt - sw * st) / (n * sww - sw * sw), -kSteepest, kSteepest);
  const double at = (st - slope * sw) / n;
  double squares = 0;
  for (std::size_t i = first; i < last; ++i) {
    const double off = points[i].t - at - slope * (points[i].w - depth);
    squares += off * off;
  }
  return {at, std::sqrt(squares / n), last - first};
}

// Where points of a side face may lie, and how deep they should go and how far along.
struct FaceSearch {
  double low, high, width;  // of t; of the crowd
  double deep, along;
};

// The side face: the narrowest crowd of points within [low, high] that goes deep and along.
FaceLine find_face(std::vector<FacePoint> points, const FaceSearch& f, double depth) {
  std::erase_if(points, [&](const FacePoint& p) { return p.t < f.low || p.t > f.high; });
  std::sort(points.begin(), points.end(), [](const FacePoint& a, const FacePoint& b) { return a.t < b.t; });
  std::size_t best = 0, best_end = 0, end = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    while (end < points.size() && points[end].t - points[i].t <= f.width) ++end;
    if (end - i > best_end - best) best = i, best_end = end;
  }
  if (best_end - best < kLeastFacePoints) return {};
  if (spread(points, best, best_end, &FacePoint::w) < kLeastSpread * f.deep) return {};
  if (spread(points, best, best_end, &FacePoint::s) < kLeastSpread * f.along) return {};
  return fit_face(points, best, best_end, depth);
}

void use_face(const FaceLine& face, double noise, LocatedEdge& edge) {
  edge.at = face.at;
  edge.error = noise / 2 + 2 * face.rms / std::sqrt(static_cast<double>(face.points));
  edge.rms = face.rms;
  edge.points = face.points;
  edge.status = DrawnStatus::seen;
  edge.by_face = true;
}

// A thing ends where a face stands out of it: their planes meet there, whatever points near the corner were taken for.
void use_corner(const std::vector<FacePoint>& corner, double about, double beside, const SideSearch& q,
                const SideSpan& span, double noise, LocatedEdge& edge) {
  const FaceLine face =
      find_face(corner, {about - beside, about + beside, kFaceWidths * noise, kCornerDeep, span.s1 - span.s0}, q.depth);
  if (face.points > 0) use_face(face, noise, edge);
}

// Where a thing ends and nothing is behind: the last points of its scan lines. Lines that cross the side by turns end
// everywhere within a step of it; where all end at one place it is up to a step farther out. An echo from the rim of a
// beam lies outside by the beam's radius.
void set_end(const SideSamples& around, const SideSpan& span, double step, double step_along, double beam,
             LocatedEdge& edge) {
  const auto slots = static_cast<std::size_t>(std::clamp((span.s1 - span.s0) / (kSlotSteps * step_along), 1.0, 1e4));
  std::vector<double> ends(slots, -INFINITY);
  for (std::size_t i = 0; i < around.inside.size(); ++i) {
    const double at = (around.along[i] - span.s0) / (span.s1 - span.s0) * static_cast<double>(slots);
    double& end = ends[std::min(slots - 1, static_cast<std::size_t>(std::max(0.0, at)))];
    end = std::max(end, around.inside[i]);
  }
  const double last = *std::max_element(ends.begin(), ends.end());
  std::erase_if(ends, [&](double end) { return !(end > last - kStepsOfShadow * step); });
  const double high = quantile(ends, 1 - kTailOfEnds);
  const double open = std::max(0.0, step - (high - quantile(ends, kTailOfEnds)));  // of a step that no line ended in
  edge.at = high + open / 2 - beam;
  edge.error = open / 2 + beam;
  edge.points = around.inside.size();
}

}  // namespace

LocatedEdge locate_edge(const RaySamples& samples, const SideSearch& q, Side side) {
  constexpr double kWider = 2.4;
  const SideSpan span = span_of(q.box, side);
  const double sign = outwards(side);
  SideSamples around = samples_of(samples, q, side, span, q.reach);
  const std::vector<double>& far_side = q.hole ? around.outside : around.inside;
  double reach = q.reach;
  if (far_side.empty()) around = samples_of(samples, q, side, span, reach *= kWider);
  const Place2 middle =
      along_u(side) ? Place2{sign * span.t, (span.s0 + span.s1) / 2} : Place2{(span.s0 + span.s1) / 2, sign * span.t};
  const Place2 steps = samples.step_at(middle);
  const double step = along_u(side) ? steps.u : steps.v;
  LocatedEdge edge;
  const EdgeSplit split = split_edge(around.inside, around.outside);
  const double noise = samples.site().noise;
  const double beam = samples.oblique() ? kBeam : 0;
  if (!split.found && !q.hole && !around.inside.empty()) {
    set_end(around, span, step, along_u(side) ? steps.v : steps.u, beam, edge);
    edge.error += noise / 2;
    edge.status = around.hidden > 0 ? DrawnStatus::occluded : DrawnStatus::seen;
    use_corner(around.corner, edge.at, kCornerReach + step, q, span, noise, edge);
    edge.at *= sign;
    edge.inner = edge.at;
    return edge;
  }
  if (!split.found) {
    edge.at = edge.inner = sign * span.t;
    edge.error = kNothingKnown;
    edge.status = DrawnStatus::occluded;
    return edge;
  }
  const bool shadow = 2 * split.half_gap > kStepsOfShadow * step;
  double t = split.at;
  edge.error = split.half_gap + noise / 2 + beam;
  if (!q.hole && along_u(side) && samples.guessed()) edge.error += kGuessed * std::abs(q.depth);
  edge.points = around.inside.size() + around.outside.size() - split.wrong;
  if (!samples.oblique()) {  // what is behind is hidden beside the edge: half a step from the solid side
    t = q.hole ? split.at + split.half_gap - step / 2 : split.at - split.half_gap + step / 2;
    edge.error = step / 2 + noise / 2;
  } else if (shadow) {
    edge.status = DrawnStatus::occluded;
  }
  edge.inner = sign * (split.at - split.half_gap);
  const double beside = split.half_gap + kBesideGap;
  const FaceLine face = find_face(
      std::move(around.face),
      {split.at - beside, split.at + beside, kFaceWidths * noise, q.face_to - q.face_from, span.s1 - span.s0}, q.depth);
  edge.at = t;
  if (face.points > 0)
    use_face(face, noise, edge);
  else
    use_corner(around.corner, split.at, beside, q, span, noise, edge);
  edge.at *= sign;
  return edge;
}

}  // namespace ilot
