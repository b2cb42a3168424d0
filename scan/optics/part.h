// SPDX-License-Identifier: Apache-2.0
// The parts of the scenes on the ground: convex solids bounded by planes and one quadric, flat panels with openings,
// sheets that are not quite flat, the inner sides of quadrics (soffits of arches), and the triangles of models that
// others made. All parts are opaque.
// Intersections are computed in double. Where parts meet, builders let them overlap by kOverlap, so that no ray passes
// through a joint.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <variant>
#include <vector>

#include "kernels/geometry/box3.h"
#include "kernels/geometry/flat.h"
#include "scan/optics/solid.h"
#include "scan/optics/wall_form.h"

namespace ilot::scan {

// Metres by which neighbouring parts overlap. This is far above the rounding of doubles and far below the grid of the
// points.
constexpr double kOverlap = 1e-6;

// Index into the surfaces of a scene.
using SurfaceId = std::uint32_t;

struct Quadric {
  enum class Kind : std::uint8_t { none, cylinder, sphere, cone } kind = Kind::none;
  Vec3 point;          // on the axis; centre of a sphere; apex of a cone
  Vec3 axis{0, 0, 1};  // unit length; a cone opens along it
  double radius = 0;   // cylinder, sphere
  double tangent = 0;  // cone: radius gained per metre
};

// Returns the part of a ray inside the quadric, which is convex. Only one nappe of a cone counts. Returns nothing when
// the ray misses the quadric.
std::optional<Chord> chord(const Ray& ray, const Quadric& quadric);

// Returns the outward unit normal at a point of the surface.
Vec3 normal_at(const Quadric& quadric, Vec3 point);

// The intersection of half-spaces (with outward normals) and, if there is a quadric, its inside. Faces are numbered in
// the order of the planes. The quadric has the last number.
struct Solid {
  static constexpr std::size_t kMaxPlanes = 10;
  std::array<Plane, kMaxPlanes> planes;
  std::array<SurfaceId, kMaxPlanes + 1> surfaces{};  // per face; surface of the quadric at [plane_count]
  std::uint32_t plane_count = 0;
  Quadric quadric;
  Box3<Vec3> bounds;
};

// The form of an arch. A pointed arch rises by at least half of its width, a basket arch by less.
enum class ArchHead : std::uint8_t { circular, basket, pointed };

// A hole in a panel: a rectangle whose upper side may be an arch. The centre of a circular arch lies on the vertical
// axis of the opening. `rise` is the height of the crown above the springing: width / 2 for a round arch, 0 for no
// arch. The other forms are described in arch.h.
struct Opening {
  double left = 0, right = 0, bottom = 0, springing = 0, rise = 0;
  ArchHead head = ArchHead::circular;
};
double arch_radius(const Opening& opening);
bool contains(const Opening& opening, FlatPoint p);

// A flat region that is visible from both sides. It is inside the ring and in none of the openings. x and y run along u
// and v from the origin. u and v are perpendicular and of unit length. The normal of the plane is u x v.
struct Panel {
  Vec3 origin, u, v;
  std::vector<FlatPoint> ring;  // simple, clockwise or counter-clockwise, not closed
  std::vector<Opening> openings;
  SurfaceId surface = 0;
};

// A panel that is not quite flat: a wall that leans and bows, rough or of stones. The form counts from the plane of the
// panel along its normal; (x, z) are the facade's coordinates of the panel's origin, u runs along x and v along z.
// Joints have a surface of their own.
struct Sheet {
  Panel panel;
  double x = 0, z = 0;
  WallForm form;
  WallRelief relief;
  SurfaceId joint_surface = 0;
};

// The part of a quadric inside all half-spaces. It is visible from both sides.
struct Shell {
  Quadric quadric;
  std::vector<Plane> clips;  // a point is kept where the signed distance is at most 0
  SurfaceId surface = 0;
  Box3<Vec3> bounds;
};

// A triangle that is visible from both sides. A ray that goes through the common edge of two triangles with the same
// corners meets one of them at least.
struct Facet {
  Vec3 a, b, c;
  Vec3 normal;  // unit length, along (b - a) x (c - a)
  SurfaceId surface = 0;
};

using Part = std::variant<Solid, Panel, Shell, Sheet, Facet>;

struct PartHit {
  double t = 0;
  SurfaceId surface = 0;
  Vec3 normal;  // unit length, towards the ray's origin
};

// Returns the first position beyond `from` where the ray meets the part. A solid is met only where the ray enters it.
// The result is deterministic and, for one solid, watertight.
std::optional<PartHit> meet(const Ray& ray, const Part& part, double from);

Box3<Vec3> bounds_of(const Part& part);

// The functions below make solids from simple descriptions. All faces get `surface`. Change single faces afterwards.

// Returns nothing for corners on a line.
std::optional<Facet> facet(Vec3 a, Vec3 b, Vec3 c, SurfaceId surface);

// Returns a prism: a convex ring of at most 8 points in a plane, swept along `sweep`. Its faces are the sides from
// ring[i] to ring[i + 1], then the ring itself, then the copy of the ring.
Solid prism(std::span<const Vec3> ring, Vec3 sweep, SurfaceId surface);

// Returns a cylinder with flat ends. Its faces are the base, the top and the mantle.
Solid cylinder(Vec3 base, Vec3 axis, double length, double radius, SurfaceId surface);

// Returns a cone that is cut at two distances from its apex. Its faces are the end nearer to the apex, the other end
// and the mantle.
Solid cone(Vec3 apex, Vec3 axis, double from, double to, double tangent, SurfaceId surface);

Solid sphere(Vec3 centre, double radius, SurfaceId surface);

// Keeps the part of a solid behind a plane. The new face is the last plane. The bounds do not change.
void cut(Solid& solid, const Plane& plane, SurfaceId surface);

}  // namespace ilot::scan
