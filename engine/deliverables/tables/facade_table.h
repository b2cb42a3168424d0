// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <string>

#include "engine/model/facade.h"

namespace ilot {

// The elements of a facade as CSV, one line each in their order: a window schedule. Columns in docs/outputs.md. Texts
// that hold commas, quotes or begin as formulas are quoted, the latter behind an apostrophe. `metres_per_unit` as in
// FacadeDrawingParams.
std::string facade_table(const Facade& facade, double metres_per_unit = 1);

}  // namespace ilot
