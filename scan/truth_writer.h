// SPDX-License-Identifier: Apache-2.0
// NAME.truth.json describes what a scene really contains, with one item per line. The schema is in docs/scenes.md.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/formats/file.h"
#include "kernels/core/types.h"
#include "scan/scanners/scan_record.h"

namespace ilot::scan {

// All positions are metres in the scene. The file contains world coordinates.

struct TruePolygon {
  std::uint32_t building = 0;  // 0 = none
  std::vector<Vec3> ring;      // counter-clockwise seen from outside, not closed
  std::vector<std::vector<Vec3>> holes;
};

struct TruePlane {
  std::uint32_t id = 0;
  std::string surface_class;
  Plane plane;  // outward
  std::uint64_t points = 0;
  std::uint32_t element = 0;
  std::vector<TruePolygon> polygons;
  double area = 0;  // square metres of the polygons; 0 = not recorded
};

struct TrueShape {
  std::uint32_t id = 0;  // in the numbering of the planes
  std::string kind;      // cylinder, sphere, cone
  Vec3 point, axis{0, 0, 1};
  double radius = 0, half_angle_deg = 0, length = 0;  // 0 = does not apply
  std::uint64_t points = 0;
};

struct TrueArc {
  Vec3 centre;
  double radius = 0, from_deg = 0, to_deg = 0;  // counter-clockwise seen from outside, 0 = to the right
};

// How an element of a scanned model is seen.
struct TrueSight {
  std::uint64_t rays = 0;  // pulses whose axis meets it first, with or without an echo
  double area = 0;         // square metres within the ring
  bool flush = false;      // nothing of it lies more than 2 cm before or behind the wall
};

struct TrueElement {
  std::uint32_t id = 0;
  std::string kind;
  std::uint32_t facade = 0, row = 0, column = 0;  // from 1; 0 = none
  std::vector<Vec3> ring;
  std::vector<TrueArc> arcs;
  double width = 0, height = 0, depth = 0;  // depth: projection positive, recess negative
  std::uint64_t points = 0;
  std::optional<TrueSight> seen = {};
};

struct TrueOpening {
  std::uint32_t id = 0, element = 0, facade = 0;
  std::vector<Vec3> ring;
  std::optional<TrueSight> seen = {};
};

struct TrueControlPoint {
  std::string group;
  std::uint32_t element = 0;
  Vec3 position;
};

struct TrueBuilding {
  std::uint32_t id = 0;
  std::string roof;
  std::vector<Vec3> footprint;
  std::vector<std::uint32_t> faces;  // plane ids
  double eave = 0, ridge = 0, ground = 0;
};

struct TrueObject {
  std::uint32_t id = 0;
  std::string object_class, variant, group;  // group: one of four classes, or empty
  Vec3 base, box_centre, box_size;
  double heading_deg = 0;
  std::vector<std::uint32_t> touches;
  std::uint64_t points = 0;
  // Of wild scenes only: nothing is written for what is not set.
  std::optional<double> occluded = std::nullopt;  // share of the rays from the scanner to it that something hides
  bool moves = false;                             // during the scan
  bool sometimes = false;                         // it is there for some passes, stations or flight lines only
  std::vector<Vec3> outline = {};                 // in plan, of what is lower than 2.2 m
};

struct TrueTree {
  std::uint32_t id = 0;  // in the numbering of the objects
  std::string form;
  Vec3 base;  // of the trunk
  double height = 0, crown_base = 0, crown_radius = 0, trunk_radius = 0;
  std::uint64_t points = 0;
  std::optional<double> occluded = std::nullopt;
  std::vector<Vec3> outline = {};  // as that of an object
};

struct TrueKerb {
  std::vector<Vec3> line;  // on the upper edge
  double height = 0;       // above the road
};

// A piece of pavement along a kerb.
struct TruePavement {
  std::vector<Vec3> line;                // the kerb
  double width = 0;                      // as built
  std::optional<double> to_facade = {};  // from the kerb to the house; not set where no house stands behind it
};

// A piece of road, or of a road that meets it. Pieces may touch, and none lies over another.
struct TrueCarriageway {
  std::vector<Vec3> ring;
};

struct TrueBlock {
  std::uint32_t id = 0;
  std::string side;
  Vec3 from, to;
};

struct TrueStation {
  std::uint32_t id = 0;
  Vec3 position;
  double step_horizontal_deg = 0, step_vertical_deg = 0;
};

struct TrueNoise {
  double range = 0, angle_deg = 0, divergence_mrad = 0, beam_diameter = 0;
};

// A value that was drawn once for a scene.
struct TrueDraw {
  std::string name;
  double value = 0;  // of a choice, the number of its name
  std::string unit;
  std::string choice;  // the name; empty = not a choice
  bool fixed = false;  // set by the caller
};

// The values that were drawn for elements.
struct TrueDrawSummary {
  std::string name, unit, per;
  std::uint64_t elements = 0;
  double least = 0, most = 0, mean = 0;
  std::map<std::string, std::uint64_t> choices;  // how often each was drawn
};

// For how many of the elements something was decided with a drawn probability.
struct TrueShare {
  std::string name;
  std::uint64_t elements = 0, happened = 0;
};

struct TrueDraws {
  std::string distributions;  // SHA-256 of the file of distributions; empty = nothing was drawn
  std::vector<TrueDraw> scene;
  std::vector<TrueDrawSummary> elements;
  std::vector<TrueShare> shares;
};

// Items may be added in any order and in any number. Each kind is written to a file of its own until finish() joins
// these files, so memory does not grow. The kinds are written in the order in which they were first added. The output
// appears under its name at finish(), or not at all. Throws Error.
class TruthWriter {
 public:
  // `settings` is the body of a JSON object that describes how the scan was made.
  TruthWriter(const std::filesystem::path& path, const std::string& settings, const ScenePlace& place = {});
  ~TruthWriter();

  void noise(const TrueNoise& noise);
  void classes(const std::map<int, std::string>& names);    // of the values of true_class
  void materials(const std::map<int, std::string>& names);  // of the values of the user data

  void add(const TrueDraws& draws);  // writes nothing when nothing was drawn
  void add(const TrueStation& station);
  void add(const TruePlane& plane);
  void add(const TrueShape& shape);
  void add(const TrueElement& element);
  void add(const TrueOpening& opening);
  void add(const TrueControlPoint& point);
  void add(const TrueBuilding& building);
  void add(const TrueObject& object);
  void add_plant(const TrueObject& plant);  // hedges and shrubs: objects that are not to be found as such
  void add(const TrueTree& tree);
  void add(const TrueKerb& kerb);
  void add(const TruePavement& pavement);
  void add(const TrueCarriageway& road);
  void add(const TrueBlock& block);

  void finish(const std::vector<std::pair<std::string, std::uint64_t>>& counts);

 private:
  struct Spool;
  void append(const std::string& text);
  void add_names(std::string_view kind, const std::map<int, std::string>& names);
  void add_line(std::string_view kind, const std::string& text);

  OutputFile file_;
  Vec3 origin_;
  std::vector<std::unique_ptr<Spool>> spools_;
};

// Returns NAME.truth.json for NAME.las.
std::filesystem::path truth_path(const std::filesystem::path& cloud);

}  // namespace ilot::scan
