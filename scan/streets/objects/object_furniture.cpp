// SPDX-License-Identifier: Apache-2.0
#include <array>

#include "scan/streets/objects/object_kinds.h"

namespace ilot::scan {

void make_bollard(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 0.6, 1.2), r = between(rng, 0.035, 0.11);
  s.rod({0, 0, 0}, {0, 0, h}, r, Material::iron);
  if (rng.uniform() < 0.5) s.ball({0, 0, h}, 1.15 * r, Material::iron);
}

void make_stone_ball(ObjectShape& s, Rng& rng) {
  const double r = between(rng, 0.2, 0.45);
  s.ball({0, 0, 0.85 * r}, r, Material::limestone);
}

void make_litter_bin(ObjectShape& s, Rng& rng) {
  if (rng.uniform() < 0.5) {
    s.solids = make_furniture("dustbin", rng).solids;
    return;
  }
  const double h = between(rng, 0.9, 1.15);
  s.rod({0, 0, 0}, {0, 0, h}, 0.03, Material::iron);
  s.box({0.18, 0, h - 0.32}, {0.3, 0.4, 0.6}, Material::iron);
}

// Wheelie bins of 80 to 240 l stand one to four in a row.
void make_wheelie_bins(ObjectShape& s, Rng& rng) {
  const auto count = 1 + rng.below(4);
  for (std::uint64_t i = 0; i < count; ++i) {
    ObjectShape bin;
    bin.solids = make_furniture("wheelie_bin", rng).solids;
    const Pose pose{
        {between(rng, -0.1, 0.1), 0.68 * static_cast<double>(i), 0}, sin_cos_deg(between(rng, -12, 12)), {}};
    for (const Solid& part : bin.solids) s.solids.push_back(placed(part, pose));
  }
}

void make_igloo_container(ObjectShape& s, Rng& rng) {
  const double r = between(rng, 0.75, 0.95);
  s.rod({0, 0, 0}, {0, 0, 0.75}, r, Material::car_paint);
  s.ball({0, 0, 0.72}, 0.995 * r, Material::car_paint);
  s.rod({0, 0, r + 0.65}, {0, 0, r + 0.9}, 0.08, Material::iron);
}

// Wheeled containers of 660 to 1,100 l.
void make_waste_container(ObjectShape& s, Rng& rng) {
  const double w = between(rng, 1.2, 1.4), d = between(rng, 0.75, 1.1), h = between(rng, 1.05, 1.2);
  s.profile(std::array<FlatPoint, 4>{{{-0.45 * d, 0.15}, {0.42 * d, 0.15}, {0.5 * d, h}, {-0.5 * d, h}}}, w,
            Material::iron);
  s.profile(std::array<FlatPoint, 4>{{{-0.5 * d, h}, {0.5 * d, h}, {0.25 * d, h + 0.22}, {-0.35 * d, h + 0.22}}}, w,
            Material::iron);
  for (const double x : {-0.35, 0.35})
    for (const double y : {-0.42, 0.42}) s.disc({x * d, y * w, 0.1}, {0, 1, 0}, 0.05, 0.1, Material::iron);
}

void make_skip(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 3.2, 4), w = 1.75, h = between(rng, 1.2, 1.6);
  const std::array<FlatPoint, 4> side{{{-0.3 * l, 0}, {0.3 * l, 0}, {0.5 * l, h}, {-0.5 * l, h}}};
  s.profile(side, 0.05, Material::car_paint);
  Solid copy = s.solids.back();
  s.solids.pop_back();
  for (const double y : {-w / 2, w / 2}) s.solids.push_back(placed(copy, {{0, y, 0}, {}, {}}));
  s.box({0, 0, 0.1}, {0.6 * l, w, 0.06}, Material::car_paint);
  s.profile(std::array<FlatPoint, 4>{{{-0.35 * l, 0.2}, {0.35 * l, 0.2}, {0.25 * l, 0.8 * h}, {-0.1 * l, 1.05 * h}}},
            w - 0.1, Material::limestone);  // rubble
  for (const double side_x : {-1.0, 1.0})
    s.solids.push_back(prism(std::array<Vec3, 4>{{{side_x * 0.3 * l, -w / 2, 0},
                                                  {side_x * 0.3 * l, w / 2, 0},
                                                  {side_x * 0.5 * l, w / 2, h},
                                                  {side_x * 0.5 * l, -w / 2, h}}},
                             {0.05, 0, 0}, static_cast<SurfaceId>(Material::car_paint)));
}

void make_bench_with_back(ObjectShape& s, Rng& rng) {
  s.solids = make_furniture("bench", rng).solids;
}

