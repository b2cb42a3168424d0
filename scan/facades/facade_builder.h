// SPDX-License-Identifier: Apache-2.0
// Builds facades from readable pieces, and the truth along with them. Coordinates of a facade: x along it to the right
// seen from outside, out of the wall towards the street, z up.
#pragma once
#include <array>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "scan/scanners/terrestrial.h"

namespace ilot::scan {

// A place and its directions: the facade's lower left corner, along the wall, out of it.
struct FacadeFrame {
  Vec3 origin, along{1, 0, 0}, out{0, -1, 0};
  Vec3 place(double x, double outward, double z) const { return origin + x * along + outward * out + Vec3{0, 0, z}; }
};

// What a piece is: one of the scene's classes, the element it belongs to (0 = none) and what it is made of.
struct Finish {
  std::uint8_t surface_class = 0;
  std::uint32_t element = 0;
  Material material = Material::render;
};

// Whether the faces of a piece are planes of the truth, or too small to be.
enum class Faces { true_planes, unnamed };

struct Block {
  double x0 = 0, x1 = 0, out0 = 0, out1 = 0, z0 = 0, z1 = 0;
};

// Adds parts, planes and elements to a scene. Flat pieces parallel to the facade that touch, lie at the same distance
// and are of the same class share one plane; every other has its own.
class FacadeBuilder {
 public:
  FacadeBuilder(TerrestrialScene& scene, const FacadeFrame& frame, std::uint32_t facade)
      : scene_(scene), frame_(frame), facade_(facade) {}

  const FacadeFrame& frame() const { return frame_; }
  std::uint32_t facade() const { return facade_; }

  // An element without geometry of its own yet; returns its id.
  std::uint32_t add_element(TrueElement element);

  void add_opening(std::uint32_t element, std::vector<Vec3> ring);
  void control_point(const char* group, std::uint32_t element, double x, double out, double z);

  // A rectangle parallel to the facade with openings.
  void wall(double x0, double x1, double z0, double z1, double out, const std::vector<Opening>& openings,
            const Finish& finish);

  // A flat piece in any direction: ring in x, out, z.
  void plate(const std::vector<Vec3>& ring, const Finish& finish, Faces faces = Faces::true_planes);

  // A box. Its back, where it meets the wall, is no plane of the truth.
  void block(const Block& block, const Finish& finish, Faces faces = Faces::true_planes);

  // A convex profile in (out, z), swept from x0 to x1.
  void moulding(const std::vector<FlatPoint>& profile, double x0, double x1, const Finish& finish,
                Faces faces = Faces::true_planes);

  // A convex shape in (x, z), swept outwards from out0 to out1.
  void relief(const std::vector<FlatPoint>& shape, double out0, double out1, const Finish& finish,
              Faces faces = Faces::true_planes);

  // A round upright bar or post.
  void post(double x, double out, double z0, double z1, double radius, const Finish& finish);

  // The sides of an opening from out0 back to out1: jambs, ledge and soffit, which is a part of a cylinder under an
  // arch.
  enum class Ledge { with, without };
  void reveal(const Opening& opening, double out0, double out1, const Finish& finish, Ledge ledge = Ledge::with);

  // Any part, as it is.
  void add(Part part) { scene_.model.parts.push_back(std::move(part)); }

  // A surface that belongs to no plane of the truth.
  SurfaceId surface(const Finish& finish, std::uint32_t plane = 0);

  // The outline of an opening in the facade's plane, from the lower left counter-clockwise; arcs as chords of at most
  // chord_deg.
  std::vector<Vec3> outline(const Opening& opening, double out, double chord_deg = 5) const;

  TerrestrialScene& scene() { return scene_; }

 private:
  std::uint32_t next_id() const { return static_cast<std::uint32_t>(scene_.planes.size() + scene_.shapes.size() + 1); }
  std::uint32_t plane_parallel(double out, const Finish& finish, TruePolygon polygon);
  std::uint32_t own_plane(const Plane& plane, const Finish& finish, std::vector<Vec3> ring);
  void sweep(const std::vector<Vec3>& ring, Vec3 way, const Finish& finish, Faces faces);

  TerrestrialScene& scene_;
  FacadeFrame frame_;
  std::uint32_t facade_;
  // A flat piece parallel to the facade: where it lies, and which of the scene's planes it belongs to.
  struct Piece {
    FlatPoint low, high;
    std::size_t plane;
  };
  std::map<std::pair<std::int64_t, std::uint8_t>, std::vector<Piece>> parallel_;  // by tenths of a millimetre and class
};

// Height of the crown of an opening.
double top_of(const Opening& opening);

// Half the angle that its arch spans at its centre.
double arch_half_angle_deg(const Opening& opening);

}  // namespace ilot::scan
