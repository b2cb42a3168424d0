// SPDX-License-Identifier: Apache-2.0
// A correction that a person made to a result. It names no id: ids change from run to run, places do not.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "ilot/geometry.h"

namespace ilot {

enum class EditAction : std::uint8_t { added, deleted, moved, kind, side, merged, split };
constexpr std::array<const char*, 7> kEditActionNames{"added", "deleted", "moved", "kind", "side", "merged", "split"};

// The columns of a table of edits, in the order in which they are written. docs/edits.md says what each action needs.
constexpr std::array<const char*, 18> kEditColumns{"product", "edit",  "kind",  "x1",      "y1",    "z1",
                                                   "x2",      "y2",    "z2",    "to_kind", "to_x1", "to_y1",
                                                   "to_z1",   "to_x2", "to_y2", "to_z2",   "area",  "note"};

struct Edit {
  std::string product;  // facades, streets or roofs
  EditAction action = EditAction::added;
  std::string kind, to_kind;        // what it is, and what it shall be; empty: any, or as it is
  std::vector<Vec3> at, to;         // CRS: where it is and where it shall be; an opening by two opposite corners
  Area area;                        // of points; without rings where there is none
  std::optional<double> low, high;  // CRS: heights of the points of an area, both included
  std::string note;                 // for people
  std::string where;                // FILE:LINE
};

// What became of one edit.
enum class EditOutcome : std::uint8_t { made, repeated, without_partner };

struct EditResult {
  EditOutcome outcome = EditOutcome::made;
  std::string reason;  // why it has no partner
};

}  // namespace ilot
