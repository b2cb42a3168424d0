// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/streets/carriageway_areas.h"

#include <algorithm>

#include "engine/flat_area.h"

namespace ilot {
namespace {

std::vector<FlatPoint> in_metres(const std::vector<Vec3>& ring, double metres_per_unit) {
  std::vector<FlatPoint> out;
  for (const Vec3& p : ring) out.push_back({p.x * metres_per_unit, p.y * metres_per_unit});
  return out;
}

constexpr double kBeforeKerb = 0.5;  // metres

}  // namespace

CarriagewayResult evaluate_carriageways(const KerbSight& sight, std::span<const TrueCarriageway> truth,
                                        std::span<const Carriageway> found, double metres_per_unit) {
  std::vector<FlatPolygon> roads, drawn;
  for (const TrueCarriageway& piece : truth) roads.push_back({in_metres(piece.ring, metres_per_unit), {}});
  for (const Carriageway& c : found) {
    drawn.push_back({in_metres(c.ring, metres_per_unit), {}});
    for (const auto& hole : c.holes) drawn.back().holes.push_back(in_metres(hole, metres_per_unit));
  }
  CarriagewayResult result;
  const FlatArea all(drawn);
  result.found = found.size();
  result.found_m2 = all.area();
  if (result.found_m2 > 0) result.correct = all.common_area(FlatArea(roads)) / result.found_m2;
  double complete = 0;
  for (const KerbSight::Place& place : sight.places()) {
    if (!place.is_seen()) continue;
    result.true_m += place.length_m;
    const FlatPoint at{place.at.x * metres_per_unit, place.at.y * metres_per_unit};
    const FlatPoint aside{-kBeforeKerb * place.along_y, kBeforeKerb * place.along_x};
    const auto begins = [&](const FlatPolygon& road) {
      return contains(road, at + aside) || contains(road, at - aside);
    };
    if (std::any_of(drawn.begin(), drawn.end(), begins)) complete += place.length_m;
  }
  if (result.true_m > 0) result.complete = complete / result.true_m;
  return result;
}

}  // namespace ilot
