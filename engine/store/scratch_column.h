// SPDX-License-Identifier: Apache-2.0
// Values that one task writes and reads again while it works. They are in memory while they are few, then in a file
// without a name, which disappears when the task ends or is killed.
#pragma once
#include <algorithm>
#include <cassert>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <span>
#include <type_traits>
#include <utility>
#include <vector>

#include "engine/store/scratch_file.h"

namespace ilot {

// At most `most_in_memory` values are in memory; without a folder all of them are. First call add() and finish(), then
// read() and write() in any number.
template <class T>
class ScratchColumn {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  explicit ScratchColumn(std::filesystem::path folder = {}, std::size_t most_in_memory = std::size_t{1} << 13)
      : folder_(std::move(folder)), most_(most_in_memory) {}

  void add(const T& value) {
    values_.push_back(value);
    if (values_.size() >= (file_.is_open() ? kTail : most_) && !folder_.empty()) spill();
  }
  // Gives an empty column this number of values, which are undefined at first.
  void resize(std::uint64_t count) {
    if (!folder_.empty() && count > most_)
      file_ = ScratchFile(folder_);
    else
      values_.resize(count);
    size_ = file_.is_open() ? count : 0;
  }
  void finish() {
    if (!file_.is_open()) return;
    spill();
    values_ = {};
  }

  std::uint64_t size() const { return size_ + values_.size(); }
  // Returns all values when they are in memory, else nullptr.
  const T* in_memory() const { return file_.is_open() ? nullptr : values_.data(); }
  void read(std::uint64_t first, std::span<T> out) const {
    assert(first + out.size() <= size());
    if (file_.is_open())
      file_.read(first * sizeof(T), std::as_writable_bytes(out));
    else
      std::copy_n(values_.begin() + static_cast<std::ptrdiff_t>(first), out.size(), out.begin());
  }
  void write(std::uint64_t first, std::span<const T> values) {
    assert(first + values.size() <= size());
    if (file_.is_open())
      file_.write(first * sizeof(T), std::as_bytes(values));
    else
      std::copy(values.begin(), values.end(), values_.begin() + static_cast<std::ptrdiff_t>(first));
  }

 private:
  static constexpr std::size_t kTail = 1024;  // values that wait for the file

  void spill() {
    if (!file_.is_open()) file_ = ScratchFile(folder_);
    file_.write(size_ * sizeof(T), std::as_bytes(std::span<const T>(values_)));
    size_ += values_.size();
    values_.clear();
    if (values_.capacity() > kTail) values_.shrink_to_fit();
    values_.reserve(kTail);
  }

  std::filesystem::path folder_;
  std::size_t most_;
  std::vector<T> values_;   // all, or those that are not yet in the file
  std::uint64_t size_ = 0;  // of the file, values
  ScratchFile file_;
};

}  // namespace ilot
