// SPDX-License-Identifier: Apache-2.0
#include "engine/units/value_counts.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr std::size_t kMostDifferent = 1u << 16, kMostWaiting = 1u << 16;
constexpr double kFirstStep = 0x1p-10;

}  // namespace

void ValueCounts::add(double value) {
  waiting_.push_back(value);
  ++count_;
  if (waiting_.size() >= kMostWaiting) count_waiting();
}

double ValueCounts::nth(std::uint64_t n) {
  if (counted_.empty()) return nth_smallest(waiting_, n);  // few values need not be counted
  count_waiting();
  for (const auto& [value, times] : counted_) {
    if (n < times) return value;
    n -= times;
  }
  return counted_.back().first;
}

double ValueCounts::rounded(double value) const {
  return step_ == 0 ? value : std::floor(value / step_) * step_;
}

void ValueCounts::count_waiting() {
  const auto before = static_cast<std::ptrdiff_t>(counted_.size());
  counted_.reserve(counted_.size() + waiting_.size());
  for (const double v : waiting_) counted_.emplace_back(rounded(v), 1);
  waiting_.clear();
  std::sort(counted_.begin() + before, counted_.end());
  std::inplace_merge(counted_.begin(), counted_.begin() + before, counted_.end());
  merge_equal();
  while (counted_.size() > kMostDifferent) {
    step_ = step_ == 0 ? kFirstStep : 2 * step_;
    for (Counted& c : counted_) c.first = rounded(c.first);  // this does not change the order
    merge_equal();
  }
}

void ValueCounts::merge_equal() {
  std::size_t kept = 0;
  for (std::size_t i = 1; i < counted_.size(); ++i) {
    if (counted_[i].first == counted_[kept].first) {
      counted_[kept].second += counted_[i].second;
    } else {
      counted_[++kept] = counted_[i];
    }
  }
  counted_.resize(std::min(counted_.size(), kept + 1));
}

}  // namespace ilot
