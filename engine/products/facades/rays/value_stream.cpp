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
  // Returns the candidates in the bin of the value of this rank, which becomes its rank among them.
  Candidates narrow(std::uint64_t& rank) const {
    std::size_t at = 0;
    while (at + 1 < kBins && rank >= bins_[at].count) rank -= bins_[at++].count;
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
  NthValue(std::uint64_t count, std::uint64_t rank)
      : among_{-INFINITY, INFINITY, count}, rank_(rank), measuring_(count > kInMemory) {
    if (!measuring_) begin();
  }

  bool done() const { return done_; }
  double value() const { return value_; }

  void add(double v) {
    if (bins_) {
      bins_->add(v);
    } else if (measuring_) {
      range_.add(v);
    } else if (among_.contains(v)) {
      found_.push_back(v);
    }
  }

  // After each reading.
  void end() {
    if (bins_) {
      among_ = bins_->narrow(rank_);
      bins_.reset();
    } else if (measuring_) {
      among_ = range_;
      measuring_ = false;
    } else {
      value_ = rank_ < found_.size() ? nth_smallest(found_, rank_) : NAN;
      done_ = true;
      return;
    }
    begin();
  }

 private:
  void begin() {
    if (among_.count <= kInMemory) {
      found_.reserve(among_.count);
    } else if (among_.low < among_.high) {
      bins_.emplace(among_);
    } else {
      value_ = rank_ < among_.count ? among_.low : NAN;
      done_ = true;
    }
  }

  Candidates among_, range_;
  std::uint64_t rank_;
  bool measuring_;  // the range of all values, in the first reading of many
  std::optional<Bins> bins_;
  std::vector<double> found_;
  double value_ = 0;
  bool done_ = false;
};

}  // namespace

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

Box2 box_of_places(const PlaceStream& places, std::uint64_t count, double tail) {
  const auto rank = [&](double share) { return static_cast<std::uint64_t>(share * static_cast<double>(count - 1)); };
  const auto [u, v] = nth_places(places, count, {rank(tail), rank(1 - tail)});
  return {u[0], u[1], v[0], v[1]};
}

}  // namespace ilot
