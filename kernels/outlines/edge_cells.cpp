// SPDX-License-Identifier: Apache-2.0
#include "kernels/outlines/edge_cells.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

constexpr double kCellsAlong = 8;      // an edge is looked at in pieces of so many grid cells
constexpr double kMaxCells = 1 << 22;  // of the grid

// Points in square cells, by cell: those of cell c are order[first[c]] to order[first[c + 1] - 1].
struct Grid {
  FlatPoint low, high;
  double size = 1;
  std::int64_t columns = 1, rows = 1;
  std::vector<std::uint32_t> first, order;

  static std::int64_t slot(double offset, std::int64_t count) {
    return static_cast<std::int64_t>(std::clamp(offset, 0.0, static_cast<double>(count - 1)));
  }
  std::int64_t column(double x) const { return slot((x - low.x) / size, columns); }
  std::int64_t row(double y) const { return slot((y - low.y) / size, rows); }
  std::size_t cell(FlatPoint p) const { return static_cast<std::size_t>(row(p.y) * columns + column(p.x)); }
};

Grid make_grid(std::span<const FlatPoint> points) {
  Grid grid{points[0], points[0], 1, 1, 1, {}, {}};
  for (const FlatPoint& p : points) {
    grid.low = {std::min(grid.low.x, p.x), std::min(grid.low.y, p.y)};
    grid.high = {std::max(grid.high.x, p.x), std::max(grid.high.y, p.y)};
  }
  const double width = grid.high.x - grid.low.x, height = grid.high.y - grid.low.y;
  const double wanted = std::min(kMaxCells, static_cast<double>(points.size()) / 2 + 1);
  grid.size = std::max(std::sqrt(width * height / wanted), std::max(width, height) / wanted);
  if (!(grid.size > 0)) grid.size = 1;
  grid.columns = static_cast<std::int64_t>(width / grid.size) + 1;
  grid.rows = static_cast<std::int64_t>(height / grid.size) + 1;
  grid.first.assign(static_cast<std::size_t>(grid.columns * grid.rows) + 1, 0);
  for (const FlatPoint& p : points) ++grid.first[grid.cell(p) + 1];
  for (std::size_t c = 1; c < grid.first.size(); ++c) grid.first[c] += grid.first[c - 1];
  std::vector<std::uint32_t> next(grid.first.begin(), grid.first.end() - 1);
  grid.order.resize(points.size());
  for (std::uint32_t i = 0; i < points.size(); ++i) grid.order[next[grid.cell(points[i])]++] = i;
  return grid;
}

// Squared distance of a point from the edge's point at t, less t^2: offset - 2 along t.
struct Line {
  double along = 0, offset = 0;
  std::uint32_t point = 0;
};

double meeting(const Line& a, const Line& b) {
  return (b.offset - a.offset) / (2 * (b.along - a.along));
}

// Lines that are lowest somewhere, from left to right; of equal ones the first.
std::vector<Line> lower_envelope(const std::vector<Line>& sorted) {
  std::vector<Line> envelope;
  for (const Line& line : sorted) {
    if (!envelope.empty() && envelope.back().along == line.along) continue;  // sorted: not lower
    while (envelope.size() > 1 &&
           meeting(envelope[envelope.size() - 2], line) <= meeting(envelope[envelope.size() - 2], envelope.back()))
      envelope.pop_back();
    envelope.push_back(line);
  }
  return envelope;
}

class EdgeWalk {
 public:
  EdgeWalk(std::span<const FlatPoint> points, std::vector<std::uint8_t>& flags)
      : points_(points), grid_(make_grid(points)), flags_(flags) {}

  void walk(const FlatEdge& edge) {
    const double length = std::hypot(edge.b.x - edge.a.x, edge.b.y - edge.a.y);
    if (!(length > 0)) return;
    const FlatPoint along{(edge.b.x - edge.a.x) / length, (edge.b.y - edge.a.y) / length};
    const double pieces = std::max(1.0, std::min(std::ceil(length / (kCellsAlong * grid_.size)), 1e6));
    for (double i = 0; i < pieces; ++i) walk_piece(edge.a, along, length * (i / pieces), length * ((i + 1) / pieces));
  }

