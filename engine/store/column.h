// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>

namespace ilot {

// The passes over a store that keep something in it, in the order in which a run calls them.
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

// A column as it is declared: for its files, for the table in engine/store/README.md, and for --resume.
struct ColumnInfo {
  const char* name;  // of its files: block.name
  const char* type;  // of its values
  Pass writer;
  const char* readers;
  const char* meaning;
};

// A column of the store whose values are of type T. All of them are declared in engine/store/columns.h.
template <class T>
struct Column {
  ColumnInfo info;
};

}  // namespace ilot