void make_stone_bench(ObjectShape& s, Rng& rng) {
  const double l = between(rng, 1.4, 2.6);
  s.box({0, 0, 0.43}, {between(rng, 0.4, 0.6), l, 0.14}, Material::limestone);
  for (const double y : {-0.36, 0.36}) s.box({0, y * l, 0.18}, {0.35, 0.18, 0.36}, Material::limestone);
}

void make_hydrant(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 0.75, 1.0);
  s.rod({0, 0, 0}, {0, 0, h}, 0.1, Material::car_paint);
  s.ball({0, 0, h}, 0.11, Material::car_paint);
  for (const double side : {-1.0, 1.0}) s.rod({0, 0, 0.7 * h}, {0, side * 0.2, 0.7 * h}, 0.05, Material::car_paint);
}

void make_cabinet(ObjectShape& s, Rng& rng) {
  const double w = between(rng, 0.5, 1.9), d = between(rng, 0.3, 0.5), h = between(rng, 0.9, 1.6);
  s.box({0, 0, h / 2}, {d, w, h}, Material::zinc);
  s.box({0, 0, h + 0.02}, {d + 0.06, w + 0.06, 0.05}, Material::zinc);
}

void make_advertising_column(ObjectShape& s, Rng& rng) {
  if (rng.uniform() < 0.5) {
    s.solids = make_furniture("advert_column", rng).solids;
    return;
  }
  const double w = between(rng, 1.2, 3.7), h = between(rng, 1.8, 2.7), low = between(rng, 0.3, 0.9);
  s.box({0, 0, low / 2}, {0.25, 0.4 * w, low}, Material::iron);
  s.box({0, 0, low + h / 2}, {0.22, w, h}, Material::white_target);
}

void make_kiosk(ObjectShape& s, Rng& rng) {
  const double w = between(rng, 2, 4), d = between(rng, 1.8, 2.6), h = between(rng, 2.4, 3);
  s.box({0, 0, h / 2}, {d, w, h}, Material::wood);
  s.box({0.2, 0, h + 0.06}, {d + 1, w + 0.6, 0.14}, Material::zinc);
  s.box({d / 2 + 0.15, 0, 1.0}, {0.35, 0.8 * w, 0.06}, Material::wood);
}

void make_meter(ObjectShape& s, Rng& rng) {
  s.solids = make_furniture(rng.uniform() < 0.5 ? "parking_meter" : "pay_station", rng).solids;
}

void make_letter_box(ObjectShape& s, Rng& rng) {
  s.solids = make_furniture("post_box", rng).solids;
}

void make_bus_stop(ObjectShape& s, Rng& rng) {
  s.solids = make_furniture("bus_shelter", rng).solids;
}

void make_statue(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 1.2, 2.8);
  s.box({0, 0, h / 2}, {1.1, 1.1, h}, Material::limestone);
  s.box({0, 0, h}, {1.35, 1.35, 0.2}, Material::limestone);
  const Artefact figure = make_pedestrian("standing", rng);
  for (Solid part : figure.solids) {
    part.surfaces.fill(static_cast<SurfaceId>(Material::iron));
    s.solids.push_back(placed(part, {{0, 0, h + 0.1}, {}, {}}));
  }
}

void make_fountain(ObjectShape& s, Rng& rng) {
  const double r = between(rng, 1.5, 3.2);
  for (int i = 0; i < 8; ++i) {
    const SinCos a = sin_cos_deg(45 * i - 157.5), b = sin_cos_deg(45 * i - 112.5);
    const double inner = r - 0.3;
    s.column(std::array<FlatPoint, 4>{{{r * a.cos, r * a.sin},
                                       {r * b.cos, r * b.sin},
                                       {inner * b.cos, inner * b.sin},
                                       {inner * a.cos, inner * a.sin}}},
             0, 0.55, Material::limestone);
  }
  s.rod({0, 0, 0}, {0, 0, 0.1}, 0.9 * r, Material::glass);
  s.rod({0, 0, 0}, {0, 0, 2}, 0.22, Material::limestone);
  s.taper({0, 0, 1.4}, 0.25, 0.75, 0.7, Material::limestone);
}

void make_charging_post(ObjectShape& s, Rng& rng) {
  const double h = between(rng, 1.2, 1.9);
  s.box({0, 0, h / 2}, {0.25, 0.38, h}, Material::car_paint);
  s.rod({0.13, 0.1, 0.9}, {0.5, 0.5, 0.08}, 0.015, Material::iron);
}

}  // namespace ilot::scan
