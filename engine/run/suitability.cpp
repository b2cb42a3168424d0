// SPDX-License-Identifier: Apache-2.0
#include "engine/run/suitability.h"

#include <fmt/format.h>

#include "engine/formats/crs.h"
#include "engine/run/products.h"

namespace ilot {
namespace {

constexpr double kMostStep = 10, kLeastStep = 1e-4;  // metres

// What no product can work with.
std::optional<std::string> hindrance(const CloudInfo& info, const CloudMeasure& m) {
  if (believed_crs(info, m).geographic) return "the coordinates are degrees: run --to-crs utm projects them";
  if (m.points < 3) return "fewer than three points";
  if (m.sampling_step == 0) return "all points are at one place";
  if (m.sampling_step > kMostStep) return fmt::format("{:.3g} m between points, 10 m at most", m.sampling_step);
  return std::nullopt;
}

}  // namespace

Crs believed_crs(const CloudInfo& info, const CloudMeasure& m) {
  const Vec3 middle = 0.5 * (m.min + m.max);
  return m.points == 0 || can_be_at(info.crs, middle) ? info.crs : Crs{};
}

std::optional<std::string> doubt_about_step(const CloudMeasure& m) {
  if (m.points < 2) return std::nullopt;
  if (m.sampling_step == 0) return "all points are at one place";
  if (m.sampling_step > kMostStep || m.sampling_step < kLeastStep)
    return fmt::format("{:.3g} m between points: is the unit right? (--crs EPSG:n says it)", m.sampling_step);
  return std::nullopt;
}

std::vector<ProductSuitability> suitability(const CloudInfo& info, const CloudMeasure& m) {
  const auto why = hindrance(info, m);
  std::vector<ProductSuitability> all;
  for (const Product* product : all_products())
    all.push_back({product->name, why ? Suitability{false, *why} : product->suitability(info, m)});
  return all;
}

}  // namespace ilot
