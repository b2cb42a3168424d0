// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_plan.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

constexpr double kFirstBlock = 12;  // metres of street before the first block and after the last

void add_blocks(Street& street, Rng& rng) {
  double s = kFirstBlock;
  for (std::uint64_t i = 0; i < street.params.blocks; ++i) {
    const double end = s + 44 + std::floor(29 * rng.uniform());
    street.blocks.push_back({static_cast<std::uint32_t>(i + 1), s, end});
    s = end + 7.5 + 0.5 * static_cast<double>(rng.below(10));
  }
  street.length = street.blocks.back().to + kFirstBlock;
}

StreetHouse draw_house(Rng& rng, double from, double to, int side) {
  StreetHouse house;
  house.side = side;
  house.from = from;
  house.to = to;
  house.floors = 4 + static_cast<std::uint32_t>(rng.below(3));
  house.ground_floor = 3.6 + 0.2 * static_cast<double>(rng.below(5));
  house.storey = 2.9 + 0.1 * static_cast<double>(rng.below(5));
  house.window_width = 1.0 + 0.1 * static_cast<double>(rng.below(4));
  house.window_height = 1.6 + 0.1 * static_cast<double>(rng.below(5));
  house.columns = std::max(2u, static_cast<std::uint32_t>((to - from - 0.8) / (house.window_width + 1.3)));
  house.shop = rng.uniform() < 0.4;
  const double wall = rng.uniform(), roof = rng.uniform();
  house.wall = wall < 0.45 ? Material::limestone : wall < 0.8 ? Material::render : Material::brick;
  house.roof = roof < 0.7 ? Material::zinc : Material::slate;
  return house;
}

void add_houses(Street& street, Rng& rng) {
  for (const StreetBlock& block : street.blocks)
    for (int side : {1, -1}) {
      double s = block.from;
      while (s < block.to) {
        double end = s + 9 + std::floor(8 * rng.uniform());
        if (block.to - end < 8) end = block.to;
        StreetHouse house = draw_house(rng, s, end, side);
        house.base = street.road_height((s + end) / 2) + kKerb;
        street.houses.push_back(house);
        s = end;
      }
    }
}

void add_trees(Street& street, Rng& rng) {
  const auto count =
      static_cast<std::uint64_t>(std::llround(street.params.trees * static_cast<double>(street.params.blocks)));
  for (std::uint64_t i = 0; i < count; ++i) {
    const StreetBlock& block = street.blocks[i * street.blocks.size() / count];
    const double s = block.from + 4 + (block.to - block.from - 8) * rng.uniform();
    const double t = (rng.uniform() < 0.5 ? 1 : -1) * 6.9;
    const double radius = 1.3 + 0.8 * rng.uniform(), half = 1.6 + 1.2 * rng.uniform();
    const bool free = std::none_of(street.trees.begin(), street.trees.end(), [&](const StreetTree& other) {
      return std::abs(other.foot.x - s) < 6 && other.foot.y == t;
    });
    if (!free) continue;
    const Vec3 foot{s, t, street.ground_height(s, t)};
    street.trees.push_back({foot, {foot + Vec3{0, 0, 3 + half}, {radius, radius, half}}});
  }
}

}  // namespace

bool Street::on_pavement(double s, double t) const {
  if (std::abs(t) < kHalfRoad || std::abs(t) > kCrossStreet) return false;
  return std::any_of(blocks.begin(), blocks.end(),
                     [&](const StreetBlock& b) { return s > b.from - kCorner && s < b.to + kCorner; });
}

Street plan_street(const StreetParams& params) {
  Street street;
  street.params = params;
  street.slope = params.slope_percent / 100;
  street.base = 40;
  Rng rng(params.seed, 0x737472656574ull);
  add_blocks(street, rng);
  add_houses(street, rng);
  add_trees(street, rng);
  return street;
}

SinCos street_heading() {
  static const SinCos heading = sin_cos_deg(kStreetHeadingDeg);
  return heading;
}

Vec3 street_to_scene(Vec3 p) {
  const SinCos heading = street_heading();
  return {100 + p.x * heading.cos - p.y * heading.sin, 100 + p.x * heading.sin + p.y * heading.cos, p.z};
}

Vec3 scene_to_street(Vec3 p) {
  return turned_to_street(p - street_to_scene({0, 0, 0}));
}

Vec3 turned_to_street(Vec3 v) {
  const SinCos h = street_heading();
  return {v.x * h.cos + v.y * h.sin, v.y * h.cos - v.x * h.sin, v.z};
}

}  // namespace ilot::scan
