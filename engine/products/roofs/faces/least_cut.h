// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

// An arc of a flow network. It is cut when `from` stays and `to` goes.
struct CutArc {
  std::uint32_t from = 0, to = 0;
  std::int64_t capacity = 0;
};

// Decides which nodes go (1) and which stay (0) so that the sum of what is cut is least. gain[i] is what node i gains
// by staying (negative: by going), and arcs join nodes. Of all such sets of going nodes the smallest is taken, so the
// result is unique. Capacities are integers from 0. The method is maximum flow by shortest paths and blocking flows
// [Dinitz 1970] on flat arrays. The gains of the nodes take the place of source and sink. Networks are built thousands
// of times for one flow each, so the time to build them matters.
std::vector<std::uint8_t> least_cut(std::span<const std::int64_t> gain, std::span<const CutArc> arcs);

}  // namespace ilot
