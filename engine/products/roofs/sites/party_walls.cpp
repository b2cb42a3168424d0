// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/party_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <tuple>
#include <utility>

#include "engine/products/roofs/faces/partition.h"
#include "engine/products/roofs/sites/outline_repair.h"
#include "engine/products/roofs/sites/step_offset.h"
#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

// Derived: three steps of the grid of 1 mm.
constexpr double kShortestEdge = 0.003;  // metres: a cut that ends this near to a corner ends in the corner
// Derived: 1.6 squared is 2.6: two or three points a cell.
constexpr double kCellSteps = 1.6;  // steps; side of the cells in which heights are compared: two or three points each
// Choice: 3 degrees, the error of a line of ten steps.
constexpr double kSameDirection = 0.9986;  // cosine of 3 degrees
constexpr std::size_t kMostDirections = 4;
// Choice: more than half, with a margin for chimneys on the wall.
constexpr double kSeenRows = 0.6;  // least share of a wall's length where both sides have points
constexpr std::size_t kMostTried = 16;
// Choice: the error of a drawn outline; no result beyond it depends on it.
constexpr double kBeyond = 0.05;  // metres that a cut continues past the outline
constexpr double kEmpty = -std::numeric_limits<double>::infinity();

// A line along v of the frame that could divide the outline, and how clear it is.
struct Wall {
  FlatEdge cut;
  double clearness = 0;  // metres with a step minus those without
  double length = 0;
};

// The directions of the outline and across them, the longest first.
std::vector<FlatPoint> directions_of(const SitePolygon& outline) {
  std::vector<std::pair<double, FlatPoint>> weighted;
  for (const auto& ring : outline)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Point2 p = ring[i], q = ring[(i + 1) % ring.size()];
      const double dx = q.x - p.x, dy = q.y - p.y, length = std::sqrt(dx * dx + dy * dy);
      if (length > 0) weighted.push_back({length, {dx / length, dy / length}});
    }
  std::stable_sort(weighted.begin(), weighted.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<std::pair<double, FlatPoint>> known;
  for (const auto& [length, d] : weighted) {
    const FlatPoint direction = d;
    const auto same = std::find_if(known.begin(), known.end(), [&](const auto& k) {
      return std::max(std::abs(dot(k.second, direction)), std::abs(cross(k.second, direction))) >= kSameDirection;
    });
    if (same == known.end()) {
      known.push_back({length, direction});
    } else {
      same->first += length;
    }
  }
  std::stable_sort(known.begin(), known.end(), [](const auto& a, const auto& b) { return a.first > b.first; });
  std::vector<FlatPoint> directions;
  for (const auto& [length, d] : known) {
    if (directions.size() >= kMostDirections) break;
    directions.push_back(d);
    directions.push_back({-d.y, d.x});
  }
  return directions;
}

// The heights over an outline in a frame of its own: v along a direction, u to the right of it.
class HeightRows {
 public:
  HeightRows(const SitePolygon& outline, std::span<const Vec3> points, FlatPoint along, double cell)
      : along_(along), cell_(cell), points_(points) {
    double high_u = -INFINITY, high_v = -INFINITY;
    for (const auto& ring : outline) {
      auto& flat = rings_.emplace_back();
      for (const Point2 p : ring) {
        flat.push_back(seen({p.x * 0.001, p.y * 0.001}));
        low_ = {std::min(low_.x, flat.back().x), std::min(low_.y, flat.back().y)};
        high_u = std::max(high_u, flat.back().x);
        high_v = std::max(high_v, flat.back().y);
      }
    }
    columns_ = static_cast<std::size_t>((high_u - low_.x) / cell) + 1;
    rows_ = static_cast<std::size_t>((high_v - low_.y) / cell) + 1;
    heights_.assign(columns_ * rows_, kEmpty);
    for (const Vec3& p : points) {
      const FlatPoint s = seen({p.x, p.y});
      if (s.x < low_.x || s.y < low_.y || s.x >= high_u || s.y >= high_v) continue;
      double& highest = heights_[row(s.y) * columns_ + column(s.x)];
      highest = std::max(highest, p.z);
    }
    for (std::size_t r = 0; r < rows_; ++r)
      inside_.push_back(intervals(low_.y + (static_cast<double>(r) + 0.5) * cell));
  }

  // Adds all possible walls between two columns.
  void add_walls(double step, const PartyWallParams& params, std::vector<Wall>& walls) const {
    for (std::size_t c = 0; c + 1 < columns_; ++c) {
      for (std::size_t r = 0; r < rows_;) {
        std::size_t end = r;
        while (end < rows_ && is_split_between(end, c)) ++end;
        if (end > r) {
          const std::optional<Wall> wall = wall_at(c, r, end, step, params);
          if (wall) walls.push_back(*wall);
        }
        r = end + 1;
      }
    }
  }

