// SPDX-License-Identifier: Apache-2.0
// Builds facades from simple pieces and records the truth about them. In the coordinates of a facade, x runs along it
// to the right as seen from outside, `out` points from the wall towards the street, and z points up.
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

inline constexpr Vec3 kUp{0, 0, 1};

// A position with two directions: the lower left corner of the facade, the direction along the wall, and the direction
// out of it. Everything on a wall that leans or bows goes with it.
struct FacadeFrame {
  Vec3 origin, along{1, 0, 0}, out{0, -1, 0};
  WallForm form = {};
  Vec3 place(double x, double outward, double z) const {
    return origin + x * along + (outward + form.at(x, z)) * out + Vec3{0, 0, z};
  }
};

// Describes a piece: its class of the scene, the element that it belongs to (0 = none), and its material.
struct Finish {
  std::uint8_t surface_class = 0;
  std::uint32_t element = 0;
  Material material = Material::render;
  std::uint8_t tone = 0;
};

// States whether the faces of a piece are planes of the truth. Some are too small to be planes.
enum class Faces { true_planes, unnamed };

struct Block {
  double x0 = 0, x1 = 0, out0 = 0, out1 = 0, z0 = 0, z1 = 0;
};

// Adds parts, planes and elements to a scene. Flat pieces parallel to the facade share one plane if they touch, lie at
// the same distance and are of the same class. Every other piece has a plane of its own.
class FacadeBuilder {
 public:
  FacadeBuilder(TerrestrialScene& scene, const FacadeFrame& frame, std::uint32_t facade)
      : scene_(scene), frame_(frame), facade_(facade) {}

  const FacadeFrame& frame() const { return frame_; }
  std::uint32_t facade() const { return facade_; }

  // Adds an element that has no geometry of its own yet. Returns its id.
  std::uint32_t add_element(TrueElement element);

  void add_opening(std::uint32_t element, std::vector<Vec3> ring);
  void control_point(const char* group, std::uint32_t element, double x, double out, double z);

  // Adds a rectangle parallel to the facade, with openings.
  void wall(double x0, double x1, double z0, double z1, double out, const std::vector<Opening>& openings,
            const Finish& finish);

  // Adds the same rectangle with a fine relief. Stones are parts of it; joints have the finish `joint`.
  void wall(double x0, double x1, double z0, double z1, double out, const std::vector<Opening>& openings,
            const Finish& finish, const WallRelief& relief, const Finish& joint);

  // Adds a flat piece in any direction. The ring is in x, out, z.
  void plate(const std::vector<Vec3>& ring, const Finish& finish, Faces faces = Faces::true_planes);

  // Adds a box. Its back touches the wall and is not a plane of the truth.
  void block(const Block& block, const Finish& finish, Faces faces = Faces::true_planes);

  // Adds a convex profile in (out, z) that is swept from x0 to x1.
  void moulding(const std::vector<FlatPoint>& profile, double x0, double x1, const Finish& finish,
                Faces faces = Faces::true_planes);

  // Adds a convex shape in (x, z) that is swept outwards from out0 to out1.
  void relief(const std::vector<FlatPoint>& shape, double out0, double out1, const Finish& finish,
              Faces faces = Faces::true_planes);

  // Adds a round upright bar or post.
  void post(double x, double out, double z0, double z1, double radius, const Finish& finish);

  // Adds the sides of an opening from out0 back to out1: jambs, ledge and soffit. Under an arch the soffit is a part of
  // a cylinder.
  enum class Ledge { with, without };
  void reveal(const Opening& opening, double out0, double out1, const Finish& finish, Ledge ledge = Ledge::with);

  // Adds any part without a change.
  void add(Part part) { scene_.model.parts.push_back(std::move(part)); }

  // Adds a surface that belongs to no plane of the truth.
  SurfaceId surface(const Finish& finish, std::uint32_t plane = 0);

  // Returns the outline of an opening in the plane of the facade, counter-clockwise from the lower left. Arcs are
  // chords of at most chord_deg degrees.
  std::vector<Vec3> outline(const Opening& opening, double out, double chord_deg = 5) const;

  TerrestrialScene& scene() { return scene_; }

 private:
  std::uint32_t next_id() const { return static_cast<std::uint32_t>(scene_.planes.size() + scene_.shapes.size() + 1); }
  Panel panel_of(double x0, double x1, double z0, double z1, double out, const std::vector<Opening>& openings,
                 TruePolygon& polygon) const;
  void soffit(const Opening& opening, double out0, double out1, const Finish& finish);
  std::uint32_t bowed_plane(const Finish& finish, TruePolygon polygon);
  std::uint32_t plane_parallel(double out, const Finish& finish, TruePolygon polygon);
  std::uint32_t own_plane(const Plane& plane, const Finish& finish, std::vector<Vec3> ring);
  void sweep(const std::vector<Vec3>& ring, Vec3 way, const Finish& finish, Faces faces);

  TerrestrialScene& scene_;
  FacadeFrame frame_;
  std::uint32_t facade_;
  // A flat piece parallel to the facade: its extent, and the index of its plane in the scene.
  struct Piece {
    FlatPoint low, high;
    std::size_t plane;
  };
  std::map<std::pair<std::int64_t, std::uint8_t>, std::vector<Piece>> parallel_;  // by tenths of a millimetre and class
};

// Returns the height of the crown of an opening.
double top_of(const Opening& opening);

// Returns half the angle that the arch of the opening spans at its centre.
double arch_half_angle_deg(const Opening& opening);

}  // namespace ilot::scan
