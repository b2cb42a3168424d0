// SPDX-License-Identifier: Apache-2.0
// Planters, hedges, shrubs and trees. Leaves fill ellipsoids; what passes between them is up to the scanner.
#include <algorithm>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {
namespace {

void add_trunk(ObjectShape& s, Rng& rng, double height, double radius) {
  s.trunk_radius = radius;
  const Vec3 top{between(rng, -0.04, 0.04) * height, between(rng, -0.04, 0.04) * height, height};
  s.taper({0, 0, 0}, 0.25, 1.6 * radius, radius, Material::wood);
  s.rod({0, 0, 0}, 0.5 * top, radius, Material::wood);
  s.rod(0.5 * top, top, 0.7 * radius, Material::wood);
}

// Adds branches from the trunk to the middles of the balls of leaves.
void add_branches(ObjectShape& s, double from, double radius) {
  for (std::size_t i = 0; i < std::min<std::size_t>(8, s.leaves.size()); ++i)
    s.rod({0, 0, from}, s.leaves[i].centre, 0.35 * radius, Material::wood);
}

// Fills an ellipsoid with smaller balls, so that the outline is uneven and has holes.
void fill_crown(ObjectShape& s, Rng& rng, Vec3 centre, Vec3 radii, int balls) {
  for (int i = 0; i < balls; ++i) {
    Vec3 p{2, 2, 2};
    while (dot(p, p) > 1) p = {between(rng, -1, 1), between(rng, -1, 1), between(rng, -1, 1)};
    const double size = between(rng, 0.32, 0.55);
    const Vec3 place{centre.x + (1 - size) * 1.15 * radii.x * p.x, centre.y + (1 - size) * 1.15 * radii.y * p.y,
                     centre.z + (1 - size) * 1.15 * radii.z * p.z};
    s.leaf_ball(place, size * radii);
  }
}

}  // namespace

void make_planter(ObjectShape& s, Rng& rng) {
  const double w = between(rng, 0.5, 2.2), d = between(rng, 0.4, 0.9), h = between(rng, 0.35, 0.8);
  if (rng.uniform() < 0.4)
    s.rod({0, 0, 0}, {0, 0, h}, d / 2, Material::limestone);
  else
    s.box({0, 0, h / 2}, {d, w, h}, Material::wood);
  const auto balls = 1 + rng.below(4);
  for (std::uint64_t i = 0; i < balls; ++i) {
    const double r = between(rng, 0.12, 0.4);
    s.leaf_ball({0, between(rng, -0.35, 0.35) * (w - 0.4), h + 0.5 * r}, {r, r, between(rng, 0.8, 2) * r});
  }
}

void make_hedge(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 2, 10), h = between(rng, 0.6, 2.4), d = between(rng, 0.25, 0.6);
  const double pitch = 1.2 * d;
  for (double y = -l / 2; y <= l / 2; y += pitch)
    for (double z = 0.5 * std::min(h, 1.2); z < h; z += 0.7)
      s.leaf_ball({between(rng, -0.05, 0.05), y, z}, {d * between(rng, 0.9, 1.1), d * 1.1, std::min(0.6, 0.5 * h)});
}

void make_shrub(ObjectShape& s, Rng& rng) {
  const double r = between(rng, 0.3, 1.4), h = between(rng, 0.5, 2.8);
  fill_crown(s, rng, {0, 0, 0.52 * h}, {r, r, 0.5 * h}, 7);
  for (const double side : {-1.0, 1.0}) s.rod({0, 0, 0}, {0.3 * side * r, 0.2 * r, 0.6 * h}, 0.015, Material::wood);
}

void make_ball_tree(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 5, 14), r = h * between(rng, 0.2, 0.33), base = between(rng, 2, 0.45 * h);
  const double trunk = between(rng, 0.012, 0.022) * h;
  fill_crown(s, rng, {0, 0, (h + base) / 2}, {r, r, (h - base) / 2}, 22);
  add_trunk(s, rng, base + 0.35 * (h - base), trunk);
  add_branches(s, base, trunk);
  s.crown_base = base;
}

void make_column_tree(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 5, 16), r = h * between(rng, 0.07, 0.13), base = between(rng, 0.4, 2.5);
  fill_crown(s, rng, {0, 0, (h + base) / 2}, {r, r, (h - base) / 2}, 18);
  add_trunk(s, rng, 0.7 * h, between(rng, 0.01, 0.018) * h);
  s.crown_base = base;
}

void make_cone_tree(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 5, 18), r = h * between(rng, 0.14, 0.26), base = between(rng, 0.3, 3);
  for (int i = 0; i < 7; ++i) {
    const double z = base + (i + 0.5) * (h - base) / 7, wide = r * (1 - (i + 0.2) / 7.2);
    s.leaf_ball({0, 0, z}, {wide, wide, 0.62 * (h - base) / 7});
  }
  add_trunk(s, rng, 0.9 * h, between(rng, 0.01, 0.016) * h);
  s.crown_base = base;
}

// A wide, flat crown on a short trunk, as planes and limes of avenues have: branches reach over the street.
void make_spreading_tree(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 7, 18), r = h * between(rng, 0.35, 0.55), base = between(rng, 2.5, 0.4 * h);
  const double trunk = between(rng, 0.016, 0.03) * h;
  fill_crown(s, rng, {0, 0, 0.5 * (h + base)}, {r, r, 0.5 * (h - base)}, 34);
  add_trunk(s, rng, base + 0.2 * h, trunk);
  add_branches(s, base, trunk);
  s.crown_base = base;
}

// Cut back to its limbs, with a few shoots.
void make_pollarded_tree(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 3, 5.5), trunk = between(rng, 0.1, 0.25);
  add_trunk(s, rng, h, trunk);
  const auto limbs = 4 + rng.below(4);
  for (std::uint64_t i = 0; i < limbs; ++i) {
    const SinCos way = sin_cos_deg(360 * static_cast<double>(i) / static_cast<double>(limbs) - 180);
    const Vec3 knob{1.3 * way.cos, 1.3 * way.sin, h + between(rng, 0.4, 1.4)};
    s.rod({0, 0, h - 0.2}, knob, 0.5 * trunk, Material::wood);
    s.ball(knob, 0.6 * trunk, Material::wood);
    const double shoots = between(rng, 0.1, 0.8);
    s.leaf_ball(knob + Vec3{0, 0, 0.4 * shoots}, {0.6 * shoots, 0.6 * shoots, shoots});
  }
  s.crown_base = h;
}

// Newly planted between two stakes.
void make_young_tree(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 3, 5), base = between(rng, 1.6, 2.2);
  add_trunk(s, rng, 0.8 * h, between(rng, 0.02, 0.045));
  for (const double y : {-0.35, 0.35}) s.rod({0, y, 0}, {0, y, 1.7}, 0.035, Material::wood);
  s.rod({0, -0.35, 1.6}, {0, 0.35, 1.6}, 0.025, Material::wood);
  fill_crown(s, rng, {0, 0, 0.5 * (h + base)}, {0.7, 0.7, 0.5 * (h - base)}, 9);
  s.crown_base = base;
}

}  // namespace ilot::scan
