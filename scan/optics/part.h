// SPDX-License-Identifier: Apache-2.0
// What the scenes on the ground are made of: convex solids bounded by planes and one quadric, flat panels with
// openings, and the insides of quadrics (soffits of arches). All are opaque. Intersections are computed in double;
// where parts meet, builders let them overlap by kOverlap, so that no ray slips through a joint.
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

namespace ilot::scan {

// Metres by which neighbouring parts overlap: far above the rounding of doubles, far below the grid of the points.
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

// The part of a ray inside the (convex) quadric; a cone is its one nappe. Nothing when the ray misses it.
std::optional<Chord> chord(const Ray& ray, const Quadric& quadric);

// Outward unit normal at a point of the surface.
Vec3 normal_at(const Quadric& quadric, Vec3 point);

// The intersection of half-spaces (outward normals) and, if any, the inside of a quadric. Faces are numbered as the
// planes, then the quadric.
struct Solid {
  static constexpr std::size_t kMaxPlanes = 10;
  std::array<Plane, kMaxPlanes> planes;
  std::array<SurfaceId, kMaxPlanes + 1> surfaces{};  // per face; surface of the quadric at [plane_count]
  std::uint32_t plane_count = 0;
  Quadric quadric;
  Box3<Vec3> bounds;
};

// A hole in a panel: a rectangle whose upper side may be the arc of a circle. The arc's centre lies on the middle of
// the opening; rise is how far its crown stands above the springing: width / 2 for a round arch, 0 for none.
struct Opening {
  double left = 0, right = 0, bottom = 0, springing = 0, rise = 0;
};
double arch_radius(const Opening& opening);
bool contains(const Opening& opening, FlatPoint p);

// A flat region, seen from both sides: inside the ring and in none of the openings. x and y run along u and v from the
// origin; u, v of unit length and perpendicular. The plane's normal is u x v.
struct Panel {
  Vec3 origin, u, v;
  std::vector<FlatPoint> ring;  // simple, either way round, not closed
  std::vector<Opening> openings;
  SurfaceId surface = 0;
};

// The part of a quadric inside all half-spaces, seen from both sides.
struct Shell {
  Quadric quadric;
  std::vector<Plane> clips;  // kept where the signed distance is at most 0
  SurfaceId surface = 0;
  Box3<Vec3> bounds;
};

using Part = std::variant<Solid, Panel, Shell>;

struct PartHit {
  double t = 0;
  SurfaceId surface = 0;
  Vec3 normal;  // unit length, towards the ray's origin
};

// The first place beyond `from` where the ray meets the part; a solid only where it enters. Deterministic and, for one
// solid, watertight.
std::optional<PartHit> meet(const Ray& ray, const Part& part, double from);

Box3<Vec3> bounds_of(const Part& part);

// Solids from simple descriptions. All their faces get `surface`; change single ones afterwards.

// A convex ring of at most 8 points in a plane, swept along `sweep`. Faces: the sides from ring[i] to ring[i + 1], then
// the ring itself, then its copy.
Solid prism(std::span<const Vec3> ring, Vec3 sweep, SurfaceId surface);

// A cylinder with flat ends. Faces: the base, the top, the mantle.
Solid cylinder(Vec3 base, Vec3 axis, double length, double radius, SurfaceId surface);

// A cone cut at two distances from its apex. Faces: the end nearer to the apex, the other, the mantle.
Solid cone(Vec3 apex, Vec3 axis, double from, double to, double tangent, SurfaceId surface);

Solid sphere(Vec3 centre, double radius, SurfaceId surface);

// The part of a solid behind a plane. Its new face is the last plane; the bounds stay.
void cut(Solid& solid, const Plane& plane, SurfaceId surface);

}  // namespace ilot::scan
