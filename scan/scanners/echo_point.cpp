// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/echo_point.h"

#include <algorithm>
#include <cmath>

namespace ilot::scan {

ColouredPoint echo_point(const std::vector<Echo>& echoes, std::size_t number, const SurfaceLabel& label, const Ray& ray,
                         double full_range, double unmixed) {
  const Echo& echo = echoes[number];
  ColouredPoint point;
  point.material = static_cast<std::uint8_t>(1 + static_cast<std::uint8_t>(label.material));
  point.rgb = colour(label.material, point_at(ray, echo.surface_range));
  const double share = echo.energy * full_range * full_range / (echo.range * echo.range);
  point.intensity = static_cast<std::uint16_t>(65535 * std::min(1.0, share));
  point.return_number = static_cast<std::uint8_t>(number + 1);
  point.return_count = static_cast<std::uint8_t>(echoes.size());
  // If the noise is larger than the effect of mixing, the point belongs to its main surface.
  if (std::abs(echo.range - echo.surface_range) <= unmixed) {
    point.true_class = label.true_class;
    point.true_plane = label.plane;
    point.true_element = label.element;
  } else {
    point.true_class = kMixedClass;
  }
  return point;
}

void PointTally::count(std::vector<std::uint64_t>& list, std::uint32_t id, std::uint64_t by) {
  if (id >= list.size()) list.resize(id + 1);
  list[id] += by;
}

void PointTally::add(const RecordTruth& truth) {
  ++points;
  ++classes[truth.true_class];
  count(planes, truth.true_plane);
  count(elements, truth.true_element);
}

void PointTally::add(std::span<const std::byte> records, const RecordLayout& layout) {
  for (std::size_t at = 0; at < records.size(); at += layout.record_length) add(truth_of(&records[at], layout));
}

}  // namespace ilot::scan
