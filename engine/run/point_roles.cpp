// SPDX-License-Identifier: Apache-2.0
#include "engine/run/point_roles.h"

#include <vector>

#include "engine/pass/pass.h"

namespace ilot {

RoleCounts write_roles(const Store& store, const std::array<PointRole, 256>& roles, const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({b.points * 2 * sizeof(PointRole), b.points});
  std::vector<RoleCounts> counts(tasks.size());
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) {
    const auto block = static_cast<std::uint32_t>(i);
    std::vector<PointRole> column;
    column.reserve(store.blocks()[block].points);
    for (const std::uint8_t code : store.read(block, columns::kClass)) {
      column.push_back(roles[code]);
      ++counts[i][static_cast<std::size_t>(roles[code])];
    }
    store.write(block, columns::kRole, column);
  });
  RoleCounts all{};
  for (const RoleCounts& c : counts)
    for (std::size_t role = 0; role < all.size(); ++role) all[role] += c[role];
  return all;
}

}  // namespace ilot
