// SPDX-License-Identifier: Apache-2.0
#include "engine/products/streets/objects/part_contacts.h"

#include <algorithm>
#include <array>
#include <bit>
#include <map>
#include <numeric>
#include <utility>

namespace ilot {
namespace {

constexpr int kReach = 2;  // pixels: the sampling step

struct PartBins {
  Occupancy bins = 0;
  std::array<double, kOccupancyBins> pixels{};  // by bin: number of pixels with a point in it
  std::map<std::uint32_t, Occupancy> touching;

  Occupancy touched() const {
    Occupancy all = 0;
    for (const auto& [other, bins_in_common] : touching) all |= bins_in_common;
    return all;
  }
};
using BinsByPart = std::map<std::uint32_t, PartBins>;

double share(Occupancy part, Occupancy of, double none) {
  return of == 0 ? none : static_cast<double>(std::popcount(part & of)) / std::popcount(of);
}

// Finds the bins of the parts and the bins in which they touch. Half of the pixels around each pixel are examined, so
// each pair is seen once.
BinsByPart bins_of_parts(const PixelLabels& parts, const std::vector<Occupancy>& occupancy) {
  std::vector<PartBins> bins_by_part(std::size_t{parts.count} + 1);
  const auto w = static_cast<int>(parts.width), h = static_cast<int>(parts.height);
  std::size_t i = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x, ++i) {
      const std::uint32_t a = parts.of[i];
      if (a == 0) continue;
      PartBins& part_bins = bins_by_part[a];
      if (occupancy[i] == 0) continue;
      part_bins.bins |= occupancy[i];
      for (Occupancy rest = occupancy[i]; rest != 0; rest &= rest - 1)
        ++part_bins.pixels[static_cast<std::size_t>(std::countr_zero(rest))];
      for (int v = y; v <= std::min(h - 1, y + kReach); ++v)
        for (int u = std::max(0, v == y ? x + 1 : x - kReach); u <= std::min(w - 1, x + kReach); ++u) {
          const auto q = static_cast<std::size_t>(v * w + u);
          const std::uint32_t b = parts.of[q];
          if (b == a || b == 0 || (occupancy[i] & occupancy[q]) == 0) continue;
          part_bins.touching[b] |= occupancy[i] & occupancy[q];
          bins_by_part[b].touching[a] |= occupancy[i] & occupancy[q];
        }
    }
  BinsByPart out;
  for (std::uint32_t a = 1; a < bins_by_part.size(); ++a) out[a] = std::move(bins_by_part[a]);
  return out;
}

// Replaces the two candidates of a join by their union, which has `number` from now on.
const PartBins& join(const Join& pair, std::uint32_t number, BinsByPart& bins_by_part) {
  PartBins whole = std::move(bins_by_part.at(pair.a));
  const PartBins other = std::move(bins_by_part.at(pair.b));
  whole.bins |= other.bins;
  for (std::size_t bin = 0; bin < kOccupancyBins; ++bin) whole.pixels[bin] += other.pixels[bin];
  for (const auto& [c, bins] : other.touching) whole.touching[c] |= bins;
  whole.touching.erase(pair.a), whole.touching.erase(pair.b);
  bins_by_part.erase(pair.a), bins_by_part.erase(pair.b);
  for (const auto& [c, bins] : whole.touching) {
    PartBins& beside = bins_by_part.at(c);
    beside.touching.erase(pair.a), beside.touching.erase(pair.b);
    beside.touching[number] = bins;
  }
  return bins_by_part[number] = std::move(whole);
}

void set_bin_features(const PartBins& s, double joint, const RasterScale& scale, ObjectCandidate& candidate) {
  const auto set = [&](CandidateFeature f, double v) { candidate.features[static_cast<std::size_t>(f)] = v; };
  const auto levels = static_cast<double>(std::bit_width(s.bins));
  const Occupancy touched = s.touched();
  set(CandidateFeature::upright_share, levels == 0 ? 0 : std::popcount(s.bins) / levels);
  const double most = *std::max_element(s.pixels.begin(), s.pixels.end());
  const double all = std::accumulate(s.pixels.begin(), s.pixels.end(), 0.0);
  set(CandidateFeature::evenness, levels == 0 ? 0 : all / (most * levels));
  set(CandidateFeature::free_run, longest_run(s.bins & ~touched).length * scale.bin());
  set(CandidateFeature::touch_share, share(touched, s.bins, 0));
  set(CandidateFeature::joint_share, joint);
}

}  // namespace

void set_contacts(const PixelLabels& parts, const std::vector<Occupancy>& occupancy, std::span<const Join> joins,
                  const RasterScale& scale, std::span<ObjectCandidate> candidates) {
  BinsByPart bins_by_part = bins_of_parts(parts, occupancy);
  for (const auto& [a, part_bins] : bins_by_part) set_bin_features(part_bins, 1, scale, candidates[a - 1]);
  std::uint32_t number = parts.count;
  for (const Join& pair : joins) {
    const PartBins &a = bins_by_part.at(pair.a), &b = bins_by_part.at(pair.b);
    const auto both = a.touching.find(pair.b);
    const Occupancy lesser = std::popcount(a.bins) <= std::popcount(b.bins) ? a.bins : b.bins;
    const double joint = share(both == a.touching.end() ? 0 : both->second, lesser, 1);
    ++number;
    set_bin_features(join(pair, number, bins_by_part), joint, scale, candidates[number - 1]);
  }
}

}  // namespace ilot
