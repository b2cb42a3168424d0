// SPDX-License-Identifier: Apache-2.0
#include "engine/columns/point_roles.h"

#include <vector>

#include "engine/pass/pass.h"

namespace ilot {

std::array<PointRole, 256> point_roles(std::span<const int> building, std::span<const int> ground) {
  std::array<PointRole, 256> roles;
  roles.fill(PointRole::other);
  for (const int code : {0, 1, 12}) roles[static_cast<std::size_t>(code)] = PointRole::unclassified;
  for (const int code : ground) roles[static_cast<std::size_t>(code)] = PointRole::ground;
  for (const int code : building) roles[static_cast<std::size_t>(code)] = PointRole::building;
  return roles;
}

RoleCounts write_roles(const Store& store, const std::array<PointRole, 256>& roles, const PassContext& context) {
  std::vector<PassTask> tasks;
  for (const Block& b : store.blocks()) tasks.push_back({std::uint64_t{b.points} * 2 * sizeof(PointRole), b.points});
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
  return sum_of(counts);
}

RoleCounts sum_of(std::span<const RoleCounts> counts) {
  RoleCounts all{};
  for (const RoleCounts& c : counts)
    for (std::size_t role = 0; role < all.size(); ++role) all[role] += c[role];
  return all;
}

}  // namespace ilot
