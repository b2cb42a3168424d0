// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/walls/sparse_outline.h"

#include <algorithm>
#include <cmath>
#include <span>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// Choice: as the strips in which walls are followed.
constexpr double kColumn = 0.5;  // metres
// Choice: least height of a step in the outline of a wall in which points are sparse; eaves and lost points make less.
constexpr double kLeastRise = 1;  // metres
// Derived: the highest point of a column is within two steps of the top, nine times in ten.
constexpr double kStepsOfTop = 3;
// Choice: two columns; what hides the wall or a gap between windows takes one.
constexpr std::size_t kFewestColumns = 2;
// Choice: houses are wider; a window or a tree is narrower, and what it hides between higher columns is no gap.
constexpr double kWidestGap = 3;  // metres

struct Stretch {
  double u0 = 0, u1 = 0, top = 0;
};

// Runs of columns for which wanted(top, number of columns, lower than what is beside them) is true take the height of
// the higher column beside them. Those beside the first and the last column are given.
template <class Wanted>
void raise_runs(std::vector<SparseColumn>& columns, double before_all, double after_all, double same,
                const Wanted& wanted) {
  for (std::size_t i = 0; i < columns.size();) {
    const double top = columns[i].top;
    std::size_t end = i + 1;
    while (end < columns.size() && (columns[end].top == top || std::abs(columns[end].top - top) <= same)) ++end;
    const double before = i > 0 ? columns[i - 1].top : before_all;
    const double after = end < columns.size() ? columns[end].top : after_all;
    if (wanted(top, end - i, top < std::min(before, after)))
      for (std::size_t k = i; k < end; ++k) columns[k].top = std::max(before, after);
    i = end;
  }
}

// Closes columns without points first, then runs that are too short, then gaps between higher ones.
void close_gaps(std::vector<SparseColumn>& columns, double before_all, double after_all, double same) {
  const auto most = static_cast<std::size_t>(kWidestGap / kColumn);
  raise_runs(columns, before_all, after_all, same, [](double top, std::size_t, bool) { return !std::isfinite(top); });
  raise_runs(columns, before_all, after_all, same,
             [](double, std::size_t count, bool) { return count < kFewestColumns; });
  raise_runs(columns, before_all, after_all, same,
             [&](double, std::size_t count, bool lower) { return lower && count <= most; });
}

// Stretches of columns whose heights differ by at most `same` from the first of them.
std::vector<Stretch> stretches_of(const std::vector<SparseColumn>& columns, const Box2& whole, double same) {
  std::vector<Stretch> stretches;
  for (std::size_t i = 0; i < columns.size();) {
    std::vector<double> tops;
    std::size_t end = i;
    for (; end < columns.size() && (end == i || std::abs(columns[end].top - columns[i].top) <= same); ++end)
      tops.push_back(columns[end].top);
    double top = upper_median(tops);
    if (!std::isfinite(top) || whole.v1 - top <= same) top = whole.v1;
    if (!stretches.empty() && stretches.back().top == top)
      stretches.back().u1 = columns[end - 1].u1;
    else
      stretches.push_back({columns[i].u0, columns[end - 1].u1, top});
    i = end;
  }
  return stretches;
}

void add_corner(WallOutline& outline, Place2 at, FacadeEdge edge, double step) {
  edge.error_m = std::max(edge.error_m, step);
  if (!outline.ring.empty() && outline.ring.back().u == at.u && outline.ring.back().v == at.v) {
    outline.edges.back() = edge;
    return;
  }
  outline.ring.push_back(at);
  outline.edges.push_back(edge);
}

void add_stretches(WallOutline& outline, std::span<const Stretch> stretches, double step) {
  for (std::size_t i = stretches.size(); i-- > 0;) {
    add_corner(outline, {stretches[i].u1, stretches[i].top}, {}, step);
    add_corner(outline, {stretches[i].u0, stretches[i].top}, {}, step);
  }
}

// Removes corners between edges on one upright or level line.
void join_edges(WallOutline& outline) {
  for (std::size_t i = 0; i < outline.ring.size() && outline.ring.size() > 4;) {
    const std::size_t n = outline.ring.size(), last = (i + n - 1) % n;
    const Place2 &a = outline.ring[last], &b = outline.ring[i], &c = outline.ring[(i + 1) % n];
    const bool one = (a.u == b.u && b.u == c.u) || (a.v == b.v && b.v == c.v);
    if (one && outline.edges[i].status == outline.edges[last].status) {
      outline.edges[last].error_m = std::max(outline.edges[last].error_m, outline.edges[i].error_m);
      outline.ring.erase(outline.ring.begin() + static_cast<std::ptrdiff_t>(i));
      outline.edges.erase(outline.edges.begin() + static_cast<std::ptrdiff_t>(i));
    } else {
      ++i;
    }
  }
}

}  // namespace

std::vector<SparseColumn> sparse_columns(const RaySamples& samples, double u0, double u1) {
  const auto count = static_cast<std::size_t>(std::max(1.0, std::round((u1 - u0) / kColumn)));
  const double wide = (u1 - u0) / static_cast<double>(count);
  std::vector<double> first(count, -INFINITY), second(first);
  for (const Ray& ray : samples.at_places({u0, u1, 0, samples.site().height})) {
    if (!samples.on_wall(ray) || ray.at.u < u0 || ray.at.u >= u1) continue;
    const std::size_t c = std::min(count - 1, static_cast<std::size_t>((ray.at.u - u0) / wide));
    const double v = ray.at.v;
    second[c] = std::max(second[c], std::min(first[c], v));
    first[c] = std::max(first[c], v);
  }
  std::vector<SparseColumn> columns;
  for (std::size_t c = 0; c < count; ++c)
    columns.push_back({u0 + static_cast<double>(c) * wide, u0 + static_cast<double>(c + 1) * wide, second[c]});
  return columns;
}

WallOutline outline_with_columns(const WallOutline& core, double width, std::vector<SparseColumn> columns,
                                 const Box2& whole, double step) {
  WallOutline outline;
  add_corner(outline, {whole.u0, whole.v0}, {}, step);
  add_corner(outline, {whole.u1, whole.v0}, {}, step);
  if (columns.empty()) {
    add_corner(outline, {whole.u1, whole.v1}, {}, step);
    add_corner(outline, {whole.u0, whole.v1}, {}, step);
    return outline;
  }
  std::sort(columns.begin(), columns.end(), [](const SparseColumn& a, const SparseColumn& b) { return a.u0 < b.u0; });
  const double same = std::max(kLeastRise, kStepsOfTop * step);
  const auto right =
      std::find_if(columns.begin(), columns.end(), [&](const SparseColumn& c) { return c.u0 >= width / 2; });
  std::vector<SparseColumn> beyond_right(right, columns.end()), beyond_left(columns.begin(), right);
  close_gaps(beyond_right, core.ring[2].v, -INFINITY, same);
  close_gaps(beyond_left, -INFINITY, core.ring.back().v, same);
  add_stretches(outline, stretches_of(beyond_right, whole, same), step);
  for (std::size_t i = 2; i < core.ring.size(); ++i) {
    Place2 p = core.ring[i];
    if (whole.v1 - p.v <= 2 * step && core.edges.empty()) p.v = whole.v1;
    p.v = std::min(p.v, whole.v1);  // a slope that goes on to the end of the dense part
    add_corner(outline, p, i < core.edges.size() ? core.edges[i] : FacadeEdge{}, step);
  }
  add_stretches(outline, stretches_of(beyond_left, whole, same), step);
  join_edges(outline);
  return outline;
}

}  // namespace ilot
