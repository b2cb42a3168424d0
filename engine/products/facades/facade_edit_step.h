// SPDX-License-Identifier: Apache-2.0
// The step of a run that makes corrections by hand on its facades.
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "engine/pass/context.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/products/facades/facade_edits.h"

namespace ilot {

// The edits of facades of a run and what became of them, counted once.
class FacadeEditStep {
 public:
  // `unit` is that of the store: edits outside of the wanted area of the context are only counted.
  // Turns the walls whose side is edited, before their facades are found.
  FacadeEditStep(std::span<const Edit> edits, std::span<WallGroup> walls, const PassContext& context, double unit,
                 EditTally tally);

  // Edits the facades that were found on these walls, and marks those that were turned.
  void edit(std::span<FoundFacade> found);

 private:
  void turn(std::span<WallGroup> walls);

  std::vector<const Edit*> edits_;
  FacadeEditParams params_;
  std::vector<std::size_t> turned_;  // walls
  EditTally tally_;
};

}  // namespace ilot
