// SPDX-License-Identifier: Apache-2.0
// All texts of drawings, in the languages that sheets can have.
#pragma once
#include <fmt/format.h>

#include <cstdint>
#include <string>

#include "engine/deliverables/drawings/drawing.h"
#include "ilot/settings.h"

namespace ilot {

enum class SheetPhrase : std::uint8_t {
  elevation,
  row_of_facades,
  section,
  facade,        // {}: its number
  facades,       // {}: how many
  scale,         // {}: of 1 : n
  before,        // {}: metres
  behind,        // {}: metres
  crs,           // {}
  heights,       // {}
  of_points,     // heights without a known datum
  runs_towards,  // {}: degrees
  metres,
  date,          // {}
  accuracy,      // {}
  edges_within,  // {}: millimetres
  source,        // {}
  made_with,     // {}: version
  not_known,
  not_stated,
  origin,        // {} {}: east and north of x = 0
  origin_above,  // {} {}: of x = 0, y = 0 of what is seen from above
  section_at,    // {}: height
  section_at_x,  // {}
  section_line,  // {} {} {} {}: east and north of both ends
  cut,
  points_near,
};
constexpr std::size_t kSheetPhrases = 27, kSheetLanguages = 4;

// Returns a text; "{}" stands for what is put in. UTF-8.
const char* text_of(SheetPhrase phrase, SheetLanguage language);

// Returns the name of a layer in the legend; nullptr for those that it never lists.
const char* legend_text(DrawingRole role, SheetLanguage language);

template <class... T>
std::string phrase(SheetLanguage language, SheetPhrase phrase, const T&... values) {
  return fmt::format(fmt::runtime(text_of(phrase, language)), values...);
}

// English numbers have a decimal point, those of the other languages a comma.
bool has_decimal_comma(SheetLanguage language);
std::string number_text(double value, int decimals, bool comma);

}  // namespace ilot