 private:
  FlatPoint seen(FlatPoint p) const { return {-cross(along_, p), dot(along_, p)}; }
  FlatPoint back(FlatPoint s) const { return {s.y * along_.x + s.x * along_.y, s.y * along_.y - s.x * along_.x}; }
  std::size_t row(double v) const { return std::min(rows_ - 1, static_cast<std::size_t>((v - low_.y) / cell_)); }
  std::size_t column(double u) const { return std::min(columns_ - 1, static_cast<std::size_t>((u - low_.x) / cell_)); }
  double border(std::size_t c) const { return low_.x + static_cast<double>(c + 1) * cell_; }

  // The intervals in which a line along u at height v of the frame runs inside of the outline.
  std::vector<double> intervals(double v) const {
    std::vector<double> crossings;
    for (const auto& ring : rings_)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const FlatPoint a = ring[i], b = ring[(i + 1) % ring.size()];
        if ((a.y > v) != (b.y > v)) crossings.push_back(a.x + (v - a.y) / (b.y - a.y) * (b.x - a.x));
      }
    std::sort(crossings.begin(), crossings.end());
    return crossings;
  }

  // Returns true where both sides of a column's right border lie inside for at least one cell.
  bool is_split_between(std::size_t r, std::size_t c) const {
    const std::vector<double>& ends = inside_[r];
    for (std::size_t i = 0; i + 1 < ends.size(); i += 2)
      if (ends[i] <= border(c) - cell_ && ends[i + 1] >= border(c) + cell_) return true;
    return false;
  }

  // Returns true where the outline continues at least this far to both sides, on average.
  bool deep(std::size_t c, std::size_t first, std::size_t last, double least) const {
    double left = 0, right = 0;
    for (std::size_t r = first; r < last; ++r)
      for (std::size_t i = 0; i + 1 < inside_[r].size(); i += 2)
        if (inside_[r][i] <= border(c) && inside_[r][i + 1] >= border(c)) {
          left += border(c) - inside_[r][i];
          right += inside_[r][i + 1] - border(c);
        }
    return std::min(left, right) >= least * static_cast<double>(last - first);
  }

  double at(std::size_t r, std::ptrdiff_t c) const {
    return c < 0 || c >= static_cast<std::ptrdiff_t>(columns_) ? kEmpty
                                                               : heights_[r * columns_ + static_cast<std::size_t>(c)];
  }

  struct Jump {
    double rise = 0, top = 0;  // `rise`: height gain towards the right; `top`: height of the upper side
  };

  // How much higher the right side of a border is than the continued roof of the left side; nullopt where one of them
  // has no point. Cells that contain points of both sides show the upper one, so a step is also searched one cell
  // farther.
  std::optional<Jump> jump(std::size_t r, std::size_t c) const {
    const auto left = static_cast<std::ptrdiff_t>(c);
    std::optional<Jump> largest;
    for (const std::ptrdiff_t l : {left, left - 1}) {
      const double a = at(r, l), b = at(r, l + 1);
      if (a == kEmpty || b == kEmpty) continue;
      const double before = at(r, l - 1), after = at(r, l + 2);
      const double slope_a = before == kEmpty ? 0 : a - before, slope_b = after == kEmpty ? 0 : after - b;
      const double most = kSteepest * cell_;
      const double rise = b - a - (std::clamp(slope_a, -most, most) + std::clamp(slope_b, -most, most)) / 2;
      if (!largest || std::abs(rise) > std::abs(largest->rise)) largest = Jump{rise, std::max(a, b)};
    }
    return largest;
  }

  std::optional<Wall> wall_at(std::size_t c, std::size_t first, std::size_t last, double step,
                              const PartyWallParams& params) const {
    const double length = static_cast<double>(last - first) * cell_;
    if (length < params.least_wall || !deep(c, first, last, params.least_depth)) return std::nullopt;
    std::size_t seen_rows = 0, stepped = 0;
    std::vector<Jump> jumps;
    for (std::size_t r = first; r < last; ++r) {
      const std::optional<Jump> seen_here = jump(r, c);
      seen_rows += seen_here.has_value();
      jumps.push_back(seen_here && std::abs(seen_here->rise) >= params.least_step ? *seen_here : Jump());
      stepped += jumps.back().rise != 0;
    }
    if (static_cast<double>(seen_rows) < kSeenRows * static_cast<double>(last - first)) return std::nullopt;
    if (static_cast<double>(stepped) < params.least_share * static_cast<double>(seen_rows)) return std::nullopt;
    const double u = place(c, first, jumps, step);
    const double middle = low_.y + static_cast<double>(first + last) / 2 * cell_;
    double v0 = -INFINITY, v1 = INFINITY;
    for (const double v : crossings(u)) {
      if (v < middle) v0 = std::max(v0, v);
      if (v >= middle) v1 = std::min(v1, v);
    }
    if (v1 - v0 > length + 2 * kLongerCells * cell_) return std::nullopt;
    return Wall{
        {back({u, v0 - kBeyond}), back({u, v1 + kBeyond})}, 2 * static_cast<double>(stepped) * cell_ - length, length};
  }

  // Where a line along v of the frame meets the outline.
  std::vector<double> crossings(double u) const {
    std::vector<double> all;
    for (const auto& ring : rings_)
      for (std::size_t i = 0; i < ring.size(); ++i) {
        const FlatPoint a = ring[i], b = ring[(i + 1) % ring.size()];
        if ((a.x > u) != (b.x > u)) all.push_back(a.y + (u - a.x) / (b.x - a.x) * (b.y - a.y));
      }
    return all;
  }

  // The position of the wall along u, between the upper and the lower points beside it.
  double place(std::size_t c, std::size_t first, const std::vector<Jump>& jumps, double step) const {
    struct Ends {
      double upper = kEmpty, lower = kEmpty;  // towards the other side
    };
    std::vector<Ends> ends(jumps.size());
    for (const Vec3& p : points_) {
      const FlatPoint s = seen({p.x, p.y});
      if (s.x < border(c) - kNearCells * cell_ || s.x > border(c) + kNearCells * cell_ || s.y < low_.y) continue;
      const std::size_t r = row(s.y);
      if (r < first || r - first >= jumps.size() || jumps[r - first].rise == 0) continue;
      const Jump& here = jumps[r - first];
      const double outwards = here.rise > 0 ? -s.x : s.x;  // direction from the upper side to the lower one
      Ends& e = ends[r - first];
      if (p.z > here.top + std::abs(here.rise) / 2) continue;  // it belongs to another step
      if (p.z > here.top - std::abs(here.rise) / 2) {
        e.upper = std::max(e.upper, outwards);
      } else {
        e.lower = std::max(e.lower, -outwards);
      }
    }
    std::vector<StepGap> gaps;
    for (std::size_t i = 0; i < ends.size(); ++i) {
      if (ends[i].upper == kEmpty || ends[i].lower == kEmpty) continue;
      const double sense = jumps[i].rise > 0 ? -1 : 1;
      gaps.push_back({sense * ends[i].upper, -sense * ends[i].lower});
    }
    if (gaps.empty()) return border(c);
    return step_offset(gaps, step * step / (static_cast<double>(gaps.size()) * cell_));
  }

  // Derived: tan 50 degrees; steeper roofs look like steps.
  static constexpr double kSteepest = 1.2;  // steeper slopes are steps of their own
  // Derived: a step is known to a cell on either side.
  static constexpr double kNearCells = 2;
  // Choice: notches of an outline are shorter; party walls that end farther inside are not found.
  static constexpr double kLongerCells = 6;  // cells at either end of a wall where the outline leaves no room to see it

  FlatPoint along_;
  double cell_;
  std::span<const Vec3> points_;
  std::vector<std::vector<FlatPoint>> rings_;
  FlatPoint low_{INFINITY, INFINITY};
  std::size_t columns_ = 0, rows_ = 0;
  std::vector<double> heights_;
  std::vector<std::vector<double>> inside_;  // per row
};

