// SPDX-License-Identifier: Apache-2.0
// A store that has run through the passes up to the joined planes.
#pragma once
#include "engine/columns/normals_pass.h"
#include "engine/products/planes/join/extend_pass.h"
#include "engine/products/planes/join/join_pass.h"
#include "kernels/core/portable_math.h"
#include "tests/support/cloud_store.h"
#include "tests/support/oriented_sets.h"

namespace ilot::test {

struct PlaneStore {
  explicit PlaneStore(const std::vector<Index3>& points, const StoreOptions& options = {},
                      const Settings& settings = {})
      : cloud(points, options) {
    const Store& s = cloud.store();
    normals_pass(s, settings.normals, {});
    cells = canonical_cells(s, 1);
    found = planes_pass(s, cells, settings, {});
    contacts = contact_pass(s, cells, found, {});
    joined = join_planes(s, cells, found, contacts, {cos_degrees(settings.planes.join_angle)});
    extend_pass(s, cells, found, joined, {});
  }
  CloudStore cloud;
  std::vector<Cell> cells;
  CellPlanes found;
  std::vector<Contact> contacts;
  JoinedPlanes joined;
};

// Adds columns x rows points, `step` apart, starting at (x, y). `height` gives the height of the surface above the
// origin. Noise is added.
template <class Height>
void add_surface(std::vector<Index3>& points, Index3 from, Index3 size, std::int64_t step, double noise,
                 Height height) {
  Rng rng(static_cast<std::uint64_t>(from.x * 31 + from.y));
  for (std::int64_t x = from.x; x < from.x + size.x; x += step)
    for (std::int64_t y = from.y; y < from.y + size.y; y += step) {
      const auto jitter = [&] { return static_cast<std::int64_t>(rng.below(static_cast<std::uint64_t>(step / 2))); };
      const Index3 p{x + jitter(), y + jitter(), 0};
      const double z = height(static_cast<double>(p.x), static_cast<double>(p.y)) + noise * bell(rng);
      points.push_back({p.x, p.y, from.z + static_cast<std::int64_t>(std::nearbyint(z))});
    }
}

}  // namespace ilot::test
