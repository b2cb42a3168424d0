// SPDX-License-Identifier: Apache-2.0
// Order statistics of more places than memory can contain.
#pragma once
#include <array>
#include <cstdint>
#include <functional>

#include "engine/products/facades/rays/ray_samples.h"

namespace ilot {

// Calls the given function for the two coordinates of each place. Every call gives the same places.
using PlaceStream = std::function<void(const std::function<void(double, double)>&)>;

// For each coordinate and each of two ranks, result[coordinate][rank], the exact value that has so many smaller values
// before it in ascending order. `count` is the number of places; ranks < count; all values are finite. NaN where there
// are too few values. The places are read twice, and once more for every factor of 2,048 beyond 32,768. Needs 1.3 MB.
std::array<std::array<double, 2>, 2> nth_places(const PlaceStream& places, std::uint64_t count,
                                                std::array<std::uint64_t, 2> ranks);

// The box of the places (u, v) without a share of their coordinates on each side. count > 0.
Box2 box_of_places(const PlaceStream& places, std::uint64_t count, double tail);

}  // namespace ilot
