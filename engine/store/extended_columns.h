// SPDX-License-Identifier: Apache-2.0
// The columns in which planes are extended over the borders of cells, a column a round. Few points change their plane,
// so only these are stored; the others have the joined plane of the column "segment".
#pragma once
#include <cstdint>

#include "engine/store/columns.h"

namespace ilot {

// A point of a block, and 1 + the index of its joined plane.
struct ExtendedPoint {
  std::uint32_t point = 0, plane = 0;
};

namespace columns {

inline constexpr Column<ExtendedPoint> kExtended1{
    {"extended_1", "ExtendedPoint", Pass::labels, "labels", "points with another plane after one round, ascending"}};
inline constexpr Column<ExtendedPoint> kExtended2{
    {"extended_2", "ExtendedPoint", Pass::labels, "labels", "the same after two rounds"}};
inline constexpr Column<ExtendedPoint> kExtended3{
    {"extended_3", "ExtendedPoint", Pass::labels, "labels", "the same after three rounds"}};
inline constexpr Column<ExtendedPoint> kExtended4{
    {"extended_4", "ExtendedPoint", Pass::labels, "labels", "the same after the last round"}};

}  // namespace columns
}  // namespace ilot
