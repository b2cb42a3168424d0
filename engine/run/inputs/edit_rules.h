// SPDX-License-Identifier: Apache-2.0
// The edits that there are, and what each needs. docs/edits.md has the same table.
#pragma once
#include <cstdint>
#include <string>

#include "engine/model/edit.h"

namespace ilot {

enum class Needed : std::uint8_t { no, possible, yes };

struct EditRule {
  const char* product = "";
  EditAction action = EditAction::added;
  std::size_t at = 1;  // places x1 y1 z1, x2 y2 z2
  std::size_t to = 0;  // places to_x1 ... to_z2
  bool kind = false;   // needed
  Needed to_kind = Needed::no;
  bool heights = true;  // places need z
  bool area = false;    // a polygon is needed
};

// nullptr: the product has no such edit.
const EditRule* edit_rule(const std::string& product, EditAction action);

// All of them: "facades: added, deleted; streets: ...".
std::string edit_rules_text();

// What an edit lacks or has too much, as half a sentence; empty: nothing.
std::string edit_fault(const Edit& edit, const EditRule& rule);

}  // namespace ilot