 private:
  void walk_piece(FlatPoint a, FlatPoint along, double from, double to) {
    for (double reach = 2 * grid_.size;; reach *= 4) {
      const bool whole = gather(a, along, from, to, reach);
      if (lines_.empty()) continue;
      std::sort(lines_.begin(), lines_.end(), [](const Line& l, const Line& r) {
        return l.along < r.along ||
               (l.along == r.along && (l.offset < r.offset || (l.offset == r.offset && l.point < r.point)));
      });
      const std::vector<Line> envelope = lower_envelope(lines_);
      if (!whole && farthest(envelope, from, to) > reach * reach) continue;
      mark(envelope, from, to);
      return;
    }
  }

  // Lines of all points within `reach` of the piece, and some more. True when they are all there are.
  bool gather(FlatPoint a, FlatPoint along, double from, double to, double reach) {
    lines_.clear();
    const FlatPoint p{a.x + from * along.x, a.y + from * along.y}, q{a.x + to * along.x, a.y + to * along.y};
    const FlatPoint low{std::min(p.x, q.x) - reach, std::min(p.y, q.y) - reach};
    const FlatPoint high{std::max(p.x, q.x) + reach, std::max(p.y, q.y) + reach};
    for (std::int64_t r = grid_.row(low.y); r <= grid_.row(high.y); ++r) {
      const auto row = static_cast<std::size_t>(r * grid_.columns);
      const std::uint32_t first = grid_.first[row + static_cast<std::size_t>(grid_.column(low.x))];
      const std::uint32_t end = grid_.first[row + static_cast<std::size_t>(grid_.column(high.x)) + 1];
      for (std::uint32_t k = first; k < end; ++k) {
        const std::uint32_t i = grid_.order[k];
        const double dx = points_[i].x - a.x, dy = points_[i].y - a.y;
        lines_.push_back({dx * along.x + dy * along.y, dx * dx + dy * dy, i});
      }
    }
    return low.x <= grid_.low.x && low.y <= grid_.low.y && high.x >= grid_.high.x && high.y >= grid_.high.y;
  }

  // Largest squared distance from the piece to its nearest point: at an end or where the nearest one changes.
  static double farthest(const std::vector<Line>& envelope, double from, double to) {
    const auto squared = [](const Line& l, double t) { return l.offset - 2 * l.along * t + t * t; };
    double most = 0;
    for (std::size_t i = 0; i < envelope.size(); ++i) {
      const double start = i == 0 ? from : std::clamp(meeting(envelope[i - 1], envelope[i]), from, to);
      const double end = i + 1 == envelope.size() ? to : std::clamp(meeting(envelope[i], envelope[i + 1]), from, to);
      if (start < end) most = std::max({most, squared(envelope[i], start), squared(envelope[i], end)});
    }
    return most;
  }

  void mark(const std::vector<Line>& envelope, double from, double to) {
    for (std::size_t i = 0; i < envelope.size(); ++i) {
      const double start = i == 0 ? from : std::max(from, meeting(envelope[i - 1], envelope[i]));
      const double end = i + 1 == envelope.size() ? to : std::min(to, meeting(envelope[i], envelope[i + 1]));
      if (start >= end) continue;
      const auto same = std::lower_bound(lines_.begin(), lines_.end(), envelope[i], [](const Line& l, const Line& r) {
        return l.along < r.along || (l.along == r.along && l.offset < r.offset);
      });
      for (auto l = same; l != lines_.end() && l->along == envelope[i].along && l->offset == envelope[i].offset; ++l)
        flags_[l->point] = 1;
    }
  }

  std::span<const FlatPoint> points_;
  Grid grid_;
  std::vector<std::uint8_t>& flags_;
  std::vector<Line> lines_;
};

}  // namespace

std::vector<std::uint8_t> cells_on_edges(std::span<const FlatPoint> points, std::span<const FlatEdge> edges) {
  std::vector<std::uint8_t> flags(points.size(), 0);
  if (points.empty()) return flags;
  EdgeWalk walk(points, flags);
  for (const FlatEdge& edge : edges) walk.walk(edge);
  return flags;
}

}  // namespace ilot
