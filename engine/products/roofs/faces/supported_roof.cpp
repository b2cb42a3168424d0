// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/faces/supported_roof.h"

#include <algorithm>

namespace ilot {
namespace {

// Returns per label its new number: 0 for planes without a point in the outline.
std::vector<std::uint32_t> numbers_of_supported(const RoofPlanes& planes, std::size_t inside) {
  std::vector<std::uint32_t> number(planes.planes.size() + 1, 0);
  for (std::size_t i = 0; i < inside; ++i) number[planes.of_point[i]] = 1;
  number[0] = 0;
  std::uint32_t last = 0;
  for (std::uint32_t& n : number) n = n == 0 ? 0 : ++last;
  return number;
}

}  // namespace

SupportedRoof supported_roof(const RoofSite& site, const RoofModelParams& params) {
  SupportedRoof roof{site, {}, {}};
  const std::size_t inside = site.points.size();
  RoofSite& own = roof.site;
  own.beside.clear();
  own.points.insert(own.points.end(), site.beside.begin(), site.beside.end());
  RoofPlanes& planes = roof.planes;
  planes = find_roof_planes(own, params);
  const std::vector<std::uint32_t> number = numbers_of_supported(planes, inside);
  for (std::uint32_t& label : planes.of_point) label = number[label];
  for (std::size_t p = planes.planes.size(); p > 0; --p)
    if (number[p] == 0) planes.planes.erase(planes.planes.begin() + static_cast<std::ptrdiff_t>(p - 1));
  std::size_t kept = inside;
  for (std::size_t i = inside; i < own.points.size(); ++i) {
    if (planes.of_point[i] == 0) continue;
    roof.beside.push_back(static_cast<std::uint32_t>(i - inside));
    own.points[kept] = own.points[i];
    planes.of_point[kept] = planes.of_point[i];
    planes.on_wall[kept++] = planes.on_wall[i];
  }
  own.points.resize(kept);
  planes.of_point.resize(kept);
  planes.on_wall.resize(kept);
  return roof;
}

std::vector<std::uint32_t> of_given_points(const RoofSite& given, const SupportedRoof& roof,
                                           std::span<const std::uint32_t> values) {
  const std::size_t inside = given.points.size();
  std::vector<std::uint32_t> all(inside + given.beside.size(), 0);
  std::copy_n(values.begin(), std::min(values.size(), inside), all.begin());
  for (std::size_t i = 0; i < roof.beside.size() && inside + i < values.size(); ++i)
    all[inside + roof.beside[i]] = values[inside + i];
  return all;
}

}  // namespace ilot
