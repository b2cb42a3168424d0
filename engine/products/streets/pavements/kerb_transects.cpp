// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/pavements/kerb_transects.h"

#include <algorithm>
#include <cmath>

#include "kernels/geometry/flat.h"

namespace ilot {
namespace {

// Choice: vertices of a kerb are means over a metre, and so is its direction.
constexpr double kChord = 1;  // metres along the kerb on both sides
// Choice: a few segments are in a cell.
constexpr double kCell = 5;  // metres, of the lookup

std::int64_t cell_of(double v) {
  return static_cast<std::int64_t>(std::floor(v / kCell));
}

// A line by its length in plan.
class MeasuredLine {
 public:
  explicit MeasuredLine(std::span<const Vec3> line) : line_(line) {
    for (std::size_t i = 0; i < line.size(); ++i)
      length_.push_back(
          i == 0 ? 0 : length_.back() + norm(FlatPoint{line[i].x - line[i - 1].x, line[i].y - line[i - 1].y}));
  }
  double length() const { return length_.empty() ? 0 : length_.back(); }
  Vec3 at(double s) const {
    const auto i =
        static_cast<std::size_t>(std::lower_bound(length_.begin() + 1, length_.end() - 1, s) - length_.begin());
    const double piece = length_[i] - length_[i - 1];
    const double share = piece > 0 ? std::clamp((s - length_[i - 1]) / piece, 0.0, 1.0) : 0;
    return line_[i - 1] + share * (line_[i] - line_[i - 1]);
  }

 private:
  std::span<const Vec3> line_;
  std::vector<double> length_;
};

// Adds the transect at a place, but none where the line has no direction.
void add_transect(const MeasuredLine& line, double s, std::vector<Transect>& all, std::uint32_t number) {
  const Vec3 way = line.at(std::min(line.length(), s + kChord)) - line.at(std::max(0.0, s - kChord));
  const double length = norm(FlatPoint{way.x, way.y});
  if (length > 0) all.push_back({number, line.at(s), -way.y / length, way.x / length, s});
}

}  // namespace

std::vector<Transect> transects_along(std::span<const Vec3> line, double spacing) {
  std::vector<Transect> all;
  if (line.size() < 2) return all;
  const MeasuredLine measured(line);
  for (std::uint32_t k = 0; (k + 0.5) * spacing <= measured.length(); ++k)
    add_transect(measured, (k + 0.5) * spacing, all, k + 1);
  return all;
}

std::vector<Transect> transects_over(std::span<const Vec3> line, double spacing) {
  std::vector<Transect> all;
  if (line.size() < 2) return all;
  const MeasuredLine measured(line);
  const auto steps = static_cast<std::uint32_t>(std::ceil(measured.length() / spacing));
  for (std::uint32_t k = 0; k <= steps; ++k)
    add_transect(measured, steps > 0 ? measured.length() * k / steps : 0, all, k + 1);
  return all;
}

KerbLookup::KerbLookup(std::span<const std::vector<Vec3>> lines) {
  for (std::size_t k = 0; k < lines.size(); ++k)
    for (std::size_t i = 0; i + 1 < lines[k].size(); ++i) {
      const Vec3 a = lines[k][i], b = lines[k][i + 1];
      for (std::int64_t v = cell_of(std::min(a.y, b.y)); v <= cell_of(std::max(a.y, b.y)); ++v)
        for (std::int64_t u = cell_of(std::min(a.x, b.x)); u <= cell_of(std::max(a.x, b.x)); ++u)
          cells_[{u, v}].push_back(segments_.size());
      segments_.push_back({a.x, a.y, b.x - a.x, b.y - a.y, k});
    }
}

KerbAhead KerbLookup::next(double x, double y, double dx, double dy, double from, double reach) const {
  KerbAhead nearest;
  const double end_x = x + reach * dx, end_y = y + reach * dy;
  for (std::int64_t v = cell_of(std::min(y, end_y)); v <= cell_of(std::max(y, end_y)); ++v)
    for (std::int64_t u = cell_of(std::min(x, end_x)); u <= cell_of(std::max(x, end_x)); ++u) {
      const auto found = cells_.find({u, v});
      if (found == cells_.end()) continue;
      for (const std::size_t i : found->second) {
        const Segment& s = segments_[i];
        const double turn = dx * s.dy - dy * s.dx;
        if (turn == 0) continue;
        const double distance = ((s.x - x) * s.dy - (s.y - y) * s.dx) / turn;
        const double along = ((s.x - x) * dy - (s.y - y) * dx) / turn;
        if (!(distance > from && distance <= reach && along >= 0 && along <= 1)) continue;
        if (std::pair(distance, s.line) < std::pair(nearest.distance, nearest.line))
          nearest = {distance, s.line, turn < 0};
      }
    }
  return nearest;
}

}  // namespace ilot
