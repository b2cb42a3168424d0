// SPDX-License-Identifier: Apache-2.0
// The facades that a run drew, read back from its folder: the plan of one facade is what is on it, where, and how sure
// that is. Coordinates in the CRS of the inputs and its units; names that end in _m and _deg are metres and degrees.
//
//   for (const ilot::Facade& facade : ilot::read_facades("out"))
//     for (const ilot::FacadeElement& e : facade.elements)
//       if (e.kind == "window") std::printf("%u: %g x %g m\n", e.id, e.width_m, e.height_m);
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

// How an element or an edge came about.
enum class DrawnStatus : std::uint8_t {
  seen,       // points on it
  completed,  // carried over from its family or its neighbours, no points of its own
  occluded,   // lies in a laser shadow: not known
  by_hand,    // a person drew or corrected it (RunOptions::edits): it has no stated error
};

struct FacadeArc {
  Vec3 centre;
  double radius_m = 0, from_deg = 0, to_deg = 0;  // in the facade's plane, from its right axis towards up
};

// What a part of a facade is for who builds on it [Lorraine thesis, 4.1].
enum class FacadeRegion : std::uint8_t {
  facade,        // the wall itself: a polygon
  element,       // windows, doors, sills, balconies: a polyhedron
  irregularity,  // where the wall is not even: a mesh
};

// An element in space. Faces of a closed body turn outwards; those of a mesh are triangles that turn out of the wall.
struct FacadeBody {
  bool closed = false;
  std::vector<Vec3> vertices;  // CRS
  std::vector<std::vector<std::uint32_t>> faces;
};

// The edge from vertex i of the ring to the next one.
struct FacadeEdge {
  DrawnStatus status = DrawnStatus::seen;
  std::uint64_t points = 0;                   // support: points of the surfaces that meet in it, near it
  double rms_m = 0;                           // of these points to those surfaces
  double error_m = 0;                         // bound on its place [Lorraine thesis, 4.3]
  double moved_m = 0;                         // by regularisation, at most, at its ends [Marchand 2018, II.3.2]
  std::optional<double> occluded_share = {};  // of its length, that no station could see; none: no station is known
  double covered_share = 0;                   // of its length, with points near
};

// A surface of an element, of all its flat pieces that look the same way.
struct FacadeFace {
  std::string name;                           // front, bottom, right, top, left
  std::uint64_t points = 0;                   // support
  double rms_m = 0;                           // of these points to it
  std::optional<double> occluded_share = {};  // of its area
};

struct FacadeElement {
  std::uint32_t id = 0;               // dense from 1 within the facade
  std::string kind;                   // window, door, sill, lintel, balcony, band, bulge, stone, joint, outline...
  bool opening = false;               // a hole in the wall: windows and doors
  std::uint32_t family = 0;           // equal elements share it; 0 = none
  std::uint32_t row = 0, column = 0;  // from 1, bottom up and left to right; 0 = none
  DrawnStatus status = DrawnStatus::seen;
  std::string reason;             // of a status other than seen
  std::vector<Vec3> ring;         // CRS; counter-clockwise seen from outside, the last corner not repeated
  std::vector<FacadeEdge> edges;  // as many as corners, or none when nothing is known of them
  std::vector<FacadeArc> arcs;
  double width_m = 0, height_m = 0, depth_m = 0;  // along right, up and out of the wall (recesses negative)
  double width_error_m = 0, height_error_m = 0, depth_error_m = 0;
  std::uint64_t points = 0;
  FacadeRegion region = FacadeRegion::element;
  FacadeBody body{};  // [Lorraine thesis, 4.2.1 and 4.2.2]; without vertices where its ring and its depth say all
  std::vector<FacadeFace> faces{};  // what points and stations say for each
};

struct Facade {
  std::uint32_t id = 0;
  std::string crs;              // EPSG:n, or empty
  Vec3 origin, right, up, out;  // a point of the wall and its axes of unit length, right x up = out
  double width_m = 0, height_m = 0;
  std::vector<FacadeElement> elements;
};

// Reads facades/facade-NNN.json of a run with the product facades, by number: the largest wall first. All is held in
// memory, about what the files take. O(bytes). Several threads may read at once. Error (usage) when there are no
// facades in the folder; a damaged file is an Error that names the file and the place.
std::vector<Facade> read_facades(const std::filesystem::path& run_folder);

}  // namespace ilot
