// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <span>

#include "engine/compare/streets/error_sizes.h"
#include "engine/compare/truth.h"
#include "engine/model/street.h"

namespace ilot {

// What a cloud has of a tree.
struct SeenTree {
  std::uint64_t points = 0;
  double top = 0;  // z of its highest point
};

struct TreeResult {
  std::uint64_t truth = 0;   // true trees that are judged
  std::uint64_t unseen = 0;  // true trees with too few points, or cut off low: not judged
  std::uint64_t found = 0;   // found trees, without partners of trees that are not judged
  std::uint64_t matched = 0, false_found = 0;
  std::uint64_t trunks = 0;  // of the matched: those whose trunk was seen
  ErrorSizes position, position_with_trunk, position_without_trunk;
  ErrorSizes height;          // against the highest point that the cloud has of the tree
  ErrorSizes height_of_tree;  // against the tree itself
  ErrorSizes crown_radius, crown_base;
};

// A true tree is judged where it has at least 20 points, one of them 3 m above its foot or more. A found and a true
// tree may be partners where the position is within the true crown, 1 to 3 m from the trunk; the nearest pairs come
// first, one to one.
TreeResult evaluate_trees(std::span<const TrueTree> truth, const std::map<std::uint32_t, SeenTree>& seen,
                          std::span<const StreetTree> found, double metres_per_unit);

}  // namespace ilot
