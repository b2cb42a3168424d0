// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/value_stream.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

constexpr std::uint64_t kInMemory = 1 << 15;

// The values among which the wanted one is.
struct Candidates {
  double low = INFINITY, high = -INFINITY;  // the least and the greatest of them
  std::uint64_t count = 0;

  void add(double v) {
    low = std::min(low, v), high = std::max(high, v);
    ++count;
  }
  bool contains(double v) const { return v >= low && v <= high; }
};

// Counts the candidates in bins.
class Bins {
 public:
  explicit Bins(const Candidates& among) : among_(among), bins_(kBins) {}
  void add(double v) {
    if (!among_.contains(v)) return;
    bins_[std::min(kBins - 1, static_cast<std::size_t>((v - among_.low) / (among_.high - among_.low) * kBins))].add(v);
  }
  // The candidates in the bin of the wanted value, and its rank among them.
  Candidates of(std::uint64_t& rank) const {
    std::size_t at = 0;
    while (rank >= bins_[at].count) rank -= bins_[at++].count;
    return bins_[at];
  }

 private:
  static constexpr std::size_t kBins = 2048;
  Candidates among_;
  std::vector<Candidates> bins_;
};

// The search for the value of one rank, by one reading after the other.
class NthValue {
 public:
  NthValue(std::uint64_t count, std::uint64_t rank) : among_{-INFINITY, INFINITY, count}, rank_(rank) {
    if (count > kInMemory) among_ = {INFINITY, -INFINITY, count};
    begin();
  }

  bool done() const { return done_; }
  double value() const { return value_; }

  void add(double v) {
    if (bins_) {
      bins_->add(v);
    } else if (measuring()) {
      range_.add(v);
    } else if (among_.contains(v)) {
      found_.push_back(v);
    }
  }

  // After each reading.
  void end() {
    if (bins_) {
      among_ = bins_->of(rank_);
      bins_.reset();
    } else if (measuring()) {
      among_ = range_;
    } else {
      value_ = nth_smallest(found_, rank_);
      done_ = true;
      return;
    }
    begin();
  }

 private:
  bool measuring() const { return among_.low > among_.high; }
  void begin() {
    if (measuring()) return;
    if (among_.count <= kInMemory) {
      found_.reserve(among_.count);
    } else if (among_.low < among_.high) {
      bins_.emplace(among_);
    } else {
      value_ = among_.low;
      done_ = true;
    }
  }

  Candidates among_, range_;
  std::uint64_t rank_;
  std::optional<Bins> bins_;
  std::vector<double> found_;
  double value_ = 0;
  bool done_ = false;
};

}  // namespace

double nth_value(const ValueStream& values, std::uint64_t count, std::uint64_t rank) {
  NthValue search(count, rank);
  while (!search.done()) {
    values([&](double v) { search.add(v); });
    search.end();
  }
  return search.value();
}

std::array<std::array<double, 2>, 2> nth_places(const PlaceStream& places, std::uint64_t count,
                                                std::array<std::uint64_t, 2> ranks) {
  std::array<NthValue, 2> first{NthValue{count, ranks[0]}, NthValue{count, ranks[1]}}, second = first;
  const auto each = [&](const auto& use) {
    for (auto* coordinate : {&first, &second})
      for (NthValue& search : *coordinate)
        if (!search.done()) use(search, coordinate == &first);
  };
  for (bool more = true; more;) {
    more = false;
    each([&](NthValue&, bool) { more = true; });
    if (!more) break;
    places([&](double a, double b) { each([&](NthValue& search, bool is_first) { search.add(is_first ? a : b); }); });
    each([&](NthValue& search, bool) { search.end(); });
  }
  return {{{first[0].value(), first[1].value()}, {second[0].value(), second[1].value()}}};
}

}  // namespace ilot
