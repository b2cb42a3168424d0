// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// An arc of a flow network: cut when `from` stays and `to` goes.
struct CutArc {
  std::uint32_t from = 0, to = 0;
  std::int64_t capacity = 0;
};

// Which nodes go (1) and which stay (0) so that the sum of what is cut is least: gain[i] is what node i gains by
// staying (negative: by going), arcs join nodes. Of all such sets the smallest, so the answer is unique. Capacities are
// integers from 0. Maximum flow by shortest ways and blocking flows [Dinitz 1970] on flat arrays, the nodes' own gains
// being what they give and take: the networks are made thousands of times for one flow each, so making them counts.
std::vector<std::uint8_t> least_cut(std::span<const std::int64_t> gain, std::span<const CutArc> arcs);

}  // namespace ilot
