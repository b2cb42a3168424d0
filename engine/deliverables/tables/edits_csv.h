// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <span>
#include <string>

#include "engine/model/edit.h"

namespace ilot {

// A table of edits as --edits reads it: comma, decimal point, quotes where they are needed, a line an edit. Places have
// four decimals.
std::string edits_csv(std::span<const Edit> edits);

}  // namespace ilot
