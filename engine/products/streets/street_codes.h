// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <span>
#include <vector>

#include "engine/products/streets/edits/object_edits.h"
#include "engine/products/streets/street_tiles.h"
#include "engine/report/run_record.h"

namespace ilot {

// The points of an object candidate at least least_height above the ground, below what was taken out as a crown or an
// overhang.
struct CodedPoints {
  std::uint64_t all = 0, vegetation = 0;  // vegetation: with a class code of vegetation
  bool is_vegetation() const { return vegetation > 0 && 2 * vegetation >= all; }
};

// Counts the points of each taken candidate, by its number from 1 on; [0] is not used. Empty where the store has no
// column "class". `candidate_of` is what candidate_of_part gives (object_selection.h), `vegetation` are class codes.
// Reads the layers "level", "candidates" and "structure". O(points).
std::vector<CodedPoints> coded_points(const Store& store, const StreetTiles& tiles,
                                      std::span<const std::uint32_t> candidate_of, std::span<const int> vegetation,
                                      double least_height);

// Whether class codes tell vegetation from objects. In some clouds all that is neither ground nor building has the
// codes 3, 4 and 5, by its height alone, objects too. Codes are used where there are objects that are sure by their
// form, planters aside, and at least half of them have no such code.
struct CodesVote {
  std::uint64_t sure = 0, coded = 0;  // objects stated with 0.9 and more; those of them that are coded vegetation
  bool used() const { return sure > 0 && 2 * coded <= sure; }
};
CodesVote vote_on_codes(std::span<const CodedPoints> counts, const SelectedObjects& selected);

// Takes what is not decided by hand for vegetation where at least half of its points have such a code, and records how
// many objects these were. Where the vote is against the codes, it records that alone.
void name_by_codes(std::span<const CodedPoints> counts, SelectedObjects& selected, RunRecord& record);

// The same for the points of a store, where streets.trust_classes is set.
void name_by_codes(const Store& store, const StreetTiles& tiles, const Settings& settings,
                   std::span<const std::uint32_t> candidate_of, SelectedObjects& selected, RunRecord& record);

}  // namespace ilot
