// SPDX-License-Identifier: Apache-2.0
// The truth of a scene: NAME.truth.json as the virtual scanner writes it, or as anyone writes it by hand.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/model/polygon_model.h"
#include "kernels/core/types.h"

namespace ilot {

using Ring3 = std::vector<Vec3>;  // closed; the last corner is not repeated

struct TruePolygon {
  std::uint32_t building = 0;
  Ring3 ring;
  std::vector<Ring3> holes;
};

struct TruePlane {
  std::uint32_t id = 0;  // the value of true_plane
  std::string class_name;
  Plane plane;  // world coordinates; unit normal
  std::vector<TruePolygon> polygons;
};

struct TrueOpening {
  std::uint32_t id = 0, facade = 0;
  Ring3 ring;
};

// An element of a facade. Files that are written by hand may contain only the id and the kind.
struct TrueElement {
  std::uint32_t id = 0, facade = 0;  // `id` is the value of true_element; facade 0 = no facade
  std::string kind;
  std::uint32_t row = 0, column = 0;
  Ring3 ring;
  double width_m = 0, height_m = 0, depth_m = 0;
};

struct TrueControlPoint {
  std::string group;
  std::uint32_t element = 0;
  Vec3 position;
};

struct TrueObject {
  std::uint32_t id = 0;  // the value of true_element
  std::string class_name;
  std::uint64_t points = 0;
  bool has_group = false;  // truth files of earlier versions have none: their classes are groups
};

struct TrueTree {
  std::uint32_t id = 0;  // the value of true_element
  Vec3 base;             // of the trunk
  double height_m = 0, crown_base_m = 0, crown_radius_m = 0;
};

struct TrueKerb {
  Ring3 line;           // open; on the upper edge
  double height_m = 0;  // of the step
};

// A piece of pavement along a kerb.
struct TruePavement {
  Ring3 line;              // open; the kerb
  double width_m = 0;      // as built
  double to_facade_m = 0;  // from the kerb to the house behind it; 0 = none
};

// A piece of road, in plan.
struct TrueCarriageway {
  Ring3 ring;  // open
};

// What an object, a tree or a plant has below 2.2 m, in plan.
struct TrueOutline {
  Ring3 ring;                // convex, counter-clockwise
  bool is_boundary = false;  // a fence, a free-standing wall or a hedge
  bool moves = false;        // during the scan, or it was not there all the time
};

struct Truth {
  std::map<std::uint32_t, std::string> classes;  // names of true_class; class 0 is never judged
  std::vector<TruePlane> planes;
  std::vector<TrueElement> elements;
  std::vector<TrueOpening> openings;
  std::vector<TrueControlPoint> control_points;
  std::vector<TrueObject> objects;
  std::vector<TrueTree> trees;
  std::vector<TrueKerb> kerbs;
  std::vector<TruePavement> pavements;
  std::vector<TrueCarriageway> carriageways;
  std::vector<TrueOutline> outlines;
  std::vector<std::uint32_t> buildings;  // ids
  bool has_openings = false, has_control_points = false, has_objects = false, has_buildings = false;
  bool has_trees = false, has_kerbs = false, has_pavements = false, has_carriageways = false;
};

// Arrays that are not in the file are empty; other keys than those above are ignored. What is in the file must have its
// form: otherwise an Error names file and position. Memory is some ten times the file's size.
Truth read_truth(const std::filesystem::path& path);
Truth parse_truth(std::string_view text, const std::string& name);

// Uses true models of buildings as the truth. Their roofs (roof_faces()) become planes of class `roof`. The ids of
// planes are from 1 in the order of models and faces, and buildings are numbered in the same way.
Truth truth_of_models(std::span<const PolygonModel> models);

}  // namespace ilot
