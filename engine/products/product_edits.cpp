// SPDX-License-Identifier: Apache-2.0
#include "engine/products/product_edits.h"

#include <cmath>

#include "engine/error.h"

namespace ilot {

std::vector<const Edit*> edits_of(std::span<const Edit> edits, const char* product) {
  std::vector<const Edit*> own;
  for (const Edit& edit : edits)
    if (edit.product == product) own.push_back(&edit);
  return own;
}

bool lies_outside(const Edit& edit, const PassContext& context, double unit) {
  const auto steps = [&](double v) { return std::llround(v / unit); };
  const Vec3& p = edit.at[0];
  return context.wanted && !context.wanted({steps(p.x), steps(p.y), steps(p.z)});
}

void refuse_contradiction(const Edit& earlier, const Edit& later) {
  throw Error(later.where + ": contradicts " + earlier.where + ", which edits the same " +
                  (later.kind.empty() ? "thing" : later.kind) + " otherwise; take one of the two lines out",
              ExitCode::usage);
}

EditsRecord& EditTally::counts() {
  if (!record_.edits) record_.edits.emplace();
  return *record_.edits;
}

void EditTally::made() {
  ++counts().made;
}

void EditTally::repeated() {
  ++counts().repeated;
}

void EditTally::outside() {
  ++counts().outside;
}

void EditTally::without_partner(const Edit& edit, const std::string& reason) {
  ++counts().without_partner;
  progress_.unit_skipped(edit.where, reason);
  record_.skipped.push_back({"edit", edit.where, reason});
}

void EditTally::add(const Edit& edit, const EditResult& result) {
  if (result.outcome == EditOutcome::made) made();
  if (result.outcome == EditOutcome::repeated) repeated();
  if (result.outcome == EditOutcome::without_partner) without_partner(edit, result.reason);
}

}  // namespace ilot
