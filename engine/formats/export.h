// SPDX-License-Identifier: Apache-2.0
// The reverse of table.h: LAS rows as a table of numbers, for formats that have no records.
#pragma once
#include <cstddef>
#include <span>
#include <string>
#include <vector>

#include "engine/cloud/record.h"

namespace ilot {

struct ExportColumn {
  std::string name;
  FieldType type = FieldType::f64;    // smallest type that can represent every value; scaled extra bytes are f64
  int source = 0;                     // which standard field
  std::size_t place = 0;              // extra bytes: offset in the record
  FieldType raw = FieldType::opaque;  // extra bytes: type in the record
  double scale = 1, shift = 0;
};

// Returns world coordinates, the standard fields of the point format, then the described extra bytes except opaque
// ones.
std::vector<ExportColumn> export_columns(const RecordLayout& layout);

// Gives one value for each column. `values` has as many entries as there are columns. O(columns).
void export_row(std::span<const std::byte> record, const RecordLayout& layout, std::span<const ExportColumn> columns,
                std::span<double> values);

}  // namespace ilot
