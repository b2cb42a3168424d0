// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cmath>

#include "scan/streets/street_houses.h"
#include "scan/wild/street/wild_street.h"

namespace ilot::scan {
namespace {

constexpr double kGroundDepth = 4;  // metres below the surface that the slabs of the ground reach
constexpr double kLeastKerb = 0.015;

// Returns the positions where a stretch meets the knots of the profile, its ends included.
std::vector<double> cuts_of(const WildStreet& street, double s0, double s1) {
  std::vector<double> cuts{s0};
  for (const ProfileKnot& knot : street.profile)
    if (knot.s > s0 + 1e-6 && knot.s < s1 - 1e-6) cuts.push_back(knot.s);
  cuts.push_back(s1);
  return cuts;
}

// Adds the slab of a patch between two cuts: its top is a plane, its upright sides are kerbs and the faces of terraces.
void add_slab(WildStreetModel& model, const WildStreet& street, const GroundPatch& patch, double s0, double s1) {
  const auto height = [&](double s, double t) { return street.profile_height(s) + patch.offset + patch.slope * t; };
  const double rise = (height(s1, patch.t0) - height(s0, patch.t0)) / (s1 - s0);
  const Vec3 up{-rise, -patch.slope, 1};
  const Vec3 n = (1 / norm(up)) * up;
  const Plane top{n, -dot(n, {s0, patch.t0, height(s0, patch.t0)})};
  const auto corner = [&](double s, double t) { return Vec3{s, t, height(s, t)}; };
  const std::vector<Vec3> ring{corner(s0, patch.t0), corner(s1, patch.t0), corner(s1, patch.t1), corner(s0, patch.t1)};
  const std::uint32_t id = add_plane(model.street, "ground", top, ring).id;
  Solid slab;
  for (const Plane& plane : {top, Plane{{1, 0, 0}, -s1 - kOverlap}, Plane{{-1, 0, 0}, s0 - kOverlap},
                             Plane{{0, 1, 0}, -patch.t1 - kOverlap}, Plane{{0, -1, 0}, patch.t0 - kOverlap}})
    slab.planes[slab.plane_count++] = plane;
  const auto ground = static_cast<std::uint8_t>(StreetClass::ground);
  slab.surfaces.fill(model.street.scene.add_surface({ground, 0, 0, Material::limestone}));
  slab.surfaces[0] = model.street.scene.add_surface({ground, id, 0, patch.material});
  slab.bounds = {ring[0], ring[0]};
  for (const Vec3& p : ring) slab.bounds.add(p);
  slab.bounds.min = slab.bounds.min - Vec3{kOverlap, kOverlap, kGroundDepth};
  slab.bounds.max = slab.bounds.max + Vec3{kOverlap, kOverlap, kOverlap};
  slab.planes[slab.plane_count++] = {{0, 0, -1}, slab.bounds.min.z};
  model.street.scene.parts.push_back(slab);
}

// Cuts the area of a later patch out of an earlier one. The patches of a passage lie in those of its plot along s.
std::vector<GroundPatch> without(const GroundPatch& patch, const GroundPatch& hole) {
  if (hole.s1 <= patch.s0 || hole.s0 >= patch.s1 || hole.t1 <= patch.t0 || hole.t0 >= patch.t1) return {patch};
  std::vector<GroundPatch> rest;
  GroundPatch part = patch;
  if (hole.s0 > patch.s0) part.s1 = hole.s0, rest.push_back(part);
  part = patch;
  if (hole.s1 < patch.s1) part.s0 = hole.s1, rest.push_back(part);
  part = patch;
  part.s0 = std::max(patch.s0, hole.s0), part.s1 = std::min(patch.s1, hole.s1);
  GroundPatch strip = part;
  if (hole.t0 > part.t0) strip.t1 = hole.t0, rest.push_back(strip);
  strip = part;
  if (hole.t1 < part.t1) strip.t0 = hole.t1, rest.push_back(strip);
  return rest;
}

// Adds the kerb lines on one side of the road.
void add_kerbs(WildStreetModel& model, const WildStreet& street, int side) {
  const double t = side * street.half_road;
  for (const GroundPatch& patch : street.patches) {
    if (patch.kind != GroundPatch::Kind::pavement || (patch.t0 + patch.t1) * side < 0) continue;
    const double height = patch.offset + patch.slope * t + street.camber * street.half_road;
    if (height < kLeastKerb) continue;
    const auto hides = [&](const GroundPatch& other) {
      return &other > &patch && other.kind == GroundPatch::Kind::pavement && (other.t0 + other.t1) * side > 0 &&
             other.s1 > patch.s0 && other.s0 < patch.s1;
    };
    std::vector<GroundPatch> pieces{patch};
    for (const GroundPatch& other : street.patches) {
      if (!hides(other)) continue;
      std::vector<GroundPatch> rest;
      for (const GroundPatch& piece : pieces)
        for (const GroundPatch& left : without(piece, other)) rest.push_back(left);
      pieces = rest;
    }
    for (const GroundPatch& piece : pieces) {
      Kerb kerb{{}, height};
      for (const double s : cuts_of(street, piece.s0, piece.s1))
        kerb.line.push_back({s, t, street.profile_height(s) + patch.offset + patch.slope * t});
      model.kerbs.push_back(std::move(kerb));
    }
  }
}

}  // namespace

void add_wild_ground(WildStreetModel& model, const WildStreet& street) {
  for (std::size_t i = 0; i < street.patches.size(); ++i) {
    std::vector<GroundPatch> pieces{street.patches[i]};
    for (std::size_t j = i + 1; j < street.patches.size(); ++j) {
      std::vector<GroundPatch> rest;
      for (const GroundPatch& piece : pieces)
        for (const GroundPatch& left : without(piece, street.patches[j])) rest.push_back(left);
      pieces = rest;
    }
    for (const GroundPatch& piece : pieces) {
      const std::vector<double> cuts = cuts_of(street, piece.s0, piece.s1);
      for (std::size_t c = 0; c + 1 < cuts.size(); ++c) add_slab(model, street, piece, cuts[c], cuts[c + 1]);
    }
  }
  for (const int side : {1, -1}) add_kerbs(model, street, side);
}

}  // namespace ilot::scan
