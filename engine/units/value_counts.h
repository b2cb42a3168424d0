// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

namespace ilot {

// Quantiles of any number of values (heights in metres) in at most 4 MiB. Exact while no more than 65,536 of them are
// different; beyond that values are rounded down to multiples of 1/1024, or of the smallest power of two times that
// which leaves no more different ones. A property of the set of values: their order does not matter.
class ValueCounts {
 public:
  void add(double value);
  std::uint64_t count() const { return count_; }

  // The value with so many smaller ones before it in ascending order. n < count().
  double nth(std::uint64_t n);

 private:
  using Counted = std::pair<double, std::uint64_t>;
  void count_waiting();
  void merge_equal();
  double rounded(double value) const;

  std::vector<double> waiting_;   // not yet counted
  std::vector<Counted> counted_;  // ascending, each value once
  std::uint64_t count_ = 0;
  double step_ = 0;  // 0 = exact
};

}  // namespace ilot
