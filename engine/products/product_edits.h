// SPDX-License-Identifier: Apache-2.0
// What every product does with corrections by hand: it takes its own, and says what became of each.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/model/edit.h"
#include "engine/pass/context.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"

namespace ilot {

// The edits of one product, in their order. They must outlive the result.
std::vector<const Edit*> edits_of(std::span<const Edit> edits, const char* product);

// Whether an edit is of places outside of the wanted part of the cloud: its first place decides. `unit` is that of the
// store.
bool lies_outside(const Edit& edit, const PassContext& context, double unit);

// Throws a usage Error that names both lines: the later edit does not fit to what the earlier one says of the same
// thing.
[[noreturn]] void refuse_contradiction(const Edit& earlier, const Edit& later);

// Counts edits in the record. An edit without a partner is a warning and a skipped item.
class EditTally {
 public:
  EditTally(Progress& progress, RunRecord& record) : progress_(progress), record_(record) {}
  void made();
  void repeated();
  void outside();
  void without_partner(const Edit& edit, const std::string& reason);
  void add(const Edit& edit, const EditResult& result);

 private:
  EditsRecord& counts();

  Progress& progress_;
  RunRecord& record_;
};

}  // namespace ilot
