// SPDX-License-Identifier: Apache-2.0
// What stands along borders: fences, railings and walls; sheds, steps and ramps. They run along y.
#include <array>
#include <cmath>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {
namespace {

// Returns how many pieces of about this size fill a length, at least one.
int pieces(double length, double size) {
  return std::max(1, static_cast<int>(std::lround(length / size)));
}

}  // namespace

void make_slat_fence(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 2.5, 8), h = between(rng, 0.8, 1.9), slat = between(rng, 0.07, 0.12);
  const double gap = between(rng, 0.02, 0.08);
  const int slats = pieces(l, slat + gap);
  for (int i = 0; i < slats; ++i)
    s.box({0, -l / 2 + (i + 0.5) * l / slats, h / 2 + 0.05}, {0.02, slat, h - 0.1}, Material::wood);
  for (const double z : {0.25, 0.8}) s.box({-0.03, 0, z * h}, {0.04, l, 0.07}, Material::wood);
  const int posts = pieces(l, 2);
  for (int i = 0; i <= posts; ++i) s.box({-0.06, -l / 2 + i * l / posts, h / 2}, {0.08, 0.08, h}, Material::wood);
}

// Mesh of welded bars 5 cm by 20 cm: most pulses pass. Its bars are rods as thick as four of the real ones, four times
// as far apart.
void make_mesh_fence(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 3, 9), h = between(rng, 0.8, 2.0);
  const int bars = pieces(l, 0.2);
  for (int i = 0; i <= bars; ++i) {
    const double y = -l / 2 + i * l / bars;
    s.rod({0, y, 0.05}, {0, y, h}, 0.008, Material::iron);
  }
  const int rows = pieces(h, 0.4);
  for (int i = 0; i <= rows; ++i)
    s.rod({0, -l / 2, 0.05 + i * (h - 0.05) / rows}, {0, l / 2, 0.05 + i * (h - 0.05) / rows}, 0.008, Material::iron);
  const int posts = pieces(l, 2.5);
  for (int i = 0; i <= posts; ++i)
    s.rod({0, -l / 2 + i * l / posts, 0}, {0, -l / 2 + i * l / posts, h + 0.05}, 0.03, Material::iron);
}

void make_railing(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 1.5, 6), h = between(rng, 0.8, 1.15);
  s.rod({0, -l / 2, h}, {0, l / 2, h}, 0.022, Material::iron);
  s.rod({0, -l / 2, 0.15}, {0, l / 2, 0.15}, 0.015, Material::iron);
  const bool open = rng.uniform() < 0.4;
  const int bars = pieces(l, open ? 1.5 : 0.13);
  for (int i = 0; i <= bars; ++i)
    s.rod({0, -l / 2 + i * l / bars, 0}, {0, -l / 2 + i * l / bars, h}, open ? 0.022 : 0.009, Material::iron);
}

void make_garden_wall(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 3, 12), h = between(rng, 0.4, 2.4), d = between(rng, 0.12, 0.4);
  const Material stone = rng.uniform() < 0.5 ? Material::brick : Material::limestone;
  s.box({0, 0, h / 2}, {d, l, h}, stone);
  s.box({0, 0, h + 0.03}, {d + 0.08, l, 0.06}, Material::limestone);
  if (rng.uniform() < 0.5)
    for (const double side : {-1.0, 1.0}) s.box({0, side * (l / 2 + 0.2), h / 2 + 0.1}, {0.45, 0.45, h + 0.2}, stone);
}

void make_site_fence(ObjectShape& s, Rng& rng) {
  const auto fields = 1 + rng.below(3);
  for (std::uint64_t f = 0; f < fields; ++f) {
    const double y = 3.5 * static_cast<double>(f);
    for (const double side : {-1.72, 1.72}) s.rod({0, y + side, 0}, {0, y + side, 2}, 0.02, Material::zinc);
    for (const double z : {0.12, 1.98}) s.rod({0, y - 1.72, z}, {0, y + 1.72, z}, 0.02, Material::zinc);
    for (int i = 1; i < 14; ++i)
      s.rod({0, y - 1.72 + 0.2457 * i, 0.12}, {0, y - 1.72 + 0.2457 * i, 1.98}, 0.006, Material::zinc);
    s.box({0, y + 1.72, 0.08}, {0.7, 0.24, 0.15}, Material::limestone);
  }
}

void make_concrete_barrier(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 2, 6);
  s.profile(std::array<FlatPoint, 6>{{{-0.3, 0}, {0.3, 0}, {0.28, 0.08}, {0.1, 0.81}, {-0.1, 0.81}, {-0.28, 0.08}}}, l,
            Material::limestone);
}

void make_shed(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 1.8, 6), d = between(rng, 1.5, 3.2), h = between(rng, 1.9, 2.7),
               rise = between(rng, 0, 0.8);
  s.profile(std::array<FlatPoint, 5>{{{-d / 2, 0}, {d / 2, 0}, {d / 2, h}, {0, h + rise + 0.02}, {-d / 2, h}}}, l,
            Material::wood);
}

// Three to nine steps up against x, 15 to 18 cm high, with cheeks.
void make_outdoor_steps(ObjectShape& s, Rng& rng) {
  const auto steps = 2 + static_cast<int>(rng.below(6));
  const double rise = between(rng, 0.14, 0.18), tread = between(rng, 0.28, 0.36), w = between(rng, 1, 2);
  for (int i = 0; i < steps; ++i)
    s.box({-(i + 0.5) * tread - 0.5 * (steps - 1 - i) * tread, 0, rise * (i + 0.5)}, {(steps - i) * tread, w, rise},
          Material::limestone);
  if (rng.uniform() < 0.5)
    for (const double side : {-1.0, 1.0})
      s.rod({0, side * (w / 2 - 0.05), 0.9}, {-steps * tread, side * (w / 2 - 0.05), 0.9 + steps * rise}, 0.025,
            Material::iron);
}

// Ramps for wheelchairs rise by 4 to 12 in a hundred.
void make_ramp(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 1.5, 6), h = l * between(rng, 0.04, 0.12), w = between(rng, 1, 1.5);
  const std::array<Vec3, 3> side{{{-w / 2, -l / 2, 0}, {-w / 2, l / 2, 0}, {-w / 2, l / 2, h}}};
  s.solids.push_back(prism(side, {w, 0, 0}, static_cast<SurfaceId>(Material::paving)));
  s.rod({w / 2, -l / 2, 0.9}, {w / 2, l / 2, 0.9 + h}, 0.022, Material::iron);
  for (const double y : {-0.48, 0.0, 0.48})
    s.rod({w / 2, y * l, 0}, {w / 2, y * l, 0.9 + (0.5 + y) * h}, 0.02, Material::iron);
}

}  // namespace ilot::scan
