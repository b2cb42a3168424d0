// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "engine/model/facade.h"

namespace ilot {

// Returns the elements of a facade as CSV, one line each in their order: a window schedule. Columns: docs/outputs.md.
// Texts that contain commas or quotes, or that begin like formulas, are quoted; the latter get an apostrophe in front.
// `metres_per_unit` is that of FacadeDrawingParams.
std::string facade_table(const Facade& facade, double metres_per_unit = 1);

}  // namespace ilot
