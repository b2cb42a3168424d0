// SPDX-License-Identifier: Apache-2.0
// When the cache of columns (engine/store/column_cache.h) has room: while a pass runs under a limit of memory that is
// ample, beside the memory of its tasks.
#pragma once
#include <cstdint>

namespace ilot {

// Gives the cache the room that a pass leaves whose running tasks together take at most `reserved` bytes. When it ends,
// what is kept stays, and no more is.
class ColumnRoom {
 public:
  explicit ColumnRoom(std::uint64_t reserved);
  ~ColumnRoom();
  ColumnRoom(const ColumnRoom&) = delete;
  ColumnRoom& operator=(const ColumnRoom&) = delete;
};

// Frees kept columns of so many bytes.
void give_up_columns(std::uint64_t bytes);

// Columns stay in memory while a store is worked on, and no longer: another store may have the same path.
class KeptColumns {
 public:
  KeptColumns() = default;
  ~KeptColumns();
  KeptColumns(const KeptColumns&) = delete;
  KeptColumns& operator=(const KeptColumns&) = delete;
};

}  // namespace ilot
