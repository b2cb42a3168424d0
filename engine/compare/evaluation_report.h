// SPDX-License-Identifier: Apache-2.0
// An evaluation for people, for programs and for the report.
#pragma once
#include <string>

#include "engine/compare/evaluate.h"

namespace ilot {

// Aligned tables, rows truth, columns found, as the documents print them.
std::string evaluation_text(const Evaluation& evaluation);

// Keys as in docs/outputs.md; groups that could not be judged are left out, figures that do not exist are null.
std::string evaluation_json(const Evaluation& evaluation);

// One <section> with its own style: tables and bars, readable on light and dark grounds, no scripts, nothing from
// outside. For a page of its own it needs nothing more than a title around it.
std::string evaluation_html(const Evaluation& evaluation);

// "by label": how points came to their classes.
std::string words_for(ClassSource source);

// The found plane with the greatest share of foreign points, or nullptr; and how many have more than a hundredth.
struct ForeignPoints {
  const FoundPlane* worst = nullptr;
  std::uint64_t impure = 0;
};
ForeignPoints foreign_points(const PlaneMatching& matching);

}  // namespace ilot
