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
  for (std::size_t next = 0; next < members.size(); ++next) {
    const std::size_t begin = members[next] + 1, end = next + 1 < members.size() ? members[next + 1] : r.size;
    if (begin == end) continue;
    const auto move = [&](auto& v) { std::copy(v.begin() + begin, v.begin() + end, v.begin() + to); };
    for (auto* v : {&r.x, &r.y, &r.z, &r.nx, &r.ny, &r.nz}) move(*v);
    move(r.index);
    to += end - begin;
  }
  r.size = to;
}

}  // namespace ilot
