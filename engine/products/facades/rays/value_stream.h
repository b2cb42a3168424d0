// SPDX-License-Identifier: Apache-2.0
// Order statistics of more values than memory can contain.
#pragma once
#include <array>
#include <cstdint>
#include <functional>

namespace ilot {

// Calls the given function for each value. Every call gives the same values.
using ValueStream = std::function<void(const std::function<void(double)>&)>;

// The exact value that has `rank` smaller values before it in ascending order. `count` is the number of values; rank <
// count; all values are finite. The values are read twice, and once more for every factor of 2,048 beyond 32,768. Needs
// 330 KB.
double nth_value(const ValueStream& values, std::uint64_t count, std::uint64_t rank);

// The same for places with two coordinates, which are read together: first of the one coordinate, then of the other,
// the values of both ranks. They are read as often as for one value. Needs four times the memory.
using PlaceStream = std::function<void(const std::function<void(double, double)>&)>;
std::array<std::array<double, 2>, 2> nth_places(const PlaceStream& places, std::uint64_t count,
                                                std::array<std::uint64_t, 2> ranks);

}  // namespace ilot
