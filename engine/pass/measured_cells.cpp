// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/measured_cells.h"

#include <algorithm>

#include "engine/store/columns.h"
#include "engine/store/store.h"

namespace ilot {
namespace {

Vec3 metres(Index3 p, double step_metres) {
  return {static_cast<double>(p.x) * step_metres, static_cast<double>(p.y) * step_metres,
          static_cast<double>(p.z) * step_metres};
}

}  // namespace

MeasuredCells::MeasuredCells(const IndexBox& box, std::uint64_t points, double step_metres)
    : min_(metres(box.min, step_metres)),
      max_(metres(box.max, step_metres)),
      points_(points),
      step_metres_(step_metres),
      cells_(density_cells(min_, max_, static_cast<double>(points))),
      occupied_(cells_.columns * cells_.rows),
      windows_(step_windows(min_, max_, static_cast<double>(points)), min_, {1, 1, 1}) {}

void MeasuredCells::add(Index3 p) {
  const Vec3 at = metres(p, step_metres_);
  occupied_[cells_.cell(at)] = true;
  windows_.add(at);
}

void MeasuredCells::add_class(std::uint8_t code) {
  ++classes_[code];
}

void MeasuredCells::add_echoes(std::uint8_t echoes) {
  not_last_ += (echoes & kNotLastReturn) != 0;
}

void MeasuredCells::add(const MeasuredCells& next) {
  windows_.add(next.windows_);
  not_last_ += next.not_last_;
  for (std::size_t c = 0; c < occupied_.size(); ++c)
    if (next.occupied_[c]) occupied_[c] = true;
  for (std::size_t c = 0; c < classes_.size(); ++c) classes_[c] += next.classes_[c];
}

CloudMeasure MeasuredCells::measure() {
  CloudMeasure m;
  m.points = points_;
  m.min = m.all_min = min_;
  m.max = m.all_max = max_;
  m.classes = classes_;
  m.last_returns = points_ - not_last_;
  const auto full = static_cast<double>(std::count(occupied_.begin(), occupied_.end(), true));
  m.occupied_area = full * cells_.side * cells_.side;
  m.density = static_cast<double>(points_) / m.occupied_area;
  m.last_return_density = static_cast<double>(m.last_returns) / m.occupied_area;
  m.sampling_step = windows_.median_step();
  return m;
}

}  // namespace ilot
