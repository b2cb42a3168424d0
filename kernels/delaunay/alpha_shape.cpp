// SPDX-License-Identifier: Apache-2.0
#include "kernels/delaunay/alpha_shape.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace ilot {
namespace {

struct Corners {
  std::array<std::uint32_t, 3> v;
  std::array<Point2, 3> p;
};

Corners corners_of(const Triangulation& t, std::size_t triangle, std::span<const Point2> points) {
  const std::uint32_t a = t.corner[3 * triangle], b = t.corner[3 * triangle + 1], c = t.corner[3 * triangle + 2];
  return {{a, b, c}, {points[a], points[b], points[c]}};
}

// Returns the squared lengths in ascending order, so that rounding does not depend on the order of the corners.
std::array<double, 3> squared_edges(const std::array<Point2, 3>& p) {
  const auto a = static_cast<double>(squared_distance(p[0], p[1]));
  const auto b = static_cast<double>(squared_distance(p[1], p[2]));
  const auto c = static_cast<double>(squared_distance(p[2], p[0]));
  const double low = std::min(a, b), high = std::max(a, b);  // no branches, because they would be mispredicted
  return {std::min(low, c), std::max(low, std::min(high, c)), std::max(high, c)};
}

// Tests circumradius <= reach. With edges a, b, c and area K the circumradius is abc / 4K.
bool circle_fits(const std::array<Point2, 3>& p, double reach) {
  const std::array<double, 3> d = squared_edges(p);
  const double twice_area = static_cast<double>(orient2d(p[0], p[1], p[2]));
  return d[0] * d[1] * d[2] <= 4 * (reach * reach) * (twice_area * twice_area);
}

bool edges_fit(const Corners& c, double reach, std::span<const std::int32_t> height) {
  for (std::size_t i = 0; i < 3; ++i) {
    const std::size_t j = (i + 1) % 3;
    std::int64_t d2 = squared_distance(c.p[i], c.p[j]);
    if (!height.empty()) {
      const std::int64_t dz = height[c.v[i]] - height[c.v[j]];
      d2 += dz * dz;
    }
    if (static_cast<double>(d2) > reach * reach) return false;
  }
  return true;
}

bool in_shape(const Corners& c, const ShapeParams& params) {
  const auto& v = c.v;
  if (!params.label.empty() && (params.label[v[0]] != params.label[v[1]] || params.label[v[1]] != params.label[v[2]]))
    return false;
  const double reach = std::max({params.reach[v[0]], params.reach[v[1]], params.reach[v[2]]});
  if (params.rule == TriangleRule::kCircumradius) return circle_fits(c.p, reach);
  return edges_fit(c, reach, params.height) && circle_fits(c.p, kRadiusPerEdge * reach);
}

// Returns the corner that owns a triangle.
std::size_t owning(const Corners& c, std::span<const float> reach) {
  std::size_t best = 0;
  for (std::size_t i = 1; i < 3; ++i) {
    const float mine = reach[c.v[i]], other = reach[c.v[best]];
    if (mine > other || (mine == other && c.p[i] < c.p[best])) best = i;
  }
  return best;
}

// Square cells over points, with about two points each where the points fill their box.
class Cells {
 public:
  explicit Cells(std::span<const Point2> points) : low_(points[0]) {
    Point2 high = low_;
    for (const Point2 p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const auto cells = [&] { return place(high).first + 1; };
    const auto rows = [&] { return place(high).second + 1; };
    while (cells() * rows() > static_cast<std::int64_t>(points.size() / 2 + 16)) ++shift_;
    columns_ = cells();
    rows_ = rows();
  }

  std::int64_t columns() const { return columns_; }
  std::int64_t rows() const { return rows_; }
  std::size_t at(std::int64_t column, std::int64_t row) const {
    return static_cast<std::size_t>(row * columns_ + column);
  }
  std::size_t of(Point2 p) const {
    const auto [column, row] = place(p);
    return at(column, row);
  }
  // Number of cells to each side that a distance from anywhere in a cell may reach.
  std::int64_t across(std::int64_t distance) const { return (distance >> shift_) + 1; }

 private:
  std::pair<std::int64_t, std::int64_t> place(Point2 p) const {
    return {(std::int64_t{p.x} - low_.x) >> shift_, (std::int64_t{p.y} - low_.y) >> shift_};
  }

  Point2 low_;
  int shift_ = 0;
  std::int64_t columns_ = 0, rows_ = 0;
};

// Spreads the need of each cell to its neighbours. `need` is the number of cells that each one requests; a neighbour
// (one of eight) gets one less. A negative value means not needed. It takes two sweeps, as for chessboard distances
// (Rosenfeld, Pfaltz 1968).
void spread(const Cells& cells, std::vector<std::int64_t>& need) {
  const std::int64_t columns = cells.columns(), rows = cells.rows();
  const auto take = [&](std::int64_t column, std::int64_t row, std::int64_t from_column, std::int64_t from_row) {
    if (from_column < 0 || from_column >= columns || from_row < 0 || from_row >= rows) return;
    std::int64_t& mine = need[cells.at(column, row)];
    mine = std::max(mine, need[cells.at(from_column, from_row)] - 1);
  };
  for (const std::int64_t back : {-1, 1})
    for (std::int64_t r = 0; r < rows; ++r)
      for (std::int64_t c = 0; c < columns; ++c) {
        const std::int64_t row = back < 0 ? r : rows - 1 - r, column = back < 0 ? c : columns - 1 - c;
        take(column, row, column + back, row);
        for (const std::int64_t side : {-1, 0, 1}) take(column, row, column + side, row + back);
      }
}

}  // namespace

std::vector<std::uint8_t> shape_triangles(const Triangulation& t, std::span<const Point2> points,
                                          const ShapeParams& params) {
  std::vector<std::uint8_t> keep(t.triangles());
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = in_shape(corners_of(t, i, points), params) ? 1 : 0;
  return keep;
}

std::uint32_t owner(const Triangulation& t, std::size_t triangle, std::span<const Point2> points,
                    std::span<const float> reach) {
  const Corners c = corners_of(t, triangle, points);
  return c.v[owning(c, reach)];
}

std::int64_t shape_halo(TriangleRule rule, double largest) {
  const double radius = rule == TriangleRule::kCircumradius ? largest : kRadiusPerEdge * largest;
  return static_cast<std::int64_t>(std::ceil(2 * radius)) + 1;
}

std::vector<std::uint8_t> needed_points(TriangleRule rule, std::span<const Point2> points, std::span<const float> reach,
                                        std::span<const std::uint8_t> own) {
  if (points.empty()) return {};
  const Cells cells(points);
  std::vector<std::int64_t> need(cells.at(0, cells.rows()), -1);
  for (std::size_t i = 0; i < points.size(); ++i)
    if (own[i]) {
      std::int64_t& n = need[cells.of(points[i])];
      n = std::max(n, cells.across(shape_halo(rule, static_cast<double>(reach[i]))));
    }
  spread(cells, need);
  std::vector<std::uint8_t> needed(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) needed[i] = need[cells.of(points[i])] >= 0 ? 1 : 0;
  return needed;
}

std::vector<std::uint32_t> owned_triangles(const Triangulation& t, std::span<const Point2> points,
                                           const ShapeParams& params, std::span<const std::uint8_t> own) {
  std::vector<std::uint32_t> triangles;
  triangles.reserve(t.triangles());
  for (std::size_t i = 0; i < t.triangles(); ++i) {
    const Corners c = corners_of(t, i, points);
    const int count = own[c.v[0]] + own[c.v[1]] + own[c.v[2]];
    if (count == 0 || !in_shape(c, params)) continue;
    if (count == 3 || own[c.v[owning(c, params.reach)]]) triangles.push_back(static_cast<std::uint32_t>(i));
  }
  return triangles;
}

void keep_enclosed(const Triangulation& t, std::span<std::uint8_t> keep) {
  std::vector<std::uint8_t> outside(keep.size());
  std::vector<std::uint32_t> stack;
  const auto reach = [&](std::uint32_t triangle) {
    if (keep[triangle] || outside[triangle]) return;
    outside[triangle] = 1;
    stack.push_back(triangle);
  };
  for (std::uint32_t e = 0; e < t.twin.size(); ++e)
    if (t.twin[e] == kNoEdge) reach(e / 3);
  while (!stack.empty()) {
    const std::uint32_t triangle = stack.back();
    stack.pop_back();
    for (std::uint32_t e = 3 * triangle; e < 3 * triangle + 3; ++e)
      if (t.twin[e] != kNoEdge) reach(t.twin[e] / 3);
  }
  for (std::size_t i = 0; i < keep.size(); ++i) keep[i] = outside[i] ? 0 : 1;
}

}  // namespace ilot
