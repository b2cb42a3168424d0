// SPDX-License-Identifier: Apache-2.0
#include "kernels/neighbours/reach.h"

#include <algorithm>
#include <cstdlib>

namespace ilot {
namespace {

constexpr std::int64_t squared(std::int64_t v) {
  return v * v;
}

// Squared distances between boxes: of their nearest and of their farthest points.
std::int64_t least_distance2(const IntBox& a, const IntBox& b) {
  const auto gap = [](std::int64_t a0, std::int64_t a1, std::int64_t b0, std::int64_t b1) {
    return std::max({std::int64_t{0}, b0 - a1, a0 - b1});
  };
  return squared(gap(a.min.x, a.max.x, b.min.x, b.max.x)) + squared(gap(a.min.y, a.max.y, b.min.y, b.max.y)) +
         squared(gap(a.min.z, a.max.z, b.min.z, b.max.z));
}

std::int64_t most_distance2(const IntBox& a, const IntBox& b) {
  const auto span = [](std::int64_t a0, std::int64_t a1, std::int64_t b0, std::int64_t b1) {
    return std::max(a1, b1) - std::min(a0, b0);
  };
  return squared(span(a.min.x, a.max.x, b.min.x, b.max.x)) + squared(span(a.min.y, a.max.y, b.min.y, b.max.y)) +
         squared(span(a.min.z, a.max.z, b.min.z, b.max.z));
}

bool any_pair_within(std::span<const IntPoint> a, std::span<const IntPoint> b, std::int64_t radius2) {
  for (const IntPoint& u : a)
    for (const IntPoint& v : b)
      if (within_reach(u, v, radius2)) return true;
  return false;
}

}  // namespace

// The larger set is halved while its box and the other's do not decide the answer. Sets in Morton order, as those of
// the store are, have compact halves. Without that order, two dense bins just out of reach would cost the product of
// their points.
bool within_reach(std::span<const IntPoint> a, const IntBox& box_a, std::span<const IntPoint> b, const IntBox& box_b,
                  std::int64_t radius2) {
  constexpr std::size_t kFewPairs = 256;
  if (least_distance2(box_a, box_b) > radius2) return false;
  if (most_distance2(box_a, box_b) <= radius2) return true;
  if (a.size() * b.size() <= kFewPairs) return any_pair_within(a, b, radius2);
  if (a.size() < b.size()) return within_reach(b, box_b, a, box_a, radius2);
  const auto low = a.first(a.size() / 2), high = a.subspan(a.size() / 2);
  return within_reach(low, box_of(low), b, box_b, radius2) || within_reach(high, box_of(high), b, box_b, radius2);
}

bool within_reach(std::span<const IntPoint> a, std::span<const IntPoint> b, std::int64_t radius2) {
  constexpr std::size_t kFewPairs = 1024;  // fewer cost less than their boxes
  if (a.size() * b.size() <= kFewPairs) return any_pair_within(a, b, radius2);
  return within_reach(a, box_of(a), b, box_of(b), radius2);
}

std::int64_t bin_edge(std::int64_t radius) {
  std::int64_t edge = static_cast<std::int64_t>(static_cast<double>(radius) / 1.7320508075688772) + 2;
  while (edge > 1 && 3 * (edge - 1) * (edge - 1) > radius * radius) --edge;
  return edge;
}

std::vector<RowsAhead> rows_ahead(std::int64_t edge, std::int64_t radius, int most) {
  const auto gap2 = [&](int d) {
    const std::int64_t gap = d == 0 ? 0 : (std::abs(d) - 1) * edge + 1;
    return gap * gap;
  };
  std::vector<RowsAhead> ahead;
  for (int dz = 0; dz <= most; ++dz) {
    const int first = dz == 0 ? 0 : -most;
    ahead.push_back({static_cast<std::uint64_t>(std::int64_t{dz} * (1 << kBinBits) + first), {}});
    for (int dy = first; dy <= most; ++dy) {
      int along = most;
      while (along >= 0 && gap2(along) + gap2(dy) + gap2(dz) > radius * radius) --along;
      ahead.back().along.push_back(along);
    }
  }
  return ahead;
}

}  // namespace ilot
