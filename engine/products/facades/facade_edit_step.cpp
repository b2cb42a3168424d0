// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/facade_edit_step.h"

#include <cmath>

#include "engine/products/facades/elements/facade_elements.h"

namespace ilot {
namespace {

// The sides that are drawn although they were not seen, of all that the edits can change.
std::uint64_t unseen_sides_of(const Facade& facade) {
  std::uint64_t sides = 0;
  for (const FacadeElement& e : facade.elements)
    if (e.kind != "outline" && e.kind != "not seen" && e.kind != "possible opening") sides += unseen_sides(e);
  return sides;
}

void mark_turned(Facade& facade) {
  for (FacadeElement& e : facade.elements)
    if (e.kind == "outline") {
      e.status = DrawnStatus::by_hand;
      e.reason = "street side set by hand";
      return;
    }
}

}  // namespace

FacadeEditStep::FacadeEditStep(std::span<const Edit> edits, std::span<WallGroup> walls, const PassContext& context,
                               double unit, EditTally tally)
    : tally_(tally) {
  params_.metres_per_unit = context.metres_per_unit;
  for (const Edit* edit : edits_of(edits, "facades")) {
    if (lies_outside(*edit, context, unit))
      tally_.outside();
    else
      edits_.push_back(edit);
  }
  turn(walls);
}

void FacadeEditStep::turn(std::span<WallGroup> walls) {
  const std::vector<std::optional<std::size_t>> sides = edit_sides(edits_, walls, params_);
  for (std::size_t i = 0; i < edits_.size(); ++i) {
    if (edits_[i]->action != EditAction::side) continue;
    if (!sides[i]) {
      tally_.without_partner(*edits_[i], "no facade is where this edit sets the street side");
      continue;
    }
    turned_.push_back(*sides[i]);
    tally_.made();
  }
}

void FacadeEditStep::edit(std::span<FoundFacade> found) {
  if (edits_.empty()) return;
  for (const std::size_t wall : turned_) mark_turned(found[wall].facade);
  std::vector<Facade*> facades;
  std::vector<std::uint64_t> unseen;
  for (FoundFacade& f : found) {
    facades.push_back(&f.facade);
    unseen.push_back(unseen_sides_of(f.facade));
  }
  const std::vector<EditResult> results = edit_facades(edits_, facades, params_);
  for (std::size_t i = 0; i < edits_.size(); ++i) {
    if (edits_[i]->action == EditAction::side) continue;
    tally_.add(*edits_[i], results[i]);
  }
  for (std::size_t i = 0; i < found.size(); ++i)
    found[i].occluded_edges = found[i].occluded_edges + unseen_sides_of(found[i].facade) - unseen[i];
}

}  // namespace ilot