// Returns both parts of a polygon if the cut makes two parts that can be buildings.
std::vector<SitePolygon> parts_of(const SitePolygon& polygon, const Wall& wall, const PartyWallParams& params) {
  const Partition cells = part(polygon, std::span(&wall.cut, 1));
  if (cells.regions != 2) return {};
  for (const double area : region_areas(cells))
    if (area != 0 && (area < params.least_area || area < params.least_depth * wall.length)) return {};
  return region_polygons(cells);
}

std::optional<Wall> clearest_wall(const SitePolygon& polygon, std::span<const Vec3> points, double step,
                                  const PartyWallParams& params) {
  std::vector<Wall> walls;
  for (const FlatPoint along : directions_of(polygon))
    HeightRows(polygon, points, along, kCellSteps * step).add_walls(step, params, walls);
  std::stable_sort(walls.begin(), walls.end(), [](const Wall& a, const Wall& b) { return a.clearness > b.clearness; });
  if (walls.size() > kMostTried) walls.resize(kMostTried);
  for (const Wall& wall : walls)
    if (!parts_of(polygon, wall, params).empty()) return wall;
  return std::nullopt;
}

}  // namespace

std::vector<SitePolygon> split_at_party_walls(const SitePolygon& outline, std::span<const Vec3> points, double step,
                                              const PartyWallParams& params) {
  std::vector<SitePolygon> open{outline};
  std::vector<FlatEdge> cuts;
  while (!open.empty()) {
    const SitePolygon polygon = std::move(open.back());
    open.pop_back();
    if (step <= 0 || area_of(polygon) < 2 * params.least_area) continue;
    const std::optional<Wall> wall = clearest_wall(polygon, points, step, params);
    if (!wall) continue;
    cuts.push_back(wall->cut);
    for (SitePolygon& p : parts_of(polygon, *wall, params)) open.push_back(std::move(p));
  }
  if (cuts.empty()) return {outline};
  Partition cells = part(outline, cuts);
  close_short_edges(cells, outline, kShortestEdge);
  std::vector<SitePolygon> parts = region_polygons(cells);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const SitePolygon& a, const SitePolygon& b) { return area_of(a) > area_of(b); });
  return parts;
}

}  // namespace ilot
