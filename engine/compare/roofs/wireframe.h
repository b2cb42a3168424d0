// SPDX-License-Identifier: Apache-2.0
// Compares the edges of drawn roofs with true wireframes, as the Building3D benchmark does (Wang et al. 2023).
#pragma once
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/compare/truth.h"
#include "engine/model/polygon_model.h"

namespace ilot {

constexpr double kEdgeShare = 0.1;     // an edge is right within this share of the radius of the building's points
constexpr double kCloseEdge = 0.3;     // metres: the fixed tolerance that is stated beside
constexpr double kShortEdge = 0.5;     // metres: shorter edges are counted
constexpr double kStraightDeg = 2;     // a corner of a ring that bends less is left out
constexpr double kSameFace = 0.01;     // metres: two faces whose corners agree so well are one face of one plane
constexpr double kSameCorner = 0.001;  // metres: corners of equal edges

struct Edge3 {
  Vec3 a, b;
};

// The true edges of one building.
struct Wireframe {
  std::string name;
  std::vector<Edge3> edges;
  double radius = 0;  // of the building's points: largest distance from their mean
};

struct RoofEdge {
  Edge3 edge;
  bool inside_face = false;  // between two faces that lie in one plane
  bool of_outline = false;   // above a whole edge of the ground's rings
};

// Counts of edges. Those of several buildings are added.
struct EdgeScore {
  std::uint64_t truth = 0, drawn = 0;
  std::uint64_t matched = 0, close = 0;  // within the share of the radius, and within kCloseEdge
  double corners_m = 0;                  // sum over matched edges of the mean distance of their two corners
  std::uint64_t judged_length = 0;       // drawn edges that may be judged by their length
  std::uint64_t short_edges = 0;         // those of them shorter than kShortEdge

  void add(const EdgeScore& other);
  // No value where nothing was drawn, or nothing is true.
  std::optional<double> precision() const, recall() const, f1() const, f1_close() const;
  std::optional<double> corner_offset_m() const, drawn_over_true() const, short_share() const;
};

// The edges of the rings of the model's roof faces; edges whose corners agree within kSameCorner are one. O(n log n).
std::vector<RoofEdge> roof_edges(const PolygonModel& model, double metres_per_unit = 1);

// The edges of the true roof faces of each building, named by its number. The radius is that of their corners.
std::vector<Wireframe> true_wireframes(std::span<const TruePlane> planes, double metres_per_unit);

// The largest distance of a point from the mean of all of them; 0 without points.
double radius_of(std::span<const Vec3> points);
double radius_of(std::span<const Edge3> edges);  // of their corners

// Assigns drawn edges to true ones one to one so that the sum of their Hausdorff distances is least, and counts the
// pairs that are near enough. Where the outline was given (a footprint), its own short edges are not judged by length,
// and edges inside of a face never are. O(n^2 m) with n the smaller number of edges.
EdgeScore compare_edges(const Wireframe& truth, std::span<const RoofEdge> drawn, bool outline_given,
                        double metres_per_unit = 1);

// Compares models with several wireframes. Each model belongs to one wireframe: the one whose box in plan has the
// greatest intersection over union with its own, or the one with the nearest centre where no box meets it. So every
// drawn edge counts. Returns one score for each wireframe.
std::vector<EdgeScore> compare_wireframes(std::span<const Wireframe> truth, std::span<const PolygonModel> models,
                                          bool outline_given, double metres_per_unit = 1);

}  // namespace ilot
