// SPDX-License-Identifier: Apache-2.0
// Awnings, tables, parasols, stalls and boards.
#include <array>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {

// An awning hangs on the wall behind it, at x = 0, and slopes towards the street.
void make_awning(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 2.6, 3.4), reach = between(rng, 1, 2.4), w = between(rng, 2, 5), drop = 0.25 * reach;
  const std::array<Vec3, 4> cloth{{{0, -w / 2, h}, {0, w / 2, h}, {reach, w / 2, h - drop}, {reach, -w / 2, h - drop}}};
  s.solids.push_back(prism(cloth, {0, 0, 0.02}, static_cast<SurfaceId>(Material::cloth)));
  s.box({reach, 0, h - drop - 0.1}, {0.02, w, 0.22}, Material::cloth);
}

void make_cafe_table(ObjectShape& s, Rng& rng) {
  const double r = between(rng, 0.3, 0.42);
  s.disc({0, 0, 0.73}, {0, 0, 1}, 0.03, r, Material::wood);
  s.rod({0, 0, 0}, {0, 0, 0.72}, 0.03, Material::iron);
  s.disc({0, 0, 0.02}, {0, 0, 1}, 0.03, 0.22, Material::iron);
  const auto chairs = 1 + rng.below(4);
  for (std::uint64_t i = 0; i < chairs; ++i) {
    const SinCos way = sin_cos_deg(90 * static_cast<double>(i) - 180 + between(rng, -20, 20));
    ObjectShape chair;
    chair.box({0, 0, 0.45}, {0.42, 0.42, 0.03}, Material::wood);
    chair.box({0.2, 0, 0.68}, {0.03, 0.42, 0.44}, Material::wood);
    for (const double x : {-0.19, 0.19})
      for (const double y : {-0.19, 0.19}) chair.rod({x, y, 0}, {x, y, 0.45}, 0.013, Material::iron);
    for (const Solid& part : chair.solids)
      s.solids.push_back(placed(part, {{(r + 0.25) * way.cos, (r + 0.25) * way.sin, 0}, way, {}}));
  }
}

void make_parasol(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 2.3, 3), r = between(rng, 1.1, 2);
  s.rod({0, 0, 0}, {0, 0, h}, 0.025, Material::wood);
  s.taper({0, 0, h - 0.45}, 0.5, r, 0.05, Material::cloth);
  s.box({0, 0, 0.06}, {0.6, 0.6, 0.12}, Material::limestone);
}

void make_market_stall(ObjectShape& s, Rng& rng) {
  const double w = between(rng, 2.5, 4.5), h = between(rng, 2.2, 2.8);
  for (const double x : {-1.0, 1.0})
    for (const double y : {-0.48, 0.48}) s.rod({x, y * w, 0}, {x, y * w, h}, 0.025, Material::zinc);
  const std::array<Vec3, 4> cloth{{{-1.2, -w / 2, h + 0.3}, {-1.2, w / 2, h + 0.3}, {1.4, w / 2, h}, {1.4, -w / 2, h}}};
  s.solids.push_back(prism(cloth, {0, 0, 0.03}, static_cast<SurfaceId>(Material::cloth)));
  s.box({0.5, 0, 0.8}, {0.8, 0.9 * w, 0.1}, Material::wood);
  const auto crates = 3 + rng.below(6);
  for (std::uint64_t i = 0; i < crates; ++i)
    s.box({between(rng, 0.2, 0.8), between(rng, -0.4, 0.4) * w, 0.95}, {0.3, 0.4, between(rng, 0.1, 0.35)},
          Material::wood);
}

void make_sandwich_board(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 0.9, 1.3), w = between(rng, 0.5, 0.8), lean = 0.28;
  for (const double side : {-1.0, 1.0}) {
    const std::array<Vec3, 4> board{{{side * lean, -w / 2, 0}, {side * lean, w / 2, 0}, {0, w / 2, h}, {0, -w / 2, h}}};
    s.solids.push_back(prism(board, {side * 0.02, 0, 0}, static_cast<SurfaceId>(Material::wood)));
  }
}

}  // namespace ilot::scan
