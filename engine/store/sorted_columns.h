// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/store/store.h"

namespace ilot {

// Reads a column of all blocks whose values ascend by a key within each block. Values are read in stretches of the key:
// the values of all blocks for a few keys are together in memory, and no more than that. Key is a function that returns
// the key of a T. 16 bytes a block.
template <class T, class Key>
class SortedColumns {
 public:
  // `store` must outlive it.
  SortedColumns(const Store& store, const Column<T>& column, Key key)
      : store_(store), column_(column), key_(key), sources_(store.blocks().size()) {
    for (std::uint32_t b = 0; b < sources_.size(); ++b) {
      const auto reader = store.open(b, column);
      sources_[b].next = reader.size() == 0 ? kEnd : key_(reader.at(0));
    }
  }

  // Returns the values with keys below `end` that no earlier call returned. The values of a block are together, blocks
  // are in their order.
  std::vector<T> until(std::uint64_t end) {
    std::vector<T> values;
    for (std::uint32_t b = 0; b < sources_.size(); ++b)
      if (sources_[b].next < end) take(b, end, values);
    return values;
  }

  // Returns the smallest remaining key; kEnd: none.
  std::uint64_t next() const {
    std::uint64_t least = kEnd;
    for (const Source& s : sources_) least = std::min(least, s.next);
    return least;
  }
  static constexpr std::uint64_t kEnd = std::numeric_limits<std::uint64_t>::max();

 private:
  struct Source {
    std::uint64_t at = 0, next = kEnd;  // the first remaining value and its key
  };

  void take(std::uint32_t block, std::uint64_t end, std::vector<T>& values) {
    constexpr std::uint64_t kBatch = 64;
    Source& s = sources_[block];
    const auto reader = store_.open(block, column_);
    std::vector<T> batch;
    while (s.at < reader.size()) {
      batch.resize(std::min(kBatch, reader.size() - s.at));
      reader.read(s.at, batch);
      const auto last = std::find_if(batch.begin(), batch.end(), [&](const T& value) { return key_(value) >= end; });
      values.insert(values.end(), batch.begin(), last);
      s.at += static_cast<std::uint64_t>(last - batch.begin());
      if (last == batch.end()) continue;
      s.next = key_(*last);
      return;
    }
    s.next = kEnd;
  }

  const Store& store_;
  const Column<T>& column_;
  Key key_;
  std::vector<Source> sources_;
};

}  // namespace ilot
