// SPDX-License-Identifier: Apache-2.0
// Leaves and blinds that close an opening, or a part of it, within its reveal.
#pragma once
#include <optional>
#include <vector>

#include "engine/products/facades/openings/openings.h"

namespace ilot {

// The part of an opening that one even sheet fills from side to side: from its bottom over half of its height at least
// (leaves, with a light above them where they end earlier), or from its top down (a blind). In each row of cells nine
// tenths of the cells have points within a centimetre of one depth, and hardly a ray went on behind it. Panes let rays
// through or have frames and bars before them. No result where there is none. O(points in it).
struct ClosedPart {
  FoundRectangle sheet;
  bool from_bottom = true;       // leaves; else a blind
  std::optional<double> behind;  // w of what is seen in the rest of the opening
};
std::optional<ClosedPart> closed_part(const RaySamples& samples, const FoundRectangle& opening);

// The closed parts of some openings, in their order. Dusty panes without a frame are even sheets too, and so are
// walled-up windows: leaves and blinds are only those behind which something is seen, at least 2 cm deeper: in the rest
// of their opening, or at one depth in two other openings that no sheet fills.
std::vector<std::optional<ClosedPart>> closed_parts(const RaySamples& samples,
                                                    const std::vector<FoundRectangle>& openings);

}  // namespace ilot
