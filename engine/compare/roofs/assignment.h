// SPDX-License-Identifier: Apache-2.0
// Assigns rows to columns one to one so that the sum of costs is least.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace ilot {

constexpr std::uint32_t kUnassigned = 0xffffffffu;

// Returns the column of each row, or kUnassigned: min(rows, columns) pairs are made. `costs` has rows * columns finite
// values, row after row. Among equal sums the choice depends on the order of rows and columns alone. Method: shortest
// augmenting paths (Kuhn 1955; Jonker and Volgenant 1987). O(n^2 m) with n the smaller and m the larger side.
std::vector<std::uint32_t> least_assignment(std::span<const double> costs, std::size_t rows, std::size_t columns);

}  // namespace ilot
