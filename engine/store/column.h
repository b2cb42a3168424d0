// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace ilot {

// The passes that keep files in a store, in the order in which a run calls them.
enum class Pass : std::uint8_t {
  index,
  classes,
  normals,
  colours,
  stations,
  planes,
  contacts,
  labels,
  adjacency,
  shapes,
  boundaries,
  facades,
  clusters,
  roofs,
  streets,
  rows,
};
constexpr int kPasses = 16;

// The declaration of a column. Its files, the table in engine/store/README.md and --resume use it.
struct ColumnInfo {
  const char* name;  // of its files: block.name
  const char* type;  // of its values
  Pass writer;
  const char* readers;
  const char* meaning;
};

// A column of the store with values of type T. engine/store/columns.h declares all columns.
template <class T>
struct Column {
  ColumnInfo info;
};

}  // namespace ilot
