// SPDX-License-Identifier: Apache-2.0
#include "kernels/planes/remaining_points.h"

namespace ilot {

RemainingPoints with_normals(const OrientedPoints& p) {
  RemainingPoints r;
  if (p.nx == nullptr) return r;
  r.reserve(p.points.size);
  for (std::size_t i = 0; i < p.points.size; ++i) {
    if (p.nx[i] == 0 && p.ny[i] == 0 && p.nz[i] == 0) continue;
    r.add_from(p, i);
    r.index.push_back(static_cast<std::uint32_t>(i));
  }
  r.pad();
  return r;
}

void remove(RemainingPoints& r, std::span<const std::uint32_t> members) {
  std::size_t to = members.empty() ? r.size : members[0];
  std::size_t next = 0;
  for (std::size_t i = to; i < r.size; ++i) {
    if (next < members.size() && members[next] == i) {
      ++next;
      continue;
    }
    for (auto* v : {&r.x, &r.y, &r.z, &r.nx, &r.ny, &r.nz}) (*v)[to] = (*v)[i];
    r.index[to++] = r.index[i];
  }
  r.size = to;
}

}  // namespace ilot
