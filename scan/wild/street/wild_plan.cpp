// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "scan/wild/street/wild_street.h"

namespace ilot::scan {
namespace {

constexpr double kStreetBase = 40;  // z of the profile at s = 0

void add_profile(WildStreet& street, Draws& draws) {
  double z = kStreetBase, s = -kStreetBeyond - 30;
  const double slope = draws.number("street.slope") / 100, change = draws.number("street.slope_change") / 100;
  Rng rng = draws.random("street.profile");
  const double way = rng.uniform() < 0.5 ? -1 : 1;
  while (s < street.length + kStreetBeyond + 30) {
    street.profile.push_back({s, z});
    const double step = 12 + 14 * rng.uniform();
    z += step * std::clamp(way * slope + change * (2 * rng.uniform() - 1), -0.2, 0.2);
    s += step;
  }
  street.profile.push_back({s, z});
}

StreetPlot plot_of(Draws& draws, const WildStreet& street, std::uint32_t id, int side, double s0, double s1,
                   PlotUse use) {
  StreetPlot plot{id, use, side, s0, s1};
  const bool detached = street.layout == "detached";
  plot.setback = detached ? draws.number("street.front_garden", id) : draws.number("street.setback", id);
  plot.depth = draws.number("street.house_depth", id);
  plot.yard = draws.number("street.yard_depth", id);
  plot.level = draws.number("street.yard_level", id);
  plot.passage = use == PlotUse::house && !detached && s1 - s0 > 7 && draws.happens("street.passages", id);
  plot.passage_width = 2.4 + 1.2 * draws.random("street.passage", id).uniform();
  plot.passage_s = s0 + 1.2 + plot.passage_width / 2;
  return plot;
}

// Adds the plots of one side between two cuts.
void add_side(WildStreet& street, Draws& draws, int side, double from, double to) {
  Rng rng = draws.random("street.plots", element_index(static_cast<std::uint64_t>(side + 1), street.plots.size()));
  const bool detached = street.layout == "detached";
  const double gaps = draws.number("street.gaps");
  double s = from;
  while (s < to - 3) {
    double end = s + (detached ? 8 + 6 * rng.uniform() : 6 + 11 * rng.uniform());
    if (to - end < 6) end = to;
    const auto next_id = [&] { return static_cast<std::uint32_t>(street.plots.size() + 1); };
    const bool open = !detached && rng.uniform() < gaps && end < to;
    street.plots.push_back(plot_of(draws, street, next_id(), side, s, end, open ? PlotUse::gap : PlotUse::house));
    s = end;
    if (!detached || s > to - 5) continue;
    end = std::min(to, s + 2 + 6 * rng.uniform());
    street.plots.push_back(plot_of(draws, street, next_id(), side, s, end, PlotUse::gap));
    s = end;
  }
}

// Cuts a side by a crossing or a square and fills the rest with plots.
void add_sides(WildStreet& street, Draws& draws) {
  const double from = -kStreetBeyond, to = street.length + kStreetBeyond;
  Rng rng = draws.random("street.cuts");
  const double middle = street.length * (0.3 + 0.4 * rng.uniform());
  for (const int side : {1, -1}) {
    const auto id = [&] { return static_cast<std::uint32_t>(street.plots.size() + 1); };
    double half = 0;
    PlotUse use = PlotUse::cross;
    if (street.layout == "crossing") half = street.half_road * (0.6 + 0.6 * rng.uniform());
    if (street.layout == "square" && side == 1) {
      half = std::min(0.4 * street.length, 10 + 12 * rng.uniform());
      use = PlotUse::square;
    }
    if (half == 0) {
      add_side(street, draws, side, from, to);
      continue;
    }
    add_side(street, draws, side, from, middle - half);
    street.plots.push_back(plot_of(draws, street, id(), side, middle - half, middle + half, use));
    add_side(street, draws, side, middle + half, to);
  }
}

// Adds a patch on one side: `near` and `far` are distances from the axis, `height` is that at `near`, and `rise` is
// per metre away from the axis.
void add_patch(WildStreet& street, GroundPatch::Kind kind, int side, double s0, double s1, double near, double far,
               double height, double rise, Material material) {
  GroundPatch patch{kind, s0, s1, side > 0 ? near : -far, side > 0 ? far : -near, 0, side * rise, material};
  patch.offset = height - rise * near;
  street.patches.push_back(patch);
}

void add_plot_ground(WildStreet& street, const StreetPlot& plot, double cross_slope) {
  using Kind = GroundPatch::Kind;
  const double edge = -street.camber * street.half_road, outer = street.half_street();
  const double top = edge + street.kerb + 0.02 * street.pavement;
  const double back = outer + plot.setback + plot.depth, end = outer + kPlotEnd;
  const double rise = plot.side * cross_slope;
  const auto add = [&](Kind kind, double s0, double s1, double near, double far, double height, double up, Material m) {
    add_patch(street, kind, plot.side, s0, s1, near, far, height, up, m);
  };
  if (plot.use == PlotUse::cross) {
    add(Kind::cross, plot.s0, plot.s1, street.half_road, end, edge, 0.5 * rise, Material::asphalt);
    return;
  }
  add(Kind::pavement, plot.s0, plot.s1, street.half_road, outer, edge + street.kerb, 0.02, Material::paving);
  if (plot.use == PlotUse::square) {
    add(Kind::square, plot.s0, plot.s1, outer, end, top, 0.3 * rise, Material::paving);
    return;
  }
  const Material soil = plot.id % 3 == 0 ? Material::paving : Material::grass;
  if (plot.setback > 0.05) add(Kind::plot, plot.s0, plot.s1, outer, outer + plot.setback, top, 0.5 * rise, soil);
  const double yard_height = top + plot.level;
  const double yard_from = plot.use == PlotUse::gap ? outer + plot.setback : back;
  add(Kind::plot, plot.s0, plot.s1, yard_from, end, plot.use == PlotUse::gap ? top : yard_height, rise, soil);
  if (!plot.passage) return;
  const double s0 = plot.passage_s - plot.passage_width / 2, s1 = s0 + plot.passage_width;
  add(Kind::pavement, s0, s1, street.half_road, outer, edge + 0.02, (top - edge - 0.02) / street.pavement,
      Material::paving);
  add(Kind::passage, s0, s1, outer + plot.setback, back, top, plot.level / plot.depth, Material::paving);
}

void add_ground(WildStreet& street, Draws& draws) {
  const double cross_slope = draws.number("street.cross_slope") / 100;
  const double from = -kStreetBeyond, to = street.length + kStreetBeyond;
  for (const int side : {1, -1})
    add_patch(street, GroundPatch::Kind::road, side, from, to, 0, street.half_road, 0, -street.camber,
              Material::asphalt);
  for (const StreetPlot& plot : street.plots) add_plot_ground(street, plot, cross_slope);
}

}  // namespace

double WildStreet::profile_height(double s) const {
  const auto above =
      std::find_if(profile.begin() + 1, profile.end() - 1, [&](const ProfileKnot& k) { return k.s > s; });
  const ProfileKnot& a = *(above - 1);
  return a.z + (above->z - a.z) * (s - a.s) / (above->s - a.s);
}

const GroundPatch* WildStreet::patch_at(double s, double t) const {
  const auto found = std::find_if(patches.rbegin(), patches.rend(), [&](const GroundPatch& p) {
    return s >= p.s0 && s <= p.s1 && t >= p.t0 && t <= p.t1;
  });
  return found == patches.rend() ? nullptr : &*found;
}

double WildStreet::ground_height(double s, double t) const {
  const GroundPatch* patch = patch_at(s, t);
  return profile_height(s) + (patch ? patch->offset + patch->slope * t : 0);
}

Vec3 WildStreet::to_scene(Vec3 p) const {
  const SinCos h = sin_cos_deg(heading_deg);
  return {300 + p.x * h.cos - p.y * h.sin, 300 + p.x * h.sin + p.y * h.cos, p.z};
}

Vec3 WildStreet::turned_to_street(Vec3 v) const {
  const SinCos h = sin_cos_deg(heading_deg);
  return {v.x * h.cos + v.y * h.sin, v.y * h.cos - v.x * h.sin, v.z};
}

Vec3 WildStreet::to_street(Vec3 p) const {
  return turned_to_street(p - Vec3{300, 300, 0});
}

WildStreet plan_wild_street(Draws& draws, Platform platform, double length) {
  WildStreet street;
  street.platform = platform;
  street.length = length;
  street.layout = draws.choice("street.layout");
  street.heading_deg = draws.number("street.heading");
  street.half_road = draws.number("street.half_road");
  street.pavement = draws.number("street.pavement");
  street.kerb = draws.number("street.kerb");
  street.camber = draws.number("street.camber") / 100;
  add_profile(street, draws);
  add_sides(street, draws);
  add_ground(street, draws);
  return street;
}

}  // namespace ilot::scan
