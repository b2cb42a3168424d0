// SPDX-License-Identifier: Apache-2.0
// Points of E57 scans as rows of one table. Every scan fills the same columns, whatever its fields are.
#pragma once
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "engine/formats/e57/description.h"
#include "engine/formats/e57/packets.h"
#include "engine/formats/tables/table.h"

namespace ilot::e57 {

// Returns the place of point i of a batch relative to the scanner, in the frame of the scanner; nullopt when the point
// is in an invalid state. The result may be NaN.
std::optional<Vec3> local_position(const Scan& scan, const Batch& batch, std::size_t i);

class Rows {
 public:
  explicit Rows(const std::vector<Scan>& scans);

  const std::vector<TableColumn>& columns() const { return columns_; }

  // Fills the values of point i of a batch, columns().size() in number. Values that the scan does not have are zero.
  // `number`, the number of the scan, counts from 1. False when the point is in an invalid state. Never throws.
  bool fill(const Scan& scan, std::size_t number, const Batch& batch, std::size_t i, std::span<double> values) const;

 private:
  void add(const char* name, FieldType type, Use use, bool wanted);

  std::vector<TableColumn> columns_;
  std::vector<Use> uses_;  // for each column after x, y, z and the number of the scan
};

}  // namespace ilot::e57
