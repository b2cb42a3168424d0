// SPDX-License-Identifier: Apache-2.0
// Small buildings with points on known planes.
#pragma once
#include <functional>

#include "engine/products/roofs/sites/roof_site.h"
#include "engine/validity/validity.h"
#include "kernels/core/rng.h"

namespace ilot::test {

// Relative to the anchor, in metres.
inline SitePolygon rectangle(double width, double depth) {
  const auto w = static_cast<std::int32_t>(width * 1000), d = static_cast<std::int32_t>(depth * 1000);
  return {{{0, 0}, {w, 0}, {w, d}, {0, d}}};
}

// Returns a site with about `density` points per square metre over a rectangle, on the surface. The noise is uniformly
// distributed and has the given standard deviation.
inline RoofSite roof_site(double width, double depth, const std::function<double(double, double)>& height,
                          double density = 10, double noise = 0.02) {
  RoofSite site;
  site.id = "house";
  site.anchor = {85000, 446000, 0};
  site.outline = rectangle(width, depth);
  Rng rng(11);
  for (auto n = static_cast<std::uint64_t>(density * width * depth); n-- > 0;) {
    const double x = width * rng.uniform(), y = depth * rng.uniform();
    site.points.push_back({x, y, height(x, y) + noise * 3.4641 * (rng.uniform() - 0.5)});
  }
  return site;
}

// Whether val3dity's checks find no fault in the solid.
inline bool valid(const Building& b) {
  return validate_building(b, b.vertices.front(), 0.0001).empty();
}

}  // namespace ilot::test
