// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/side_faces.h"

#include <algorithm>
#include <cmath>
#include <vector>

namespace ilot {
namespace {

// Choice: leaves an eighth of the depth to the noise of the wall and of the front.
constexpr double kFrom = 0.12, kTo = 0.88;  // shares of the depth between which the points belong to the face alone
// Choice: a tenth of a side, as much as corners are rounded.
constexpr double kCorner = 0.1;  // share of a side that is left out at its ends
// Choice: two steps of 1 cm.
constexpr double kBeside = 0.02;  // metres beside a face in which its points are searched
// Choice: three errors of an edge of 1 cm, as for openings.
constexpr double kLeans = 0.03;  // metres; a face whose ends differ by less does not lean
// Choice: a third of the face must be seen, as for openings.
constexpr double kLeastSpread = 0.35;  // share of the depth
// Choice: points at random exceed three times their mean in few of the bins.
constexpr double kDense = 3;  // times the number of points that an even spread would give
// Derived: 0.05 is 3 degrees, below what a face of 10 cm shows.
constexpr double kUpright = 0.05;                             // a smaller slope counts as zero
constexpr std::size_t kLeastPoints = 12, kLeastLeaning = 48;  // a few points of another surface lie on any line
// Derived: the usual step of files, 1 mm.
constexpr double kExact = 0.001;                 // metres; even clouds without noise have rounded coordinates
constexpr std::uint64_t kMostSamples = 1 << 16;  // points of a face; more do not improve the result
// Choice: the error of an edge.
constexpr double kEdge = 0.01;  // metres; a narrower end becomes an edge

struct FacePoint {
  double t, w;  // across the side, positive outwards; out of the wall
};

struct FaceLine {
  double at = 0, slope = 0;  // t = at + slope w
  double rms = 0;
  std::size_t points = 0;
};

double& side_of(Box2& box, Side side) {
  return side == Side::left ? box.u0 : side == Side::right ? box.u1 : side == Side::bottom ? box.v0 : box.v1;
}

std::vector<FacePoint> points_of(const RaySamples& samples, const Box2& around, Side side, double depth, double low,
                                 double high, double s0, double s1) {
  const double sign = side == Side::right || side == Side::top ? 1 : -1;
  const auto point_of = [&](const Ray& ray) {
    return FacePoint{sign * static_cast<double>(along_u(side) ? ray.at.u : ray.at.v), static_cast<double>(ray.at.w)};
  };
  const auto is_there = [&](const Ray& ray) {
    const FacePoint p = point_of(ray);
    const double part = p.w / depth, s = along_u(side) ? ray.at.v : ray.at.u;
    return part > kFrom && part < kTo && p.t >= low && p.t <= high && s >= s0 && s <= s1;
  };
  Rays near = samples.near(around);
  const int level = thinning_level(near, kMostSamples, is_there);
  std::vector<FacePoint> points;
  for (const Ray& ray : near)
    if (is_there(ray) && is_kept(ray, level)) points.push_back(point_of(ray));
  return points;
}

FaceLine fit(const std::vector<FacePoint>& points) {
  double n = 0, sw = 0, st = 0, sww = 0, swt = 0;
  for (const FacePoint& p : points) n += 1, sw += p.w, st += p.t, sww += p.w * p.w, swt += p.w * p.t;
  FaceLine line;
  const double spread = n * sww - sw * sw;
  line.slope = spread > 0 ? (n * swt - sw * st) / spread : 0;
  line.at = (st - line.slope * sw) / n;
  for (const FacePoint& p : points) {
    const double off = p.t - line.at - line.slope * p.w;
    line.rms += off * off;
  }
  line.rms = std::sqrt(line.rms / n);
  line.points = points.size();
  return line;
}

double spread_of(const std::vector<FacePoint>& points) {
  double low = INFINITY, high = -INFINITY;
  for (const FacePoint& p : points) low = std::min(low, p.w), high = std::max(high, p.w);
  return high - low;
}

// Moves the line to where most points lie beside it. The result has no points if there is no such cluster: other faces
// of the element end near by, and a face across it has points everywhere.
FaceLine moved_to_densest(const std::vector<FacePoint>& points, FaceLine line, double search, double width) {
  std::vector<double> offs;
  for (const FacePoint& p : points)
    if (const double off = p.t - line.at - line.slope * p.w; std::abs(off) <= search) offs.push_back(off);
  std::sort(offs.begin(), offs.end());
  std::size_t best = 0, most = 0, end = 0;
  for (std::size_t i = 0; i < offs.size(); ++i) {
    while (end < offs.size() && offs[end] - offs[i] <= width) ++end;
    if (end - i > most) best = i, most = end - i;
  }
  const double even = static_cast<double>(offs.size()) * std::min(1.0, width / (2 * search));
  if (static_cast<double>(most) < std::max(static_cast<double>(kLeastPoints), kDense * even)) return {};
  line.at += offs[best + most / 2];
  line.points = most;
  return line;
}

// The face through the points beside the line. It is searched a second time beside the first result.
FaceLine find_face(const std::vector<FacePoint>& points, FaceLine line, double depth, double search, double noise) {
  const double width = std::max(kBeside, 4 * noise);
  line = moved_to_densest(points, line, search, width);
  if (line.points == 0) return {};
  double beside = width;
  for (int round = 0; round < 4; ++round) {
    std::vector<FacePoint> near;
    for (const FacePoint& p : points)
      if (std::abs(p.t - line.at - line.slope * p.w) <= beside) near.push_back(p);
    if (near.size() < kLeastPoints || spread_of(near) < kLeastSpread * std::abs(depth)) return {};
    line = fit(near);
    beside = std::max({3 * line.rms, 2 * noise, kExact});
  }
  return line;
}

// A face from t0 at the wall, or at `seen_at` out of it, to t1 at the depth. Of the two, the one with more points is
// taken.
FaceLine leaning_face(const std::vector<FacePoint>& points, double t0, double t1, double depth, double seen_at,
                      double search, double noise) {
  FaceLine best;
  for (const double from : {0.0, seen_at}) {
    const double slope = (t1 - t0) / (depth - from);
    const FaceLine face = find_face(points, {t0 - slope * from, slope, 0, 0}, depth, search, noise);
    if (face.points > best.points) best = face;
  }
  return best;
}

}  // namespace

SideFaces side_faces(const RaySamples& samples, const Box2& outline, const Box2& end, double depth, double seen_at) {
  SideFaces faces{outline, outline, {}, {}, {}};
  const FacadeSite& site = samples.site();
  const double noise = site.noise, search = kBeside + 3 * site.step;
  Box2 at_wall = outline, at_end = end;
  for (std::size_t k = 0; k < kSides.size(); ++k) {
    const Side side = kSides[k];
    const double sign = side == Side::right || side == Side::top ? 1 : -1;
    const double t0 = sign * side_of(at_wall, side), t1 = sign * side_of(at_end, side);
    const double s0 = along_u(side) ? outline.v0 : outline.u0, s1 = along_u(side) ? outline.v1 : outline.u1;
    const double corner = kCorner * (s1 - s0), reach = std::abs(depth) + std::abs(t1 - t0) + search;
    const std::vector<FacePoint> points = points_of(
        samples, outline.grown(samples.oblique() ? 1.5 * reach : reach), side, depth, std::min(t0, t1) - search,
        std::max(t0, t1) + search + std::abs(t1 - t0) * std::abs(seen_at / depth), s0 + corner, s1 - corner);
    FaceLine face = find_face(points, {t0, 0, 0, 0}, depth, search, noise);
    if (std::abs(t1 - t0) > std::max(kLeans, 2 * site.step)) {
      const FaceLine leaning = leaning_face(points, t0, t1, depth, seen_at, search, noise);
      if (leaning.points > std::max(2 * face.points, kLeastLeaning)) face = leaning;
    }
    if (face.points == 0) continue;
    const bool leans = std::abs(face.slope) > kUpright;
    const double middle = face.at + face.slope * depth / 2;
    side_of(faces.outline, side) = sign * (leans ? face.at : middle);
    side_of(faces.end, side) = sign * (leans ? face.at + face.slope * depth : middle);
    faces.error[k] = noise / 2 + 3 * face.rms / std::sqrt(static_cast<double>(face.points));
    faces.rms[k] = face.rms;
    faces.points[k] = face.points;
  }
  return faces;
}

FacadeBody body_between(const FacadeSite& site, const Box2& outline, double at, const Box2& end, double end_at) {
  FacadeBody body;
  body.closed = true;
  const bool out = end_at > at;
  std::array<std::array<std::uint32_t, 4>, 2> ids{};
  const double units = 1 / site.metres_per_unit;
  for (std::size_t k = 0; k < 2; ++k) {
    Box2 box = k == 0 ? outline : end;
    const bool thin_u = box.width() < kEdge, thin_v = box.height() < kEdge;
    if (thin_u) box.u0 = box.u1 = (box.u0 + box.u1) / 2;
    if (thin_v) box.v0 = box.v1 = (box.v0 + box.v1) / 2;
    const std::array<Place2, 4> corners{{{box.u0, box.v0}, {box.u1, box.v0}, {box.u1, box.v1}, {box.u0, box.v1}}};
    for (std::size_t c = 0; c < 4; ++c) {
      const std::size_t across = thin_u && c % 2 == 1 ? c - 1 : c, same = thin_v && c > 1 ? 3 - c : across;
      if (same < c) {
        ids[k][c] = ids[k][same];
        continue;
      }
      ids[k][c] = static_cast<std::uint32_t>(body.vertices.size());
      body.vertices.push_back(site.axes.origin + (corners[c].u * units) * site.axes.right +
                              (corners[c].v * units) * site.axes.up + ((k == 0 ? at : end_at) * units) * site.axes.out);
    }
  }
  const auto add = [&](std::vector<std::uint32_t> face) {
    face.erase(std::unique(face.begin(), face.end()), face.end());
    while (face.size() > 1 && face.front() == face.back()) face.pop_back();
    if (face.size() < 3) return;
    if (!out) std::reverse(face.begin(), face.end());
    body.faces.push_back(std::move(face));
  };
  add({ids[1][0], ids[1][1], ids[1][2], ids[1][3]});
  add({ids[0][3], ids[0][2], ids[0][1], ids[0][0]});
  for (std::size_t c = 0; c < 4; ++c) add({ids[0][c], ids[0][(c + 1) % 4], ids[1][(c + 1) % 4], ids[1][c]});
  return body;
}

}  // namespace ilot
