// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/sides/face_cluster.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr std::size_t kLeastFacePoints = 12;
constexpr std::size_t kLeastTouches = 4;  // points of a face with too few points for a line
// Choice: the points of a reveal lie on it but for mixed pixels; rough masonry has fewer and gets an edge from the gap.
constexpr double kMostTouches = 0.7;  // share of all points in the gap that must then lie on it
// Choice: a third of the face must be seen; a strip of it could be a frame.
constexpr double kLeastSpread = 0.35;  // share of the depth of the face, and of the side, that points cover
// Derived: 0.1 is 6 degrees; splayed reveals beyond it are leaning sides.
constexpr double kSteepest = 0.1;  // slope of a side face against the normal of the wall, at most

double spread(const std::vector<FacePoint>& points, std::size_t first, std::size_t last, double FacePoint::*field) {
  std::vector<double> values;
  for (std::size_t i = first; i < last; ++i) values.push_back(points[i].*field);
  const double high = lower_quantile(values, 0.95);
  return high - lower_quantile(values, 0.05);
}

// Fits t = at + slope (w - depth) by least squares.
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
  return {at, std::sqrt(squares / n), last - first, std::sqrt(1 / n + (sw / n) * (sw / n) / (sww - sw * sw / n))};
}

bool goes_along(const FaceCluster& c, const FaceSearch& f) {
  return spread(c.points, c.first, c.last, &FacePoint::s) >= kLeastSpread * f.along;
}

}  // namespace

FaceCluster densest_cluster(std::vector<FacePoint> points, const FaceSearch& f) {
  std::erase_if(points, [&](const FacePoint& p) { return p.t < f.low || p.t > f.high; });
  std::sort(points.begin(), points.end(), [](const FacePoint& a, const FacePoint& b) { return a.t < b.t; });
  FaceCluster cluster;
  std::size_t end = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    while (end < points.size() && points[end].t - points[i].t <= f.width) ++end;
    if (end - i > cluster.last - cluster.first) cluster.first = i, cluster.last = end;
  }
  cluster.points = std::move(points);
  return cluster;
}

FaceLine find_face(const FaceCluster& c, const FaceSearch& f, double depth) {
  if (c.last - c.first < kLeastFacePoints || !goes_along(c, f)) return {};
  if (spread(c.points, c.first, c.last, &FacePoint::w) < kLeastSpread * f.deep) return {};
  return fit_face(c.points, c.first, c.last, depth);
}

FaceLine find_touches(const FaceCluster& c, const FaceSearch& f, double noise) {
  const std::size_t count = c.last - c.first;
  if (count < kLeastTouches || !goes_along(c, f)) return {};
  if (static_cast<double>(count) < kMostTouches * static_cast<double>(c.points.size())) return {};
  double sum = 0, squares = 0;
  for (std::size_t i = c.first; i < c.last; ++i) sum += c.points[i].t;
  const double mean = sum / static_cast<double>(count);
  for (std::size_t i = c.first; i < c.last; ++i) squares += (c.points[i].t - mean) * (c.points[i].t - mean);
  const auto n = static_cast<double>(count);
  return {mean, std::max(noise, std::sqrt(squares / n)), count, 1 / std::sqrt(n)};
}

}  // namespace ilot
