// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/sites/misalignment.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace ilot {
namespace {

constexpr double kMillimetre = 0.001;

// Cells of a row that follow each other; both ends belong to it.
struct Run {
  std::int64_t first, last;
};

// Marks the cells of the raster whose centres lie in an outline.
class Raster {
 public:
  Raster(std::span<const SitePolygon> outlines, double min_x, double min_y, double max_x, double max_y)
      : x_(cell(min_x)), y_(cell(min_y)), width_(cell(max_x) - x_ + 1), height_(cell(max_y) - y_ + 1) {
    inside_.resize(static_cast<std::size_t>(width_ * height_));
    for (const SitePolygon& outline : outlines) fill(outline);
    collect_runs();
  }
  // The runs of marked cells in a row, ascending.
  std::span<const Run> runs(std::int64_t row) const {
    row -= y_;
    if (row < 0 || row >= height_) return {};
    const std::size_t begin = first_[static_cast<std::size_t>(row)];
    return std::span(runs_).subspan(begin, first_[static_cast<std::size_t>(row) + 1] - begin);
  }
  static std::int64_t cell(double v) { return static_cast<std::int64_t>(std::floor(v / kShiftStep)); }

 private:
  // Fills an outline row by row, between the crossings of its edges.
  void fill(const SitePolygon& outline) {
    std::vector<double> crossings;
    for (std::int64_t row = 0; row < height_; ++row) {
      const double y = (static_cast<double>(y_ + row) + 0.5) * kShiftStep;
      crossings.clear();
      for (const auto& ring : outline) {
        for (std::size_t i = 0; i < ring.size(); ++i) {
          Point2 a = ring[i], b = ring[(i + 1) % ring.size()];
          if (a.y > b.y) std::swap(a, b);
          if (a.y * kMillimetre > y || y >= b.y * kMillimetre) continue;
          crossings.push_back(kMillimetre *
                              (a.x + (y / kMillimetre - a.y) * (b.x - a.x) / static_cast<double>(b.y - a.y)));
        }
      }
      std::sort(crossings.begin(), crossings.end());
      for (std::size_t i = 0; i + 1 < crossings.size(); i += 2) mark(row, crossings[i], crossings[i + 1]);
    }
  }
  void mark(std::int64_t row, double from, double to) {
    const std::int64_t first = std::max<std::int64_t>(0, cell(from + kShiftStep / 2) - x_);
    const std::int64_t last = std::min<std::int64_t>(width_ - 1, cell(to - kShiftStep / 2) - x_);
    for (std::int64_t column = first; column <= last; ++column)
      inside_[static_cast<std::size_t>(row * width_ + column)] = 1;
  }
  void collect_runs() {
    for (std::int64_t row = 0; row < height_; ++row) {
      first_.push_back(runs_.size());
      const auto begin = inside_.begin() + row * width_, end = begin + width_;
      for (auto from = std::find(begin, end, 1); from != end;) {
        const auto to = std::find(from, end, 0);
        runs_.push_back({x_ + (from - begin), x_ + (to - begin) - 1});
        from = std::find(to, end, 1);
      }
    }
    first_.push_back(runs_.size());
  }

  std::int64_t x_, y_, width_, height_;
  std::vector<std::uint8_t> inside_;
  std::vector<Run> runs_;           // row by row
  std::vector<std::size_t> first_;  // of each row; one more than there are rows
};

// For each shift in y: by how many more points the outlines contain at a shift in x than at the one before it.
using ShiftSteps = std::array<std::array<std::int64_t, kShifts + 1>, kShifts>;

// Adds a point: a run of cells contains it at all shifts of one stretch.
void add_point(const Raster& raster, std::int64_t column, std::int64_t row, ShiftSteps& steps) {
  for (int dy = -kShiftReach; dy <= kShiftReach; ++dy)
    for (const Run& run : raster.runs(row - dy)) {
      const std::int64_t first = std::max<std::int64_t>(column - run.last, -kShiftReach);
      const std::int64_t last = std::min<std::int64_t>(column - run.first, kShiftReach);
      if (first > last) continue;
      auto& in_x = steps[static_cast<std::size_t>(dy + kShiftReach)];
      ++in_x[static_cast<std::size_t>(first + kShiftReach)];
      --in_x[static_cast<std::size_t>(last + kShiftReach + 1)];
    }
}

}  // namespace

void count_shifts(std::span<const Vec3> points, std::span<const SitePolygon> outlines, ShiftCounts& counts) {
  if (outlines.empty() || outlines[0].empty()) return;
  const auto& ring = outlines[0][0];
  const auto [x0, x1] = std::minmax_element(ring.begin(), ring.end(), [](Point2 a, Point2 b) { return a.x < b.x; });
  const auto [y0, y1] = std::minmax_element(ring.begin(), ring.end(), [](Point2 a, Point2 b) { return a.y < b.y; });
  // Derived: the farthest shift that is tried.
  constexpr double kReach = kShiftReach * kShiftStep;
  const double min_x = x0->x * kMillimetre - kReach, max_x = x1->x * kMillimetre + kReach;
  const double min_y = y0->y * kMillimetre - kReach, max_y = y1->y * kMillimetre + kReach;
  const Raster raster(outlines, min_x - kReach, min_y - kReach, max_x + kReach, max_y + kReach);
  ShiftSteps steps{};
  for (const Vec3 p : points) {
    if (p.x < min_x || p.x > max_x || p.y < min_y || p.y > max_y) continue;
    ++counts.points;
    add_point(raster, Raster::cell(p.x), Raster::cell(p.y), steps);
  }
  std::size_t shift = 0;
  for (const auto& in_x : steps) {
    std::int64_t inside = 0;
    for (std::size_t x = 0; x + 1 < in_x.size(); ++x) {
      inside += in_x[x];
      counts.inside[shift++] += static_cast<std::uint64_t>(inside);
    }
  }
}

void add(ShiftCounts& sum, const ShiftCounts& counts) {
  for (std::size_t i = 0; i < sum.inside.size(); ++i) sum.inside[i] += counts.inside[i];
  sum.points += counts.points;
}

Misalignment misalignment_of(const ShiftCounts& counts) {
  if (counts.points == 0) return {};
  const auto at = [&](int dx, int dy) {
    return counts.inside[static_cast<std::size_t>((dy + kShiftReach) * kShifts + dx + kShiftReach)];
  };
  int best_x = 0, best_y = 0;
  for (int dy = -kShiftReach; dy <= kShiftReach; ++dy) {
    for (int dx = -kShiftReach; dx <= kShiftReach; ++dx) {
      const bool shorter = dx * dx + dy * dy < best_x * best_x + best_y * best_y;
      if (at(dx, dy) > at(best_x, best_y) || (at(dx, dy) == at(best_x, best_y) && shorter)) best_x = dx, best_y = dy;
    }
  }
  const auto share = [&](int dx, int dy) {
    return static_cast<double>(at(dx, dy)) / static_cast<double>(counts.points);
  };
  return {best_x * kShiftStep, best_y * kShiftStep, share(0, 0), share(best_x, best_y)};
}

}  // namespace ilot
