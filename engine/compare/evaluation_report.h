// SPDX-License-Identifier: Apache-2.0
// Writes an evaluation as text for people, as JSON for programs and as HTML for the report.
#pragma once
#include <string>

#include "engine/compare/evaluate.h"

namespace ilot {

// Aligned tables as the papers print them: rows are the truth, columns are what was found.
std::string evaluation_text(const Evaluation& evaluation);

// JSON with the keys of docs/outputs.md. Groups that could not be judged are left out; values that do not exist are
// null.
std::string evaluation_json(const Evaluation& evaluation);

// One <section> with its own style: tables and bars, readable on light and dark backgrounds, without scripts and
// external resources. A page of its own needs only a title around it.
std::string evaluation_html(const Evaluation& evaluation);

// How points got their classes, for example "by label".
std::string words_for(ClassSource source);

// The found plane with the greatest share of foreign points, or nullptr; and the number of found planes with a share
// above a hundredth.
struct ForeignPoints {
  const FoundPlane* worst = nullptr;
  std::uint64_t impure = 0;
};
ForeignPoints foreign_points(const PlaneMatching& matching);

}  // namespace ilot
