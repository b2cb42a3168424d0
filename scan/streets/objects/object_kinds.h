// SPDX-License-Identifier: Apache-2.0
// The kinds of objects that stand on the streets of `street-wild`. Each is made of small solids and of leaves, with
// sizes from catalogues and standards that scan/wild/distributions.csv names.
#pragma once
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "kernels/core/rng.h"
#include "scan/optics/solid.h"
#include "scan/scanners/pose.h"
#include "scan/streets/artefact.h"

namespace ilot::scan {

// An object in its own frame: x ahead (for what stands at the kerb: to the road), y to the left, z up, on z = 0.
struct ObjectShape : Artefact {
  std::vector<Crown> leaves;
  double trunk_radius = 0, crown_base = 0;  // of a tree; metres

  void leaf_ball(Vec3 centre, Vec3 radii) { leaves.push_back({centre, radii}); }
};

// Where an object may stand.
enum class ObjectPlace : std::uint8_t {
  parking,      // on the carriageway at the kerb, along it
  carriageway,  // moving
  kerb,         // on the pavement, near the kerb
  pavement,     // anywhere on the pavement
  front,        // before the wall of a house
  square,       // on squares and courts
  yard,         // behind the houses and in front gardens
  boundary,     // along the border of a plot
  ends          // hung over the street, or between two places
};

struct ObjectKind {
  std::string_view name, family;  // a family can be left out of a scene
  ObjectPlace place;
  double frequency;  // among the kinds of its place
  void (*make)(ObjectShape& shape, Rng& rng);
};

// Returns all kinds, in a fixed order. The same kind may occur at several places.
std::span<const ObjectKind> object_kinds();

// Returns a number that is evenly spread between two others.
inline double between(Rng& rng, double low, double high) {
  return low + (high - low) * rng.uniform();
}

// The makers of one file each. Every function draws the sizes that differ within its kind.
void make_any_car(ObjectShape& s, Rng& rng);
void make_panel_van(ObjectShape& s, Rng& rng);
void make_lorry(ObjectShape& s, Rng& rng);
void make_articulated_lorry(ObjectShape& s, Rng& rng);
void make_bus(ObjectShape& s, Rng& rng);
void make_caravan(ObjectShape& s, Rng& rng);
void make_trailer(ObjectShape& s, Rng& rng);
void make_covered_car(ObjectShape& s, Rng& rng);

void make_motorcycle(ObjectShape& s, Rng& rng);
void make_moped(ObjectShape& s, Rng& rng);
void make_kick_scooter(ObjectShape& s, Rng& rng);
void make_single_bicycle(ObjectShape& s, Rng& rng);
void make_bicycle_rack(ObjectShape& s, Rng& rng);
void make_cargo_bicycle(ObjectShape& s, Rng& rng);
void make_cyclist(ObjectShape& s, Rng& rng);

void make_walker(ObjectShape& s, Rng& rng);
void make_standing_person(ObjectShape& s, Rng& rng);
void make_sitting_person(ObjectShape& s, Rng& rng);
void make_pram(ObjectShape& s, Rng& rng);
void make_wheelchair(ObjectShape& s, Rng& rng);
void make_dog(ObjectShape& s, Rng& rng);

void make_any_lamppost(ObjectShape& s, Rng& rng);
void make_hung_lamp(ObjectShape& s, Rng& rng);
void make_bollard_light(ObjectShape& s, Rng& rng);
void make_traffic_light(ObjectShape& s, Rng& rng);
void make_traffic_light_arm(ObjectShape& s, Rng& rng);
void make_round_sign(ObjectShape& s, Rng& rng);
void make_triangle_sign(ObjectShape& s, Rng& rng);
void make_direction_sign(ObjectShape& s, Rng& rng);
void make_wire_pole(ObjectShape& s, Rng& rng);

void make_bollard(ObjectShape& s, Rng& rng);
void make_stone_ball(ObjectShape& s, Rng& rng);
void make_litter_bin(ObjectShape& s, Rng& rng);
void make_wheelie_bins(ObjectShape& s, Rng& rng);
void make_igloo_container(ObjectShape& s, Rng& rng);
void make_waste_container(ObjectShape& s, Rng& rng);
void make_skip(ObjectShape& s, Rng& rng);
void make_bench_with_back(ObjectShape& s, Rng& rng);
void make_stone_bench(ObjectShape& s, Rng& rng);
void make_hydrant(ObjectShape& s, Rng& rng);
void make_cabinet(ObjectShape& s, Rng& rng);
void make_advertising_column(ObjectShape& s, Rng& rng);
void make_kiosk(ObjectShape& s, Rng& rng);
void make_meter(ObjectShape& s, Rng& rng);
void make_letter_box(ObjectShape& s, Rng& rng);
void make_bus_stop(ObjectShape& s, Rng& rng);
void make_statue(ObjectShape& s, Rng& rng);
void make_fountain(ObjectShape& s, Rng& rng);
void make_charging_post(ObjectShape& s, Rng& rng);

void make_awning(ObjectShape& s, Rng& rng);
void make_cafe_table(ObjectShape& s, Rng& rng);
void make_parasol(ObjectShape& s, Rng& rng);
void make_market_stall(ObjectShape& s, Rng& rng);
void make_sandwich_board(ObjectShape& s, Rng& rng);

void make_slat_fence(ObjectShape& s, Rng& rng);
void make_mesh_fence(ObjectShape& s, Rng& rng);
void make_railing(ObjectShape& s, Rng& rng);
void make_garden_wall(ObjectShape& s, Rng& rng);
void make_site_fence(ObjectShape& s, Rng& rng);
void make_concrete_barrier(ObjectShape& s, Rng& rng);
void make_shed(ObjectShape& s, Rng& rng);
void make_outdoor_steps(ObjectShape& s, Rng& rng);
void make_ramp(ObjectShape& s, Rng& rng);

void make_planter(ObjectShape& s, Rng& rng);
void make_hedge(ObjectShape& s, Rng& rng);
void make_shrub(ObjectShape& s, Rng& rng);
void make_ball_tree(ObjectShape& s, Rng& rng);
void make_column_tree(ObjectShape& s, Rng& rng);
void make_cone_tree(ObjectShape& s, Rng& rng);
void make_spreading_tree(ObjectShape& s, Rng& rng);
void make_pollarded_tree(ObjectShape& s, Rng& rng);
void make_young_tree(ObjectShape& s, Rng& rng);

}  // namespace ilot::scan
