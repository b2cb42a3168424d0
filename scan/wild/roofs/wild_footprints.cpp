// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "scan/roofs/roof_styles.h"
#include "scan/unit.h"
#include "scan/wild/roofs/wild_roofs_scan.h"

namespace ilot::scan {
namespace {

const RoofFace& floor_of(const RoofBuilding& building) {
  return *std::find_if(building.solid.faces.begin(), building.solid.faces.end(),
                       [](const RoofFace& f) { return f.part == RoofPart::floor; });
}

WildFootprint own_outline(const RoofBuilding& building, std::uint32_t id) {
  WildFootprint footprint{id, {id}, {}};
  for (const auto& ring : floor_of(building).rings) {
    std::vector<Vec3> places;
    for (const std::uint32_t i : ring) places.push_back(building.frame.to_town(building.solid.vertices[i]));
    std::reverse(places.begin(), places.end());
    footprint.rings.push_back(std::move(places));
  }
  return footprint;
}

// Returns one outline around the boxes of houses that stand side by side along u.
WildFootprint merged_outline(const RoofTown& town, const std::vector<std::uint32_t>& ids) {
  WildFootprint footprint{ids[0], ids, {}};
  const RoofFrame& frame = town.buildings[ids[0] - 1].frame;
  std::vector<Vec3> front, back;
  const auto push = [&](std::vector<Vec3>& chain, Integer u, Integer v) {
    const Vec3 p{kUnit * static_cast<double>(u), kUnit * static_cast<double>(v), 0};
    if (!chain.empty() && norm(chain.back() - p) < 1e-6) return;
    const std::size_t n = chain.size();
    if (n > 1 && chain[n - 1].y == p.y && chain[n - 2].y == p.y) chain.pop_back();
    chain.push_back(p);
  };
  for (const std::uint32_t id : ids) {
    const GridRect box = bounds_of(town.buildings[id - 1].wings);
    push(front, box.u0, box.v0), push(front, box.u1, box.v0);
    push(back, box.u0, box.v1), push(back, box.u1, box.v1);
  }
  std::vector<Vec3> ring = front;
  ring.insert(ring.end(), back.rbegin(), back.rend());
  for (Vec3& p : ring) p = frame.to_town(p);
  footprint.rings.push_back(std::move(ring));
  return footprint;
}

// Houses of a terrace adjoin where one was not left out between them.
bool adjoin(const RoofTown& town, std::uint32_t a, std::uint32_t b) {
  const GridRect first = bounds_of(town.buildings[a - 1].wings), second = bounds_of(town.buildings[b - 1].wings);
  return first.u1 == second.u0 && first.v0 < second.v1 && second.v0 < first.v1;
}

}  // namespace

std::vector<WildFootprint> draw_footprints(const WildRoofTown& wild, Draws& draws) {
  std::vector<WildFootprint> all;
  const auto count = static_cast<std::uint32_t>(wild.town.buildings.size());
  for (std::uint32_t id = 1; id <= count;) {
    std::vector<std::uint32_t> ids{id};
    while (id + ids.size() <= count && wild.group[id + ids.size() - 1] == wild.group[id - 1] &&
           adjoin(wild.town, ids.back(), id + static_cast<std::uint32_t>(ids.size())))
      ids.push_back(id + static_cast<std::uint32_t>(ids.size()));
    const bool merged = ids.size() > 1 && draws.happens("roofs.footprints_merged", id);
    if (!merged) ids.resize(1);
    if (!draws.happens("roofs.footprints_missing", id))
      all.push_back(merged ? merged_outline(wild.town, ids) : own_outline(wild.town.buildings[id - 1], id));
    id += static_cast<std::uint32_t>(ids.size());
  }
  Rng common = draws.random("roofs.footprints_shift");
  const double shift = draws.number("roofs.footprints_shift"), own = draws.number("roofs.footprints_error");
  const SinCos way = sin_cos_deg(360 * common.uniform() - 180);
  for (WildFootprint& footprint : all) {
    Rng rng = draws.random("roofs.footprints_error", footprint.id);
    const Vec3 by{shift * way.cos + own * gaussian(rng), shift * way.sin + own * gaussian(rng), 0};
    for (auto& ring : footprint.rings)
      for (Vec3& p : ring) p = p + by;
  }
  return all;
}

}  // namespace ilot::scan
