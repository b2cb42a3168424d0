// SPDX-License-Identifier: Apache-2.0
// The front of one house: how it is drawn, and how it is built from walls, openings and everything on them.
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scan/facades/facade_builder.h"
#include "scan/facades/window.h"
#include "scan/wild/draws.h"

namespace ilot::scan {

// Values of true_class in the wild scenes of facades. other: frames, panes, blinds, rooms behind panes. wall: sides of
// houses. stray: echoes from the air and mirror images.
enum class WildClass : std::uint8_t {
  mixed = kMixedClass,
  facade,
  joint,
  reveal,
  sill,
  surround,
  moulding,
  shutter,
  balcony,
  roof,
  ground,
  wall,
  object,
  vegetation,
  other,
  stray
};
std::map<int, std::string> wild_classes();

inline Finish wild_finish(WildClass surface_class, Material material, std::uint32_t element = 0,
                          std::uint8_t tone = 0) {
  return {static_cast<std::uint8_t>(surface_class), element, material, tone};
}

// Where a house stands. The origin of the frame is the left end of its front at the level of its threshold.
struct WildPlot {
  FacadeFrame frame;
  std::uint32_t facade = 1;  // its number in the truth
  std::uint64_t house = 0;   // the element of its draws
  double width = 8;
  double ground_left = 0, ground_right = 0;  // z of the ground at both ends, below or at the threshold
  std::uint32_t most_storeys = 6;
  bool gate = false;  // an open passage leads through the house
};

enum class WildUse : std::uint8_t { window, door, shop, garage, arcade };

struct WildOpening {
  Opening hole;
  Place place;  // row 1 = ground floor
  WildUse use = WildUse::window;
  std::uint64_t element = 0;  // of its draws
};

struct WildFront {
  WildPlot plot;
  FacadeFrame frame;           // of the plot, with the form of the wall
  std::vector<double> floors;  // z of the floors; the last is the eave
  std::uint32_t bays = 1;
  std::vector<WildOpening> openings;
  Material material = Material::render;
  std::uint8_t tone = 0;
  WallRelief relief;
  double reveal = 0.2, depth = 9;

  double eave() const { return floors.back(); }
  double foot() const;  // z where the wall begins, below the ground
};

// Draws the front of a house. The result depends on the plot and on the draws of its house only.
WildFront plan_front(Draws& draws, const WildPlot& plot);

// Builds the front with all that is on it, the roof and the sides.
void build_front(TerrestrialScene& scene, Draws& draws, const WildFront& front);

// The steps of build_front().
void add_openings(FacadeBuilder& facade, Draws& draws, const WildFront& front);
void add_shutters(FacadeBuilder& facade, Draws& draws, const WildFront& front, const WildOpening& window);
void add_mouldings(FacadeBuilder& facade, Draws& draws, const WildFront& front);
void add_fittings(FacadeBuilder& facade, Draws& draws, const WildFront& front);
void add_climbing_plants(FacadeBuilder& facade, Draws& draws, const WildFront& front);
void add_roof(FacadeBuilder& facade, Draws& draws, const WildFront& front);

// Adds leaves within a box of the facade's coordinates, or within the ellipsoid that fits into it.
enum class Tuft : std::uint8_t { square, round };
struct Leaves {
  double per_m3 = 300, size = 0.06;  // of the box; metres
};
void add_leaves(FacadeBuilder& facade, const Block& box, Tuft shape, const Leaves& of, const Finish& finish, Rng& rng);

// Returns the distance between the windows of neighbouring bays.
double bay_of(const WildFront& front);

// Adds an element without a ring of its own: its ring is the rectangle in the plane of the facade.
std::uint32_t add_thing(FacadeBuilder& facade, const char* kind, const Block& box);

}  // namespace ilot::scan
