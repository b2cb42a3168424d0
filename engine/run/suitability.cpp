// SPDX-License-Identifier: Apache-2.0
#include "engine/run/suitability.h"

#include <fmt/format.h>

#include "engine/formats/crs.h"

namespace ilot {
namespace {

constexpr double kMostStep = 10, kLeastStep = 1e-4;        // metres
constexpr double kLeastRoofDensity = 1;                    // last returns a square metre: a hundred on a small house
constexpr double kMostFacadeStep = 0.1;                    // metres: ten points across a window of a metre
constexpr double kMostStreetStep = 0.5;                    // metres: a bollard or a car's roof gets a few points
constexpr std::size_t kBuilding = 6, kBuildingParts = 67;  // class codes of the standard

// What no product can work with.
std::optional<std::string> hindrance(const CloudInfo& info, const CloudMeasure& m) {
  if (believed_crs(info, m).geographic) return "the coordinates are degrees: run --to-crs utm projects them";
  if (m.points < 3) return "fewer than three points";
  if (m.sampling_step == 0) return "all points are at one place";
  if (m.sampling_step > kMostStep) return fmt::format("{:.3g} m between points, 10 m at most", m.sampling_step);
  return std::nullopt;
}

std::string step_text(const CloudMeasure& m) {
  return fmt::format("{:.3g} m between points", m.sampling_step);
}

Suitability of_roofs(const CloudInfo& info, const CloudMeasure& m) {
  const std::string density = fmt::format("{:.3g} last returns/m2", m.last_return_density);
  if (!info.stations.empty()) return {"roofs", false, "scanned from stations on the ground, which see few roofs"};
  if (m.last_return_density < kLeastRoofDensity) return {"roofs", false, density + ", 1 at least"};
  if (m.classes[kBuilding] + m.classes[kBuildingParts] > 0)
    return {"roofs", true, density + ", class 6 says what buildings are"};
  return {"roofs", true, density + ", no point of class 6: buildings are found by shape or from --footprints"};
}

Suitability of_facades(const CloudInfo& info, const CloudMeasure& m) {
  if (m.sampling_step > kMostFacadeStep) return {"facades", false, step_text(m) + ", 0.1 m at most"};
  if (info.stations.empty()) return {"facades", true, step_text(m) + "; shadows need --stations"};
  return {"facades", true, step_text(m) + fmt::format(", {} stations known", info.stations.size())};
}

Suitability of_streets(const CloudMeasure& m) {
  if (m.sampling_step > kMostStreetStep) return {"streets", false, step_text(m) + ", 0.5 m at most"};
  return {"streets", true, step_text(m)};
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

std::array<Suitability, 4> suitability(const CloudInfo& info, const CloudMeasure& m) {
  if (const auto why = hindrance(info, m))
    return {{{"planes", false, *why}, {"roofs", false, *why}, {"facades", false, *why}, {"streets", false, *why}}};
  return {{{"planes", true, step_text(m)}, of_roofs(info, m), of_facades(info, m), of_streets(m)}};
}

}  // namespace ilot
