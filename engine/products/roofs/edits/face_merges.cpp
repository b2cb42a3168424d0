// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/edits/face_merges.h"

#include <algorithm>
#include <cmath>

#include "engine/products/product_edits.h"
#include "kernels/geometry/ring.h"

namespace ilot {
namespace {

struct GridPlace {
  std::int64_t x, y;  // mm
};

// The sites whose outline contains the place, ascending.
std::vector<std::uint32_t> sites_at(GridPlace p, std::span<const PlannedSite> sites, const OutlineMap& map) {
  std::vector<std::uint32_t> at;
  for (const std::uint32_t i : map.near({p.x, p.y, p.x, p.y})) {
    const PlacedOutline& outline = sites[i].outline;
    const Point2 own{static_cast<std::int32_t>(p.x - outline.x), static_cast<std::int32_t>(p.y - outline.y)};
    bool inside = false;
    for (const auto& ring : outline.polygon) inside ^= contains(ring, own);
    if (inside) at.push_back(i);
  }
  return at;
}

}  // namespace

std::vector<PlannedMerge> plan_merges(std::span<const Edit> edits, std::span<const PlannedSite> sites,
                                      const OutlineMap& map, double metres_per_unit) {
  std::vector<PlannedMerge> merges;
  for (const Edit* edit : edits_of(edits, "roofs")) {
    if (edit->action != EditAction::merged) continue;
    PlannedMerge& merge = merges.emplace_back();
    merge.edit = edit;
    const auto place = [&](Vec3 p) {
      return GridPlace{std::llround(p.x * metres_per_unit / kGridMetres),
                       std::llround(p.y * metres_per_unit / kGridMetres)};
    };
    const GridPlace a = place(edit->at[0]), b = place(edit->at[1]);
    const std::vector<std::uint32_t> at_a = sites_at(a, sites, map), at_b = sites_at(b, sites, map);
    const auto both = std::ranges::find_if(at_a, [&](std::uint32_t i) { return std::ranges::count(at_b, i) > 0; });
    if (both == at_a.end()) {
      merge.reason = at_a.empty() || at_b.empty() ? "no outline of a building contains both places of this edit"
                                                  : "the places of this edit lie in two buildings";
      continue;
    }
    merge.site = *both;
    const PlacedOutline& outline = sites[*both].outline;
    const auto seen = [&](GridPlace p) {
      return FlatPoint{static_cast<double>(p.x - outline.x) * kGridMetres,
                       static_cast<double>(p.y - outline.y) * kGridMetres};
    };
    merge.places = {seen(a), seen(b)};
  }
  return merges;
}

std::vector<FaceMerge> merges_of(std::span<const PlannedMerge> merges, std::size_t site) {
  std::vector<FaceMerge> own;
  for (const PlannedMerge& merge : merges)
    if (merge.site == site) own.push_back(merge.places);
  return own;
}

}  // namespace ilot
