// SPDX-License-Identifier: Apache-2.0
// The plan of the scene `street-wild`. In street coordinates, s runs along the street, t to the left of its axis and z
// up, in metres. Everything is drawn from the group "street" of distributions.csv.
#pragma once
#include <cstdint>
#include <string_view>
#include <vector>

#include "scan/optics/exact_math.h"
#include "scan/optics/part_scene.h"
#include "scan/scanners/pose.h"
#include "scan/streets/objects/object_kinds.h"
#include "scan/streets/street_model.h"
#include "scan/truth_writer.h"
#include "scan/wild/draws.h"

namespace ilot::scan {

enum class Platform : std::uint8_t { vehicle, tripod, air };

// A place where the slope of the street changes.
struct ProfileKnot {
  double s = 0, z = 0;
};

// A rectangle of ground: its height is that of the street's profile plus a plane over t.
struct GroundPatch {
  enum class Kind : std::uint8_t { road, pavement, cross, square, passage, plot } kind = Kind::road;
  double s0 = 0, s1 = 0, t0 = 0, t1 = 0;  // t0 < t1
  double offset = 0, slope = 0;           // above the profile at t = 0; per metre of t
  Material material = Material::asphalt;
};

enum class PlotUse : std::uint8_t { house, gap, cross, square };

// A piece of one side of the street, from its pavement to the end of its yard.
struct StreetPlot {
  std::uint32_t id = 0;
  PlotUse use = PlotUse::house;
  int side = 1;
  double s0 = 0, s1 = 0;
  double setback = 0, depth = 10, yard = 15;  // of the house from the pavement; of house and yard
  double level = 0;                           // of the yard above the pavement
  bool passage = false;
  double passage_s = 0, passage_width = 3;
};

struct WildStreet {
  double length = 100, heading_deg = 0, half_road = 5, pavement = 3, kerb = 0.12, camber = 0.02;
  std::string_view layout;
  Platform platform = Platform::vehicle;
  std::vector<ProfileKnot> profile;
  std::vector<StreetPlot> plots;
  std::vector<GroundPatch> patches;  // where several lie over a position, the last counts

  double half_street() const { return half_road + pavement; }
  double profile_height(double s) const;
  double ground_height(double s, double t) const;
  const GroundPatch* patch_at(double s, double t) const;  // null where nothing was made
  Vec3 to_scene(Vec3 p) const;
  Vec3 to_street(Vec3 p) const;
  Vec3 turned_to_street(Vec3 v) const;
};

// Metres of street beyond both ends of what the cloud keeps, and from the pavement to where the ground ends.
constexpr double kStreetBeyond = 20, kPlotEnd = 45;

WildStreet plan_wild_street(Draws& draws, Platform platform, double length);

struct WildObject {
  std::uint32_t id = 0;
  const ObjectKind* kind = nullptr;
  ObjectShape shape;
  Pose pose;
  double heading_deg = 0;
  Box3<Vec3> box;  // of solids and leaves, turned neither up nor about, relative to the base
  PlanBox plan;
  std::vector<std::uint32_t> touches;
  Vec3 velocity;                // metres per second
  double seen_at_s = 0;         // it is at its base when the scanner passes here
  bool comes_and_goes = false;  // it is there in some flight lines only
  bool is_plant() const { return shape.leaves.size() > 0 && shape.trunk_radius == 0 && kind->name != "planter"; }
  bool is_tree() const { return shape.trunk_radius > 0; }
  bool moves() const { return dot(velocity, velocity) > 0; }
};

std::vector<WildObject> place_wild_objects(const WildStreet& street, Draws& draws, double lane);

// A polyline between road and pavement.
struct Kerb {
  std::vector<Vec3> line;  // street coordinates, on the upper edge
  double height = 0;
};

// The leaves of an object, in street coordinates.
struct LeafBall {
  Crown crown;
  std::uint32_t object = 0;
  double density = 0.6;  // chance per metre that a ray meets a leaf
};

// What rays meet. Objects that move or come and go are apart from what stands.
struct WildMoving {
  std::uint32_t object = 0;
  std::vector<Part> parts;  // where it stands at its base
  Box3<Vec3> bounds;
};
struct WildStreetModel {
  StreetModel street;  // `crowns` is unused
  std::vector<LeafBall> leaves;
  std::vector<WildMoving> moving;
  std::vector<Kerb> kerbs;
  std::vector<TrueBlock> blocks;
};

WildStreetModel build_wild_street(const WildStreet& street, const std::vector<WildObject>& objects, Draws& draws);

// The pieces of build_wild_street.
void add_wild_ground(WildStreetModel& model, const WildStreet& street);
void add_wild_house(WildStreetModel& model, const WildStreet& street, const StreetPlot& plot, Draws& draws);
void add_court_ends(WildStreetModel& model, const WildStreet& street, Draws& draws);

}  // namespace ilot::scan
