// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <utility>
#include <vector>

namespace ilot {

// Quantiles of any number of values (heights in metres) in at most 4 MiB. They are exact while no more than 65,536
// values are different. Beyond that, values are rounded down to multiples of 1/1024, or of the smallest power of two
// times 1/1024 that leaves no more different values. The result depends only on the set of values, not on their order.
class ValueCounts {
 public:
  void add(double value);
  std::uint64_t count() const { return count_; }

  // Returns the value that has n smaller ones before it in ascending order. n < count().
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
