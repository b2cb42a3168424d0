// SPDX-License-Identifier: Apache-2.0
// Small valid buildings.
#pragma once
#include <string>

#include "engine/model/building.h"

namespace ilot {

// Returns a house of 10 m along x and 8 m along y, with eaves at 3 m and a ridge along x at 6 m. The first two faces
// are the roof. The last face is the ground.
inline Building gable_house(const std::string& id, Vec3 at) {
  Building b;
  b.id = id;
  for (const Vec3& v : {Vec3{0, 0, 0},
                        {10, 0, 0},
                        {10, 8, 0},
                        {0, 8, 0},
                        {0, 0, 3},
                        {10, 0, 3},
                        {10, 8, 3},
                        {0, 8, 3},
                        {0, 4, 6},
                        {10, 4, 6}})
    b.vertices.push_back(at + v);
  b.surfaces = {{SurfaceKind::roof, 1, {{4, 5, 9, 8}}},  {SurfaceKind::roof, 2, {{6, 7, 8, 9}}},
                {SurfaceKind::wall, 0, {{0, 1, 5, 4}}},  {SurfaceKind::wall, 0, {{1, 2, 6, 9, 5}}},
                {SurfaceKind::wall, 0, {{2, 3, 7, 6}}},  {SurfaceKind::wall, 0, {{3, 0, 4, 8, 7}}},
                {SurfaceKind::ground, 0, {{0, 3, 2, 1}}}};
  return b;
}

// Returns a building with a flat roof of 10 m square at 4 m, and a court of 4 m square in its middle.
inline Building court_house(const std::string& id) {
  Building b;
  b.id = id;
  for (const double z : {0.0, 4.0})
    for (const Vec3& v :
         {Vec3{0, 0, z}, {10, 0, z}, {10, 10, z}, {0, 10, z}, {3, 3, z}, {7, 3, z}, {7, 7, z}, {3, 7, z}})
      b.vertices.push_back(v);
  b.surfaces = {{SurfaceKind::roof, 1, {{8, 9, 10, 11}, {12, 15, 14, 13}}},
                {SurfaceKind::ground, 0, {{3, 2, 1, 0}, {4, 5, 6, 7}}}};
  for (std::uint32_t i = 0; i < 4; ++i) {
    const std::uint32_t k = (i + 1) % 4;
    b.surfaces.push_back({SurfaceKind::wall, 0, {{i, k, k + 8, i + 8}}});
    b.surfaces.push_back({SurfaceKind::wall, 0, {{k + 4, i + 4, i + 12, k + 12}}});
  }
  return b;
}

}  // namespace ilot
