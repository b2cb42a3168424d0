// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "engine/store/store.h"

namespace ilot {

// A column of all blocks whose values ascend by a key within each block, read stretch by stretch of the key: what all
// blocks have of a few keys is together, and no more than that is in memory. Key: a function of a value, of what
// T says. 16 bytes a block.
template <class T, class Key>
class SortedColumns {
 public:
  // `store` must live as long.
  SortedColumns(const Store& store, const Column<T>& column, Key key)
      : store_(store), column_(column), key_(key), sources_(store.blocks().size()) {
    for (std::uint32_t b = 0; b < sources_.size(); ++b) {
      const auto reader = store.open(b, column);
      sources_[b].next = reader.size() == 0 ? kEnd : key_(reader.at(0));
    }
  }

  // The values with keys below `end` that no earlier call gave: those of a block together, blocks in their order.
  std::vector<T> until(std::uint64_t end) {
    std::vector<T> values;
    for (std::uint32_t b = 0; b < sources_.size(); ++b)
      if (sources_[b].next < end) take(b, end, values);
    return values;
  }

  // The smallest key that is left; kEnd: none.
  std::uint64_t next() const {
    std::uint64_t least = kEnd;
    for (const Source& s : sources_) least = std::min(least, s.next);
    return least;
  }
  static constexpr std::uint64_t kEnd = std::numeric_limits<std::uint64_t>::max();

 private:
  struct Source {
    std::uint64_t at = 0, next = kEnd;  // the first value that is left, and its key
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
