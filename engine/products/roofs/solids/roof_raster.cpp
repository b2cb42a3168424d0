// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/solids/roof_raster.h"

#include <algorithm>
#include <cmath>

#include "engine/products/roofs/sites/outline_repair.h"
#include "kernels/geometry/flat_box.h"

namespace ilot {
namespace {

// Choice: half a metre squared, the least area of a roof face.
constexpr double kLeastCell = 0.5;  // metres
// Choice: four points of a cloud of one point per square metre; a sparser cloud leaves roofs bare.
constexpr double kSeenWithin = 1;  // metres between a roof and a point that has seen it
// Derived: two steps contain four points on average, so a cell without a point is a gap.
constexpr double kCellSteps = 2;
// Derived: a bound of memory, 2 MiB.
constexpr double kMostRasterCells = 1u << 16;

double cell_width(const RoofSite& site, const FlatBox& box) {
  const double area = area_of(site.outline), points = static_cast<double>(std::max<std::size_t>(site.points.size(), 1));
  const double all = (box.max.x - box.min.x + 2) * (box.max.y - box.min.y + 2);
  return std::max({kLeastCell, kCellSteps * std::sqrt(area / points), std::sqrt(all / kMostRasterCells)});
}

}  // namespace

RoofRaster::RoofRaster(const RoofSite& site, const RoofModel& model, double level) {
  FlatBox box = FlatBox::none();
  for (const auto& ring : site.outline)
    for (const Point2 v : ring) box.add({v.x / 1000.0, v.y / 1000.0});
  if (site.outline.empty()) return;
  width_ = cell_width(site, box);
  reach_ = std::max(kSeenWithin, width_);
  low_x_ = box.min.x - kSeenWithin;
  low_y_ = box.min.y - kSeenWithin;
  columns_ = static_cast<std::int64_t>((box.max.x + kSeenWithin - low_x_) / width_) + 1;
  rows_ = static_cast<std::int64_t>((box.max.y + kSeenWithin - low_y_) / width_) + 1;
  cells_.assign(static_cast<std::size_t>(columns_ * rows_), {NAN, -HUGE_VAL});
  std::vector<FlatPoint> centres;
  for (std::int64_t r = 0; r < rows_; ++r)
    for (std::int64_t c = 0; c < columns_; ++c)
      centres.push_back({(low_x_ + (static_cast<double>(c) + 0.5) * width_) * 1000,
                         (low_y_ + (static_cast<double>(r) + 0.5) * width_) * 1000});
  const bool faces = !model.map.planes.empty();
  const std::vector<std::uint32_t> regions = regions_of(faces ? model.map.faces : part(site.outline, {}), centres);
  for (std::size_t i = 0; i < cells_.size(); ++i)
    if (regions[i] != kOutside)
      cells_[i].roof = faces ? model.map.planes[regions[i] - 1].at(centres[i].x / 1000, centres[i].y / 1000) : level;
}

// What lies before the raster is cut to 0, so that rounding towards 0 does.
std::int64_t RoofRaster::column(double x) const {
  return std::clamp(static_cast<std::int64_t>((x - low_x_) / width_), std::int64_t{0}, columns_ - 1);
}

std::int64_t RoofRaster::row(double y) const {
  return std::clamp(static_cast<std::int64_t>((y - low_y_) / width_), std::int64_t{0}, rows_ - 1);
}

void RoofRaster::add(Vec3 p, bool off) {
  if (cells_.empty()) return;
  Cell& own = cells_[static_cast<std::size_t>(row(p.y) * columns_ + column(p.x))];
  if (off && own.off < 0x7fffffffu) ++own.off;
  if (!off && own.on < 0xffffffffu) ++own.on;
  const std::int64_t first = column(p.x - reach_), last = column(p.x + reach_), last_row = row(p.y + reach_);
  for (std::int64_t r = row(p.y - reach_); r <= last_row; ++r)
    for (std::int64_t c = first; c <= last; ++c) {
      Cell& cell = cells_[static_cast<std::size_t>(r * columns_ + c)];
      if (cell.seen != 0 && cell.highest >= p.z) continue;  // the point changes nothing
      const double dx = p.x - (low_x_ + (static_cast<double>(c) + 0.5) * width_);
      const double dy = p.y - (low_y_ + (static_cast<double>(r) + 0.5) * width_);
      const double flat2 = dx * dx + dy * dy, dz = p.z - cell.roof;
      if (flat2 <= reach_ * reach_) cell.highest = std::max(cell.highest, p.z);
      if (flat2 + dz * dz <= kSeenWithin * kSeenWithin) cell.seen = 1;
    }
}

double RoofRaster::bare_share() const {
  std::size_t roof = 0, bare = 0;
  for (const Cell& c : cells_) {
    if (std::isnan(c.roof)) continue;
    ++roof;
    bare += c.seen == 0;
  }
  return roof == 0 ? 0 : static_cast<double>(bare) / static_cast<double>(roof);
}

double RoofRaster::largest_off() const {
  std::vector<std::uint8_t> done(cells_.size(), 0);
  std::vector<std::size_t> open;
  std::size_t largest = 0;
  for (std::size_t first = 0; first < cells_.size(); ++first) {
    if (done[first] || !is_off(first)) continue;
    done[first] = 1;
    open.assign(1, first);
    for (std::size_t next = 0; next < open.size(); ++next) {
      const auto r = static_cast<std::int64_t>(open[next]) / columns_,
                 c = static_cast<std::int64_t>(open[next]) % columns_;
      for (std::int64_t y = std::max<std::int64_t>(r - 1, 0); y <= std::min(r + 1, rows_ - 1); ++y)
        for (std::int64_t x = std::max<std::int64_t>(c - 1, 0); x <= std::min(c + 1, columns_ - 1); ++x) {
          const auto cell = static_cast<std::size_t>(y * columns_ + x);
          if (done[cell] || !is_off(cell)) continue;
          done[cell] = 1;
          open.push_back(cell);
        }
    }
    largest = std::max(largest, open.size());
  }
  return static_cast<double>(largest) * width_ * width_;
}

double RoofRaster::overshoot() const {
  double most = 0;
  for (const Cell& c : cells_)
    if (!std::isnan(c.roof) && c.highest > -HUGE_VAL) most = std::max(most, c.roof - c.highest);
  return most;
}

}  // namespace ilot
