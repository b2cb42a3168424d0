// SPDX-License-Identifier: Apache-2.0
#include "study/edge_lengths.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

std::int64_t squared_length(const Triangulation& t, std::span<const Point2> points, std::uint32_t e) {
  return squared_distance(points[t.corner[e]], points[t.corner[next_edge(e)]]);
}

}  // namespace

double slope_change(const Triangulation& t, std::span<const Point2> points) {
  std::vector<std::int64_t> squared;
  for (std::uint32_t e = 0; e < t.corner.size(); ++e)
    if (t.twin[e] == kNoEdge || e < t.twin[e]) squared.push_back(squared_length(t, points, e));
  if (squared.empty()) return 0.5;
  std::sort(squared.begin(), squared.end());
  const auto length = [&](std::size_t i) { return std::sqrt(static_cast<double>(squared[i])); };
  const std::size_t last = squared.size() - 1;
  const double slope = (length(last) - length(0)) / static_cast<double>(std::max<std::size_t>(1, last));
  std::size_t best = last;
  double farthest = 0;
  for (std::size_t i = 0; i <= last; ++i) {
    const double below = length(0) + slope * static_cast<double>(i) - length(i);
    if (below > farthest) {
      farthest = below;
      best = i;
    }
  }
  return best == last ? length(last) + 0.5 : length(best);
}

std::vector<std::uint8_t> ends_of_long_edges(const Triangulation& t, std::span<const Point2> points, double threshold) {
  std::vector<std::uint8_t> end(points.size());
  for (std::uint32_t e = 0; e < t.corner.size(); ++e)
    if (static_cast<double>(squared_length(t, points, e)) > threshold * threshold)
      end[t.corner[e]] = end[t.corner[next_edge(e)]] = 1;
  return end;
}

}  // namespace ilot
