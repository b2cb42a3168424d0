// SPDX-License-Identifier: Apache-2.0
// Every value that a user can set and that can change a result, with its default. Lengths are metres, angles
// degrees, whatever the unit of the input. nullopt = auto: computed from the measured sampling step and noise. Their
// ranges, and settings as text: parameters.h. A field has the same name there: planes.epsilon.
//
//   ilot::Settings settings;
//   settings.planes.epsilon = 0.02;
#pragma once
#include <cstdint>
#include <optional>
#include <vector>

#include "ilot/advanced_settings.h"

namespace ilot {

struct IndexSettings {
  std::uint64_t block_points = 1u << 20;  // most points in one block of the store
  double finest_step = 0.0001;            // metres; coordinates in finer steps are rounded to it
  bool keep_strays = false;               // points that stand alone, far from all others
};

struct NormalsSettings {
  int neighbours = 16;     // nearest points that a normal is fitted to
  double max_radius = 10;  // metres; neighbours farther away are not used
  bool write = false;      // write NormalX, NormalY, NormalZ
};

// Ways to find planes; docs/methods.md tells when to use which.
enum class PlaneMethod : std::uint8_t {
  ransac,
  region_growing,
  smooth_growing,
  split_merge,
  hough,
  shape_ransac,
  roof_ransac,
  facade_ransac,
  colour_ransac,
};

// Points that take no part in the search for planes (docs/methods.md, A1); labels may still reach them.
enum class Cleaning : std::uint8_t {
  none,
  density,    // whose neighbourhood is much sparser than the mean
  distance,   // in clusters of fewer than min_points, farther than the connectivity from the rest
  isolation,  // isolated among their own neighbours
};

// What epsilon is chosen by where it is auto.
enum class EpsilonBy : std::uint8_t {
  noise,  // 3.5 times the noise
  knee,   // the knee of MSE(epsilon) of the largest plane (docs/methods.md, C4)
};

struct PlanesSettings {
  std::optional<PlaneMethod> method;
  std::optional<double> epsilon;       // metres; greatest distance of a labelled point from its plane
  std::optional<double> normal_angle;  // degrees; greatest angle between a point's normal and its plane's
  std::optional<int> min_points;       // fewest points of a plane
  std::optional<double> connectivity;  // metres; points of one plane farther apart than this are two planes
  double join_angle = 4;               // degrees; planes that meet at a cell border join below this angle
  double probability = 0.99;           // that the best plane was among those tried
  Cleaning cleaning = Cleaning::none;
  EpsilonBy epsilon_by = EpsilonBy::noise;
  int colour_classes = 6;      // that colours are parted into where points have them; 0 = none
  std::optional<bool> curved;  // spheres, cylinders and cones too, before planes
  int curved_points = 300;     // fewest points of one of these
};

enum class StepSource : std::uint8_t { stations, neighbours };          // the sampling step around a point comes from
enum class BoundaryRule : std::uint8_t { circumradius, longest_edge };  // what keeps a triangle out of an outline
enum class EdgeLength : std::uint8_t { plane, space };                  // how the edges of triangles are measured
enum class Erosion : std::uint8_t { everywhere, outside };              // gaps that open outlines: all, or outer ones

struct BoundariesSettings {
  double gamma = 1;  // threshold around a point over the sampling step there, the diagonal of a cell of its raster
  std::optional<double> threshold;  // metres; the same for all points, whatever the step
  std::optional<StepSource> step;
  BoundaryRule rule = BoundaryRule::circumradius;
  EdgeLength edge_length = EdgeLength::plane;  // of longest_edge
  Erosion erosion = Erosion::everywhere;
  double tolerance = 0.001;         // metres; outlines are thinned to within it
  std::optional<int> density_maps;  // planes, the largest first, whose density is written beside the predicted one
};

// What attributes of buildings are called: by names of our own, or by those that roofer writes (rf_*).
enum class AttributeStyle : std::uint8_t { plain, roofer };

struct RoofsSettings {
  bool trust_classes = true;               // false: ground and buildings are found by shape
  std::optional<double> cluster_distance;  // metres; building points farther apart in plan are two buildings
  std::optional<int> cluster_points;       // fewest points of a building without a footprint
  double margin = 0.5;                     // metres; points outside all outlines but so near to one are its own
  std::optional<double> epsilon;           // metres; farthest that a point lies from its roof face
  std::optional<int> min_points;           // fewest points of a roof face
  std::optional<double> least_face_area;   // m2; smaller faces go to their neighbour
  double detail = 0.15;                    // metres; faces that differ by less are drawn as one; 0 = every plane
  bool superstructures = true;             // false: the main roof alone
  double lod13_step = 3;                   // metres between parts of LoD1.3; 0 = no LoD1.3
  bool dtm = false;                        // true: a raster of the heights of the ground
  AttributeStyle attribute_style = AttributeStyle::plain;
  AdvancedRoofs advanced;
};

// Where a street was scanned from: by a vehicle or on foot, or by an aircraft.
enum class StreetView : std::uint8_t { street, air };

struct StreetsSettings {
  std::optional<StreetView> view;
  std::optional<double> pixel;  // metres; of the images from above
  double flat = 1;              // metres; heights of neighbours on the ground differ by at most this
  double longest_gap = 0.5;     // metres; gaps between scan lines are closed up to it
  double longest_link = 10;     // metres; shadows on the ground are crossed up to it
  double least_height = 0.1;    // metres; lower things are part of the ground
  double least_area = 0.0125;   // m2; smaller peaks are no things of their own
  double rise = 0.05;           // metres; what stands so much above the pass to a higher thing is a thing of its own
  bool trust_classes = true;    // objects whose points have class codes of vegetation are vegetation
  AdvancedStreets advanced;
};

// Whose names the layers of drawings have.
enum class LayerNames : std::uint8_t { ilot, aia, iso13567 };

// Of the texts of drawings.
enum class SheetLanguage : std::uint8_t { english, french, german, dutch };

struct FacadesSettings {
  double least_width = 2, least_height = 2;         // metres; of a facade
  double bias = 0.03;                               // metres; walls whose planes differ by less are one facade
  double gap = 3;                                   // metres between two parts of one facade
  double relief = 1.5;                              // metres; what stands so far before a facade belongs to it
  double least_opening = 0.3;                       // metres; width and height of a window
  double alike = 0.04;                              // metres; what differs by less may have been meant equal
  bool regularise = true;                           // rows, columns and families line up within their errors
  bool keep_unlikely = false;                       // openings that are more likely none stay openings
  double scale = 50;                                // of drawings, 1 : scale
  LayerNames layers = LayerNames::ilot;             // of drawings
  SheetLanguage language = SheetLanguage::english;  // of drawings
  std::vector<double> sections;                     // heights, CRS units, that facades are also cut at
  std::vector<double> upright_sections;             // metres from the left end of each, upright cuts
  std::vector<double> section_lines;                // x0, y0, x1, y1 of each, CRS units, upright cuts
  std::vector<int> side;                            // numbers of facades that are drawn from their other side
  AdvancedFacades advanced;
};

struct ClassesSettings {
  std::vector<int> ground{2};
  std::vector<int> building{6};
  std::vector<int> noise{7, 18};
  std::vector<int> vegetation{3, 4, 5};
  bool write = false;  // true: points of classes 0 and 1 get the class of the ground or of buildings in labelled clouds
};

struct Settings {
  std::uint64_t seed = 0;  // varies the random draws; any value is reproducible
  IndexSettings index;
  NormalsSettings normals;
  PlanesSettings planes;
  BoundariesSettings boundaries;
  RoofsSettings roofs;
  StreetsSettings streets;
  FacadesSettings facades;
  ClassesSettings classes;
};

}  // namespace ilot
