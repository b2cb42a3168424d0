// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <numeric>
#include <span>
#include <utility>

namespace ilot {

// Disjoint sets with path halving. The caller owns the array of parents. The smaller index is always the root, so the
// sets and their representatives do not depend on the order of the unions. An operation takes nearly constant amortised
// time in practice.
class UnionFind {
 public:
  explicit UnionFind(std::span<std::uint32_t> parents) : parent_(parents) {
    std::iota(parent_.begin(), parent_.end(), 0u);
  }
  std::uint32_t find(std::uint32_t i) {
    while (parent_[i] != i) i = parent_[i] = parent_[parent_[i]];
    return i;
  }
  // Whether both are in one set. This takes one comparison when both have the same parent.
  bool same(std::uint32_t a, std::uint32_t b) { return parent_[a] == parent_[b] || find(a) == find(b); }
  // Returns true when two sets became one.
  bool unite(std::uint32_t a, std::uint32_t b) {
    a = find(a);
    b = find(b);
    if (a == b) return false;
    if (b < a) std::swap(a, b);
    parent_[b] = a;
    return true;
  }

 private:
  std::span<std::uint32_t> parent_;
};

}  // namespace ilot
