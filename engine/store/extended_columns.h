// SPDX-License-Identifier: Apache-2.0
// The columns in which planes are extended over the borders of cells, a column a round.
#pragma once
#include "engine/store/columns.h"

namespace ilot::columns {

inline constexpr Column<std::uint32_t> kExtended1{
    {"extended_1", "u32", Pass::labels, "labels", "0 = none, else 1 + index of the joined plane, after one round"}};
inline constexpr Column<std::uint32_t> kExtended2{
    {"extended_2", "u32", Pass::labels, "labels", "the same after two rounds"}};
inline constexpr Column<std::uint32_t> kExtended3{
    {"extended_3", "u32", Pass::labels, "labels", "the same after three rounds"}};
inline constexpr Column<std::uint32_t> kExtended4{
    {"extended_4", "u32", Pass::labels, "labels", "the same after the last round"}};

}  // namespace ilot::columns
