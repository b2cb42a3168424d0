// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/street_garden.h"

#include <array>
#include <cmath>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

constexpr double kSunk = 0.3;          // metres below the ground that walls and sheds reach
constexpr double kHedgeSpacing = 0.6;  // metres between the bushes of a hedge

class VegetationBuilder {
 public:
  VegetationBuilder(StreetStage& stage, std::uint64_t seed) : stage_(stage), rng_(seed, 0x67617264656eull) {}

  void plant(const StreetBlock& block, int side) {
    const double s = between(block.from, block.to), t = side * between(kGardenFrom, kGardenTo);
    const double kind = rng_.uniform();
    if (kind < 0.35)
      bush(s, t, between(0.3, 1.5), between(0.5, 3));
    else if (kind < 0.55)
      hedge(s, t);
    else if (kind < 0.7)
      tree(s, t);
    else if (kind < 0.85)
      box(s, t, between(1.5, 4.5), between(1.2, 3), between(1.9, 2.6), StreetClass::roof, Material::wood);
    else
      box(s, t, between(2, 8), between(0.15, 0.35), between(0.6, 1.9), StreetClass::facade, Material::brick);
  }

 private:
  double between(double low, double high) { return low + (high - low) * rng_.uniform(); }
  double ground(double s, double t) const { return stage_.street.ground_height(s, t); }

  void bush(double s, double t, double radius, double height) {
    stage_.model.crowns.push_back({{s, t, ground(s, t) + height / 2}, {radius, radius, height / 2}});
  }

  void hedge(double s, double t) {
    const SinCos way = sin_cos_deg(between(0, 180));
    const double radius = between(0.35, 0.9), height = between(0.8, 2.2);
    const auto bushes = static_cast<int>(between(4, 14));
    for (int i = 0; i < bushes; ++i)
      bush(s + i * kHedgeSpacing * way.cos, t + i * kHedgeSpacing * way.sin, radius * between(0.9, 1.1),
           height * between(0.9, 1.1));
  }

  // The trunk is left out: it is thinner than pulses from this height can resolve.
  void tree(double s, double t) {
    const double half = between(1.2, 3), radius = between(1, 3), foot = between(0.3, 2.5);
    stage_.model.crowns.push_back({{s, t, ground(s, t) + foot + half}, {radius, radius, half}});
  }

  void box(double s, double t, double length, double width, double height, StreetClass is, Material material) {
    SceneModel& scene = stage_.model.scene;
    const SinCos way = sin_cos_deg(between(0, 180));
    const double floor = ground(s, t) - kSunk;
    const auto corner = [&](double along, double across) {
      return Vec3{s + along * way.cos - across * way.sin, t + along * way.sin + across * way.cos, floor};
    };
    const std::array ring{corner(-length / 2, -width / 2), corner(length / 2, -width / 2),
                          corner(length / 2, width / 2), corner(-length / 2, width / 2)};
    scene.parts.push_back(
        prism(ring, {0, 0, kSunk + height}, scene.add_surface({static_cast<std::uint8_t>(is), 0, 0, material})));
  }

  StreetStage& stage_;
  Rng rng_;
};

}  // namespace

void add_gardens(StreetStage& stage, double per_side, std::uint64_t seed) {
  VegetationBuilder vegetation(stage, seed);
  double due = 0;
  for (const StreetBlock& block : stage.street.blocks)
    for (const int side : {1, -1})
      for (due += per_side; due >= 1; --due) vegetation.plant(block, side);
}

}  // namespace ilot::scan
