// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <algorithm>
#include <cstddef>
#include <span>
#include <vector>

#include "kernels/core/parallel.h"

namespace ilot {

// Sorts on all threads. `before` must be a total order, in which two values are equal only when they cannot be told
// apart, so the result is unique. Runs of a fixed length are sorted and then merged two by two. Each merge is cut into
// pieces of a fixed length. Memory: a second copy of the values. O(n log n).
template <class T, class Before>
void parallel_sort(std::vector<T>& values, const Before& before);

namespace detail {

constexpr std::size_t kSortRun = std::size_t{1} << 15;  // values; length of a run and of a piece of a merge

// Returns how many of the first `count` values of the merge of a and b come from a. Values of a come before equal
// values of b.
template <class T, class Before>
std::size_t taken_from_first(std::span<const T> a, std::span<const T> b, std::size_t count, const Before& before) {
  std::size_t low = count > b.size() ? count - b.size() : 0, high = std::min(count, a.size());
  while (low < high) {
    const std::size_t i = low + (high - low) / 2;
    if (before(b[count - i - 1], a[i])) {
      high = i;
    } else {
      low = i + 1;
    }
  }
  return low;
}

// Writes one piece of the merge of a and b: at most kSortRun values from position `first` on.
template <class T, class Before>
void merge_piece(std::span<const T> a, std::span<const T> b, std::size_t first, std::span<T> out,
                 const Before& before) {
  const std::size_t count = std::min(kSortRun, out.size() - first);
  const std::size_t a0 = taken_from_first(a, b, first, before), a1 = taken_from_first(a, b, first + count, before);
  const std::size_t b0 = first - a0, b1 = first + count - a1;
  const auto at = [](std::span<const T> s, std::size_t i) { return s.begin() + static_cast<std::ptrdiff_t>(i); };
  std::merge(at(a, a0), at(a, a1), at(b, b0), at(b, b1), out.begin() + static_cast<std::ptrdiff_t>(first), before);
}

}  // namespace detail

template <class T, class Before>
void parallel_sort(std::vector<T>& values, const Before& before) {
  using detail::kSortRun;
  const std::size_t n = values.size(), runs = (n + kSortRun - 1) / kSortRun;
  const auto part = [&](std::vector<T>& v, std::size_t begin, std::size_t end) {
    return std::span(v).subspan(std::min(begin, n), std::min(end, n) - std::min(begin, n));
  };
  parallel_for(runs, [&](std::size_t r) {
    const std::span<T> run = part(values, r * kSortRun, (r + 1) * kSortRun);
    std::sort(run.begin(), run.end(), before);
  });
  if (runs < 2) return;
  std::vector<T> other(n);
  for (std::size_t length = kSortRun; length < n; length *= 2) {
    parallel_for(runs, [&](std::size_t piece) {
      const std::size_t at = piece * kSortRun, begin = at / (2 * length) * (2 * length);
      const std::span<const T> a = part(values, begin, begin + length),
                               b = part(values, begin + length, begin + 2 * length);
      detail::merge_piece(a, b, at - begin, part(other, begin, begin + 2 * length), before);
    });
    values.swap(other);
  }
}

}  // namespace ilot
