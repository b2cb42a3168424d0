// SPDX-License-Identifier: Apache-2.0
// Makes corrections by hand on the objects of a street, after candidates are classified and selected and before they
// are numbered and points are labelled.
#pragma once
#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "engine/model/edit.h"
#include "engine/products/streets/classes/object_model.h"
#include "engine/products/streets/objects/object_candidates.h"

namespace ilot {

// The candidates of a street, the class of each, and which are whole (select_objects).
struct SelectedObjects {
  std::vector<ObjectCandidate> candidates;
  std::vector<CandidateClass> classes;
  std::vector<std::uint8_t> taken;
  std::vector<std::uint8_t> by_hand;  // per candidate: a person decided it
};

// The separated part at a place, 0 = none.
using PartAt = std::function<std::uint32_t(Vec3 place)>;

// Makes the edits in their order; each acts on what the earlier ones leave.
//  - added, kind: the whole candidate at the place is an object of the class. An object that was found so is `repeated`
//    for added, and by hand from then on.
//  - deleted: it is no object.
//  - merged: the whole candidates at both places are one object, of the class of the first place or of to_kind. A join
//    of just these two is taken, or else appended to the candidates.
//  - split: the object at both places is divided where its tree of joins separates them.
// Throws a usage Error for two edits that give one object two classes. `pixel` is in metres.
// O(candidates + edits x depth of the trees).
std::vector<EditResult> edit_objects(std::span<const Edit* const> edits, const PartAt& part_at, double pixel,
                                     SelectedObjects& objects);

}  // namespace ilot
