// SPDX-License-Identifier: Apache-2.0
#include "engine/run/suitability.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/formats/crs.h"
#include "engine/report/progress.h"
#include "engine/run/products.h"

namespace ilot {
namespace {

constexpr double kMostStep = 10, kLeastStep = 1e-4;  // metres

// Returns the reason why no product can work, if there is one.
std::optional<std::string> hindrance(const CloudInfo& info, const CloudMeasure& m) {
  if (assumed_crs(info, m).geographic) return "the coordinates are degrees: run --to-crs utm projects them";
  if (m.points < 3) return "fewer than three points";
  if (m.sampling_step == 0) return "all points are at one place";
  if (m.sampling_step > kMostStep) return fmt::format("{:.3g} m between points, 10 m at most", m.sampling_step);
  return std::nullopt;
}

// Formats other than LAS and LAZ have no header block for the comparison.
bool box_differs(const CloudInfo& info, const CloudMeasure& m) {
  if (info.header.empty()) return false;
  const auto off = [&](double declared, double measured, std::size_t axis) {
    return !(std::abs(declared - measured) <= 1.5 * info.layout.scale[axis]);
  };
  return off(info.declared_min.x, m.all_min.x, 0) || off(info.declared_min.y, m.all_min.y, 1) ||
         off(info.declared_min.z, m.all_min.z, 2) || off(info.declared_max.x, m.all_max.x, 0) ||
         off(info.declared_max.y, m.all_max.y, 1) || off(info.declared_max.z, m.all_max.z, 2);
}

}  // namespace

Crs assumed_crs(const CloudInfo& info, const CloudMeasure& m) {
  const Vec3 middle = 0.5 * (m.min + m.max);
  return m.points == 0 || can_be_at(info.crs, middle) ? info.crs : Crs{};
}

std::optional<std::string> step_warning(const CloudMeasure& m) {
  if (m.points < 2) return std::nullopt;
  if (m.sampling_step == 0) return "all points are at one place";
  if (m.sampling_step > kMostStep || m.sampling_step < kLeastStep)
    return fmt::format("{:.3g} m between points: is the unit right? (--crs EPSG:n says it)", m.sampling_step);
  return std::nullopt;
}

std::vector<CloudSuitability> suitability(const CloudInfo& info, const CloudMeasure& m) {
  const auto why = hindrance(info, m);
  std::vector<CloudSuitability> all;
  for (const Product* product : all_products()) {
    const Suitability suits = why ? Suitability{false, *why} : product->suitability(info, m);
    all.push_back({product->name, suits.yes, suits.reason});
  }
  return all;
}

void warn_of_unsuited(const std::vector<std::string>& products, const RunInputs& inputs, const CloudMeasure& measure,
                      Progress& progress, RunRecord& record) {
  CloudInfo info;
  info.crs = inputs.crs;
  info.stations = inputs.stations;
  for (const CloudSuitability& s : suitability(info, measure)) {
    if (s.yes || std::find(products.begin(), products.end(), s.product) == products.end()) continue;
    record.warnings.push_back(s.product + ": the cloud does not suit it: " + s.reason);
    progress.warn(record.warnings.back());
  }
}

std::vector<std::string> cloud_warnings(const CloudInfo& info, const CloudMeasure& m) {
  std::vector<std::string> list = info.warnings;
  if (m.points > 0 && box_differs(info, m)) list.push_back("the header's box is not that of the points");
  if (m.strays > 0)
    list.push_back(grouped(m.strays) + (m.strays == 1 ? " point stands alone" : " points stand alone") +
                   ", far from all others; a run leaves such points out, index.keep_strays keeps them");
  if (m.rejected > 0) list.push_back(fmt::format("{} points have unusable coordinates", m.rejected));
  if (info.points < info.declared_points) {
    list.push_back(fmt::format("{} of {} points can be read", info.points, info.declared_points));
  }
  if (const auto doubt = step_warning(m)) list.push_back(*doubt);
  if (info.crs.geographic && !assumed_crs(info, m).geographic)
    list.push_back(
        fmt::format("it says degrees, which x = {:.3f} cannot be: metres in an unknown CRS are assumed", m.min.x));
  if (info.crs.unit_assumed) list.push_back("nothing says what the unit is: metres are assumed");
  return list;
}

}  // namespace ilot
