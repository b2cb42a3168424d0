// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/point_labels.h"

#include <algorithm>
#include <cmath>

namespace ilot {
namespace {

// Choice: roofs.most_epsilon; points beyond it are on no face.
constexpr double kReach = 0.3;  // metres
// Derived: a bound of memory.
constexpr double kMostCells = 1 << 16;

bool stands_at(double x, double y, double dx, double dy, Vec3 p) {
  const double px = p.x - x, py = p.y - y;
  const double along = std::clamp((px * dx + py * dy) / (dx * dx + dy * dy), 0.0, 1.0);
  const double off_x = px - along * dx, off_y = py - along * dy;
  return off_x * off_x + off_y * off_y <= kReach * kReach;
}

}  // namespace

PointLabeller::PointLabeller(const RoofSite& site, const RoofModel& model, double metres_per_unit)
    : level_(model.lod22.surfaces.empty() && !model.lod12.surfaces.empty()) {
  add_walls(site, model.lod22.surfaces.empty() ? model.lod12 : model.lod22, metres_per_unit);
  if (!walls_.empty()) map_walls();
}

void PointLabeller::add_walls(const RoofSite& site, const Building& building, double metres_per_unit) {
  for (const BuildingSurface& s : building.surfaces) {
    if (s.kind != SurfaceKind::wall || s.rings.empty()) continue;
    const auto at = [&](std::size_t n) {
      return metres_per_unit * (building.vertices[s.rings[0][n % s.rings[0].size()]] - site.anchor);
    };
    double top = -HUGE_VAL;
    for (std::size_t i = 0; i < s.rings[0].size(); ++i) top = std::max(top, at(i).z);
    for (std::size_t i = 0; i < s.rings[0].size(); ++i) {
      const Vec3 a = at(i), b = at(i + 1);
      if (a.x != b.x || a.y != b.y) walls_.push_back({a.x, a.y, b.x - a.x, b.y - a.y, top});
    }
  }
}

std::size_t PointLabeller::column(double x) const {
  return std::min(columns_ - 1, static_cast<std::size_t>((x - low_x_) / cell_));
}

std::size_t PointLabeller::row(double y) const {
  return std::min(rows_ - 1, static_cast<std::size_t>((y - low_y_) / cell_));
}

// Visits the cells that a wall's box and its surroundings meet.
template <class Visit>
void PointLabeller::for_each_cell(const Wall& w, const Visit& visit) const {
  const double x0 = std::min(w.x, w.x + w.dx) - kReach, x1 = std::max(w.x, w.x + w.dx) + kReach;
  const double y0 = std::min(w.y, w.y + w.dy) - kReach, y1 = std::max(w.y, w.y + w.dy) + kReach;
  for (std::size_t r = row(y0); r <= row(y1); ++r)
    for (std::size_t c = column(x0); c <= column(x1); ++c) visit(r * columns_ + c);
}

void PointLabeller::map_walls() {
  low_x_ = low_y_ = HUGE_VAL;
  high_x_ = high_y_ = -HUGE_VAL;
  for (const Wall& w : walls_) {
    low_x_ = std::min(low_x_, std::min(w.x, w.x + w.dx) - kReach);
    high_x_ = std::max(high_x_, std::max(w.x, w.x + w.dx) + kReach);
    low_y_ = std::min(low_y_, std::min(w.y, w.y + w.dy) - kReach);
    high_y_ = std::max(high_y_, std::max(w.y, w.y + w.dy) + kReach);
  }
  const double width = high_x_ - low_x_, height = high_y_ - low_y_;
  cell_ = std::max({1.0, std::sqrt(width * height / kMostCells), std::max(width, height) / kMostCells});
  columns_ = static_cast<std::size_t>(width / cell_) + 1;
  rows_ = static_cast<std::size_t>(height / cell_) + 1;
  near_ = lists_by_key(columns_ * rows_, walls_.size(),
                       [&](std::size_t i, const auto& take) { for_each_cell(walls_[i], take); });
}

PointLabel PointLabeller::label(Vec3 p, std::uint32_t face) const {
  if (face != 0) return PointLabel::roof;
  if (p.x >= low_x_ && p.x <= high_x_ && p.y >= low_y_ && p.y <= high_y_) {
    const std::size_t cell = row(p.y) * columns_ + column(p.x);
    for (const std::uint32_t i : near_.of(cell)) {
      const Wall& w = walls_[i];
      if (p.z <= w.top + kReach && stands_at(w.x, w.y, w.dx, w.dy, p)) return PointLabel::wall;
    }
  }
  return level_ ? PointLabel::roof : PointLabel::none;
}

}  // namespace ilot
