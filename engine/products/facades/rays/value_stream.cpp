// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/rays/value_stream.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "kernels/core/quantile.h"

namespace ilot {
namespace {

// The values among which the wanted one is.
struct Candidates {
  double low = INFINITY, high = -INFINITY;  // the least and the greatest of them
  std::uint64_t count = 0;
};

double nth_in_memory(const ValueStream& values, const Candidates& among, std::uint64_t rank) {
  std::vector<double> found;
  found.reserve(among.count);
  values([&](double v) {
    if (v >= among.low && v <= among.high) found.push_back(v);
  });
  return nth_smallest(found, rank);
}

// Counts the candidates in bins and keeps those in the bin of the wanted value. Returns the rank of the wanted value
// among them.
std::uint64_t narrow(const ValueStream& values, std::uint64_t rank, Candidates& among) {
  constexpr std::size_t kBins = 2048;
  std::vector<Candidates> bins(kBins);
  const double low = among.low, high = among.high;
  values([&](double v) {
    if (v < low || v > high) return;
    Candidates& bin = bins[std::min(kBins - 1, static_cast<std::size_t>((v - low) / (high - low) * kBins))];
    bin.low = std::min(bin.low, v), bin.high = std::max(bin.high, v);
    ++bin.count;
  });
  std::size_t at = 0;
  while (rank >= bins[at].count) rank -= bins[at++].count;
  among = bins[at];
  return rank;
}

}  // namespace

double nth_value(const ValueStream& values, std::uint64_t count, std::uint64_t rank) {
  constexpr std::uint64_t kInMemory = 1 << 15;
  Candidates among{-INFINITY, INFINITY, count};
  if (count > kInMemory) {
    among = {INFINITY, -INFINITY, count};
    values([&](double v) { among.low = std::min(among.low, v), among.high = std::max(among.high, v); });
  }
  while (among.count > kInMemory && among.low < among.high) rank = narrow(values, rank, among);
  return among.count > kInMemory ? among.low : nth_in_memory(values, among, rank);
}

}  // namespace ilot
