// SPDX-License-Identifier: Apache-2.0
#include "engine/store/row_order.h"

#include "kernels/core/radix_sort.h"

namespace ilot {

std::vector<std::uint32_t> points_by_row(const Store& store, std::uint32_t block, std::span<const InputOrder> order) {
  if (store.has(block, columns::kSorted)) return store.read(block, columns::kSorted);
  std::vector<std::uint32_t> sorted = sorted_order(order);
  store.write(block, columns::kSorted, sorted);
  return sorted;
}

}  // namespace ilot
