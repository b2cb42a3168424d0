// SPDX-License-Identifier: Apache-2.0
#include "scan/roofs/roof_town.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <optional>
#include <span>
#include <utility>

#include "scan/roofs/roof_neighbours.h"
#include "scan/roofs/roof_quarter.h"
#include "scan/unit.h"

namespace ilot::scan {
namespace {

constexpr double kLotArea = 400;  // square metres per building, at least

// Distributes the kinds of roof in a random order.
std::vector<RoofKind> deal_kinds(Rng& rng, std::uint64_t buildings) {
  const RoofCounts counts = roof_counts(buildings);
  std::vector<RoofKind> kinds(counts.gable, RoofKind::gable);
  kinds.insert(kinds.end(), counts.hip, RoofKind::hip);
  kinds.insert(kinds.end(), counts.complex, RoofKind::complex);
  for (std::size_t i = kinds.size(); i > 1; --i) std::swap(kinds[i - 1], kinds[rng.below(i)]);
  return kinds;
}

void add_trees(RoofTown& town, double per_hectare, Rng& rng) {
  const double width = town.area.x1 - town.area.x0, height = town.area.y1 - town.area.y0;
  const auto wanted = static_cast<std::size_t>(per_hectare * width * height / 1e4);
  for (std::size_t attempt = 0; attempt < 4 * wanted && town.crowns.size() < wanted; ++attempt) {
    const double radius = 1.5 + 2.5 * rng.uniform(), top = 4.5 + 8 * rng.uniform();
    const double half = top * (0.3 + 0.1 * rng.uniform());
    const double x = town.area.x0 + radius + (width - 2 * radius) * rng.uniform();
    const double y = town.area.y0 + radius + (height - 2 * radius) * rng.uniform();
    if (ground_cover(town, x, y) == Material::asphalt) continue;
    const bool near_house = std::any_of(town.buildings.begin(), town.buildings.end(), [&](const RoofBuilding& b) {
      return distance_to_building(b, x, y) < radius + 0.3;
    });
    const bool in_tree = std::any_of(town.crowns.begin(), town.crowns.end(), [&](const Crown& c) {
      const double dx = x - c.centre.x, dy = y - c.centre.y, apart = 0.8 * (radius + c.radii.x);
      return dx * dx + dy * dy < apart * apart;
    });
    if (!near_house && !in_tree)
      town.crowns.push_back({{x, y, town.ground.height(x, y) + top - half}, {radius, radius, half}});
  }
}

// Fills a town of square quarters with the given side. Returns nothing when they have no room for all buildings.
std::optional<std::vector<RoofBuilding>> fill(const RoofTownParams& params, const Ground& ground, double side,
                                              std::span<const RoofKind> kinds) {
  std::vector<RoofBuilding> all;
  std::size_t from = 0;
  for (std::size_t quarter = 0; quarter < 4; ++quarter) {
    const std::size_t to = kinds.size() * (quarter + 1) / 4;
    std::vector<RoofBuilding> part = fill_quarter(params, ground, quarter, side, kinds.subspan(from, to - from));
    if (part.size() < to - from) return std::nullopt;
    std::move(part.begin(), part.end(), std::back_inserter(all));
    from = to;
  }
  return all;
}

}  // namespace

double distance_to_building(const RoofBuilding& building, double x, double y) {
  const Vec3 p = building.frame.to_local({x, y, 0});
  double nearest = 1e9;
  for (const Wing& wing : building.wings) {
    const double du = std::max(
        {kUnit * static_cast<double>(wing.rect.u0) - p.x, 0.0, p.x - kUnit * static_cast<double>(wing.rect.u1)});
    const double dv = std::max(
        {kUnit * static_cast<double>(wing.rect.v0) - p.y, 0.0, p.y - kUnit * static_cast<double>(wing.rect.v1)});
    nearest = std::min(nearest, std::sqrt(du * du + dv * dv));
  }
  return nearest;
}

Vec3 RoofFrame::direction_to_town(Vec3 d) const {
  return {d.x * heading.cos - d.y * heading.sin, d.x * heading.sin + d.y * heading.cos, d.z};
}

Vec3 RoofFrame::to_town(Vec3 local) const {
  return direction_to_town(local) + Vec3{x, y, 0};
}

Vec3 RoofFrame::to_local(Vec3 place) const {
  const double dx = place.x - x, dy = place.y - y;
  return {dx * heading.cos + dy * heading.sin, dy * heading.cos - dx * heading.sin, place.z};
}

RoofCounts roof_counts(std::uint64_t buildings) {
  RoofCounts counts;
  counts.gable = (buildings * 128 + 222) / 445;
  counts.hip = std::min((buildings * 52 + 222) / 445, buildings - counts.gable);
  counts.complex = buildings - counts.gable - counts.hip;
  return counts;
}

RoofTown build_roof_town(const RoofTownParams& params) {
  RoofTown town;
  Rng rng(params.seed, 0x726f6f66);
  const SinCos downhill = sin_cos_deg(360 * rng.uniform() - 180);
  const double slope = params.slope_percent / 100;
  const std::vector<RoofKind> kinds = deal_kinds(rng, params.buildings);
  double side = std::sqrt(kLotArea * static_cast<double>(params.buildings) / 4) + 2 * kHalfAvenue + 20;
  for (;; side *= 1.05) {
    town.ground = {50 + 2 * slope * side, slope * downhill.cos, slope * downhill.sin};
    if (auto buildings = fill(params, town.ground, side, kinds)) {
      town.buildings = std::move(*buildings);
      break;
    }
  }
  town.area = {0, 0, 2 * side, 2 * side};
  number_planes(town);
  add_trees(town, params.trees, rng);
  return town;
}

Material ground_cover(const RoofTown& town, double x, double y) {
  const double side = town.area.x1 / 2;
  for (double across : {x, y}) {
    const double avenue = std::abs(across - side * std::round(across / side));
    if (avenue < kHalfAvenue - 3.5) return Material::asphalt;
    if (avenue < kHalfAvenue - 1.5) return Material::paving;
  }
  const std::size_t index = (x < side ? 0u : 1u) + (y < side ? 0u : 2u);
  const Vec3 p = make_quarter(index, side).frame.to_local({x, y, 0});
  const double street = std::abs(p.y - kStreetPitch * std::round(p.y / kStreetPitch));
  if (street < kRoofHalfRoad) return Material::asphalt;
  return street < kRoofHalfStreet ? Material::paving : Material::grass;
}

}  // namespace ilot::scan
