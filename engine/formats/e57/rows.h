// SPDX-License-Identifier: Apache-2.0
// Points of E57 scans as rows of one table: every scan fills the same columns, whatever fields it has.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/formats/e57/description.h"
#include "engine/formats/e57/packets.h"
#include "engine/formats/tables/table.h"

namespace ilot::e57 {

// Where point i of a batch lies from the scanner, in its own frame; nothing when the point is in an invalid state. May
// be not a number.
std::optional<Vec3> local_position(const Scan& scan, const Batch& batch, std::size_t i);

class Rows {
 public:
  explicit Rows(const std::vector<Scan>& scans);

  const std::vector<TableColumn>& columns() const { return columns_; }

  // The values of point i of a batch, columns().size() of them; those that the scan does not have are zero. `number`
  // of the scan counts from 1. False when the point is in an invalid state. Never throws.
  bool fill(const Scan& scan, std::size_t number, const Batch& batch, std::size_t i, std::span<double> values) const;

 private:
  void add(const char* name, FieldType type, Use use, bool wanted);

  std::vector<TableColumn> columns_;
  std::vector<Use> uses_;  // of each column behind x, y, z and the number of the scan
};

}  // namespace ilot::e57
