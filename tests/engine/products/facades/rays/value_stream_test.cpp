// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/value_stream.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "kernels/core/rng.h"

namespace ilot {
namespace {

using Places = std::vector<std::array<double, 2>>;

PlaceStream stream_of(const Places& places) {
  return [&](const std::function<void(double, double)>& take) {
    for (const auto& p : places) take(p[0], p[1]);
  };
}

std::vector<double> sorted_values(const Places& places, std::size_t axis) {
  std::vector<double> values;
  for (const auto& p : places) values.push_back(p[axis]);
  std::sort(values.begin(), values.end());
  return values;
}

// Values without a pattern, of a few places only, of one place, and far apart; other ones in the other coordinate.
double any_value(int kind, Rng& rng) {
  const double at = rng.uniform();
  return kind == 0 ? at - 0.5 : kind == 1 ? std::floor(5 * at) : kind == 2 ? 7 : at < 0.999 ? 1e-9 * at : 1e9 * at;
}

TEST(ValueStream, TheSameAsSorting) {
  Rng rng(9);
  for (const std::size_t count : {1u, 2u, 32768u, 32769u, 300000u})
    for (const int kind : {0, 1, 2, 3}) {
      Places places(count);
      for (auto& p : places) p = {any_value(kind, rng), any_value((kind + 1) % 4, rng)};
      const std::array<std::vector<double>, 2> sorted{sorted_values(places, 0), sorted_values(places, 1)};
      for (const double share : {0.0, 0.005, 0.5}) {
        const auto rank = static_cast<std::size_t>(share * static_cast<double>(count - 1));
        const auto got = nth_places(stream_of(places), count, {rank, count - 1 - rank});
        for (std::size_t axis = 0; axis < 2; ++axis) {
          EXPECT_EQ(got[axis][0], sorted[axis][rank]) << count << " " << kind << " " << share << " " << axis;
          EXPECT_EQ(got[axis][1], sorted[axis][count - 1 - rank])
              << count << " " << kind << " " << share << " " << axis;
        }
      }
    }
}

TEST(ValueStream, TheBoxOfPlacesLeavesOutAShareOnEachSide) {
  Places places;
  for (int i = 0; i <= 100; ++i) places.push_back({0.0 + i, 500.0 - 2 * i});
  const Box2 box = box_of_places(stream_of(places), places.size(), 0.02);
  EXPECT_EQ(box.u0, 2);
  EXPECT_EQ(box.u1, 98);
  EXPECT_EQ(box.v0, 304);
  EXPECT_EQ(box.v1, 496);
}

// Fewer values than were declared, or none that is a number: no value, and an end.
TEST(ValueStream, TooFewValuesGiveNone) {
  for (const std::size_t declared : {2u, 40000u, 400000u})
    for (const Places& places : {Places{}, Places(50, {NAN, NAN}), Places(1, {1, 2}), Places(39000, {1, 2})}) {
      const std::size_t values = places.empty() || std::isnan(places[0][0]) ? 0 : places.size();
      const std::array<std::uint64_t, 2> ranks{0, declared - 1};
      const auto got = nth_places(stream_of(places), declared, ranks);
      for (std::size_t r = 0; r < 2; ++r)
        EXPECT_EQ(std::isnan(got[0][r]), ranks[r] >= values) << declared << " " << places.size();
    }
}

}  // namespace
}  // namespace ilot
