// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/facade_shapes.h"

namespace ilot {

const char* name_of(ElementKind kind) {
  constexpr const char* kNames[] = {"window", "door",    "sill",    "lintel",     "balcony", "band", "bulge",
                                    "stone",  "bracket", "shutter", "protrusion", "recess",  "eaves"};
  return kNames[static_cast<int>(kind)];
}

const char* name_of(RayOutcome met) {
  constexpr const char* kNames[] = {"solid", "through", "before"};
  return kNames[static_cast<int>(met)];
}

const char* name_of_cell(std::uint8_t what) {
  constexpr const char* kNames[] = {"unknown", "wall", "open", "blocked", "shallow"};
  return kNames[what];
}

std::vector<Place2> ring_of(const FoundRectangle& r) {
  const Box2 b = r.box();
  const double u = (b.u0 + b.u1) / 2, v = (b.v0 + b.v1) / 2;
  const auto across = [&](Side side, double at) { return r.at(side) + r.lean_of(side) * at; };  // from its middle
  return {{across(Side::left, b.v0 - v), across(Side::bottom, b.u0 - u)},
          {across(Side::right, b.v0 - v), across(Side::bottom, b.u1 - u)},
          {across(Side::right, b.v1 - v), across(Side::top, b.u1 - u)},
          {across(Side::left, b.v1 - v), across(Side::top, b.u0 - u)}};
}

std::vector<Vec3> ring_on_wall(const FacadeReplay& replay, std::span<const Vec3> ring) {
  const Facade& f = replay.facade;
  std::vector<Vec3> placed;
  for (const Vec3& p : ring) {
    const Vec3 d = replay.site.metres_per_unit * (p - f.origin);
    placed.push_back({dot(d, f.right), dot(d, f.up), dot(d, f.out)});
  }
  return placed;
}

}  // namespace ilot
