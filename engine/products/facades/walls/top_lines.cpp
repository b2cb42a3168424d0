// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/top_lines.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include "kernels/core/portable_math.h"
#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// A profile, and which of its columns already belong to a line.
struct Columns {
  std::span<const double> top;
  double cell;
  std::vector<std::uint8_t> taken;

  double u(std::size_t i) const { return (static_cast<double>(i) + 0.5) * cell; }
  bool free(std::size_t i) const { return taken[i] == 0; }
};

struct Support {
  std::size_t on = 0, above = 0;
};

// The support of a line in the columns [first, last]; `within` is a vertical distance.
Support support_of(const Columns& columns, const TopLine& line, double within) {
  Support s;
  for (std::size_t i = line.first; i <= line.last; ++i) {
    const double off = columns.top[i] - line.height(columns.u(i));
    s.on += std::abs(off) <= within;
    s.above += off > within;
  }
  return s;
}

TopLine through(const Columns& columns, std::size_t i, std::size_t j) {
  TopLine line;
  line.slope = (columns.top[j] - columns.top[i]) / (columns.u(j) - columns.u(i));
  line.at = columns.top[i] - line.slope * columns.u(i);
  line.first = i, line.last = j;
  return line;
}

// The length along the line of one horizontal metre.
double stretch_of(const TopLine& line) {
  return std::sqrt(1 + line.slope * line.slope);
}

double least_columns(const TopLineParams& params, double cell) {
  // Choice: a line over fewer columns can be chance.
  constexpr double kLeast = 6;
  return std::max(kLeast, params.least_length * cos_degrees(params.most_lean_deg) / cell);
}

// The line that contains the greatest length; last < first if there is none.
TopLine best_line(const Columns& columns, const TopLineParams& params) {
  const std::size_t n = columns.top.size();
  const double steepest = std::sqrt(1 / (cos_degrees(params.most_lean_deg) * cos_degrees(params.most_lean_deg)) - 1);
  const auto least = static_cast<std::size_t>(least_columns(params, columns.cell));
  TopLine best;
  best.first = 1, best.last = 0;
  double most = 0;
  for (std::size_t i = 0; i + least <= n; ++i) {
    if (!columns.free(i) || !std::isfinite(columns.top[i])) continue;
    for (std::size_t j = i + 1; j < n && columns.free(j); ++j) {
      if (j - i + 1 < least || !std::isfinite(columns.top[j])) continue;
      const TopLine line = through(columns, i, j);
      const double stretch = stretch_of(line), count = static_cast<double>(j - i + 1);
      const double length = count * columns.cell * stretch;
      if (std::abs(line.slope) > steepest || length < params.least_length || length <= most) continue;
      const Support s = support_of(columns, line, params.tolerance * stretch);
      const double on = static_cast<double>(s.on), lying = on * columns.cell * stretch;
      if (lying <= most || on < params.least_support * count ||
          static_cast<double>(s.above) > params.most_above * count)
        continue;
      most = lying;
      best = line;
    }
  }
  return best;
}

// Makes the line level if this moves its ends by at most the tolerance.
TopLine levelled(const Columns& columns, TopLine line, const TopLineParams& params) {
  const double half = 0.5 * static_cast<double>(line.last - line.first + 1) * columns.cell;
  if (std::abs(line.slope) * half > params.tolerance) return line;
  std::vector<double> heights;
  for (std::size_t i = line.first; i <= line.last; ++i)
    if (std::abs(columns.top[i] - line.height(columns.u(i))) <= params.tolerance) heights.push_back(columns.top[i]);
  line.slope = 0, line.at = upper_median(heights);
  return line;
}

}  // namespace

std::vector<double> ring_profile(std::span<const OutlineRing> rings, ProfileOf of, double sign, double from,
                                 double cell, std::size_t count) {
  std::vector<double> profile(count, -INFINITY);
  const auto along = [&](const Place2& p) { return (of == ProfileOf::columns ? p.u : p.v) - from; };
  const auto across = [&](const Place2& p) { return sign * (of == ProfileOf::columns ? p.v : p.u); };
  for (const OutlineRing& ring : rings)
    for (std::size_t k = 0; k < ring.size(); ++k) {
      const Place2 *a = &ring[k], *b = &ring[(k + 1) % ring.size()];
      if (along(*a) > along(*b)) std::swap(a, b);
      const double low = along(*a), high = along(*b);
      const double first = std::max(0.0, std::ceil(low / cell - 0.5));
      for (double i = first; i < static_cast<double>(count) && (i + 0.5) * cell <= high; i += 1) {
        const double share = high > low ? ((i + 0.5) * cell - low) / (high - low) : 0;
        double& at = profile[static_cast<std::size_t>(i)];
        at = std::max(at, across(*a) + share * (across(*b) - across(*a)));
      }
    }
  return profile;
}

std::vector<TopLine> top_lines(std::span<const double> profile, double cell, const TopLineParams& params) {
  Columns columns{profile, cell, std::vector<std::uint8_t>(profile.size(), 0)};
  std::vector<TopLine> lines;
  for (;;) {
    TopLine line = best_line(columns, params);
    if (line.last < line.first) break;
    for (std::size_t i = line.first; i <= line.last; ++i) columns.taken[i] = 1;
    lines.push_back(levelled(columns, line, params));
  }
  std::sort(lines.begin(), lines.end(), [](const TopLine& a, const TopLine& b) { return a.first < b.first; });
  return lines;
}

}  // namespace ilot
