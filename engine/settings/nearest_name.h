// SPDX-License-Identifier: Apache-2.0
// What somebody probably meant who mistyped a name.
#pragma once
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace ilot {

// Returns the number of letters to insert, delete, replace or swap with a neighbour that turns one name into the other
// (optimal string alignment distance). Takes time proportional to the product of the lengths.
std::size_t edit_distance(std::string_view a, std::string_view b);

// Returns the name with the smallest edit distance, the earlier one if there are several. Returns none if more than a
// third of the letters, at least two, differ: then the name is another word, and not a mistyped one. A name that begins
// with what was typed, at least three letters, counts as one letter away.
std::optional<std::string> nearest_name(std::string_view typed, std::span<const std::string> names);

// Returns "; did you mean 'NAME'?", or an empty text if no name is near.
std::string did_you_mean(std::string_view typed, std::span<const std::string> names);

}  // namespace ilot
