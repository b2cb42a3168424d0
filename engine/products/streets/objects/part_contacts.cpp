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

struct Stand {
  Occupancy bins = 0;
  std::array<double, kOccupancyBins> pixels{};  // with a point in that bin
  std::map<std::uint32_t, Occupancy> touching;

  Occupancy touched() const {
    Occupancy all = 0;
    for (const auto& [other, bins_in_common] : touching) all |= bins_in_common;
    return all;
  }
};
using Stands = std::map<std::uint32_t, Stand>;

double share(Occupancy part, Occupancy of, double none) {
  return of == 0 ? none : static_cast<double>(std::popcount(part & of)) / std::popcount(of);
}

// The parts, and where they touch: half of the pixels around each, so each pair once.
Stands stands_of(const PixelLabels& parts, const std::vector<Occupancy>& occupancy) {
  std::vector<Stand> stands(std::size_t{parts.count} + 1);
  const auto w = static_cast<int>(parts.width), h = static_cast<int>(parts.height);
  std::size_t i = 0;
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x, ++i) {
      const std::uint32_t a = parts.of[i];
      if (a == 0) continue;
      Stand& stand = stands[a];
      if (occupancy[i] == 0) continue;
      stand.bins |= occupancy[i];
      for (Occupancy rest = occupancy[i]; rest != 0; rest &= rest - 1)
        ++stand.pixels[static_cast<std::size_t>(std::countr_zero(rest))];
      for (int v = y; v <= std::min(h - 1, y + kReach); ++v)
        for (int u = std::max(0, v == y ? x + 1 : x - kReach); u <= std::min(w - 1, x + kReach); ++u) {
          const auto q = static_cast<std::size_t>(v * w + u);
          const std::uint32_t b = parts.of[q];
          if (b == a || b == 0 || (occupancy[i] & occupancy[q]) == 0) continue;
          stand.touching[b] |= occupancy[i] & occupancy[q];
          stands[b].touching[a] |= occupancy[i] & occupancy[q];
        }
    }
  Stands out;
  for (std::uint32_t a = 1; a < stands.size(); ++a) out[a] = std::move(stands[a]);
  return out;
}

// Puts the two in place of which `number` stands from now on together.
const Stand& join(const Join& pair, std::uint32_t number, Stands& stands) {
  Stand whole = std::move(stands.at(pair.a));
  const Stand other = std::move(stands.at(pair.b));
  whole.bins |= other.bins;
  for (std::size_t bin = 0; bin < kOccupancyBins; ++bin) whole.pixels[bin] += other.pixels[bin];
  for (const auto& [c, bins] : other.touching) whole.touching[c] |= bins;
  whole.touching.erase(pair.a), whole.touching.erase(pair.b);
  stands.erase(pair.a), stands.erase(pair.b);
  for (const auto& [c, bins] : whole.touching) {
    Stand& beside = stands.at(c);
    beside.touching.erase(pair.a), beside.touching.erase(pair.b);
    beside.touching[number] = bins;
  }
  return stands[number] = std::move(whole);
}

void set_stand(const Stand& s, double joint, const RasterScale& scale, Thing& thing) {
  const auto set = [&](ThingFeature f, double v) { thing.features[static_cast<std::size_t>(f)] = v; };
  const auto levels = static_cast<double>(std::bit_width(s.bins));
  const Occupancy touched = s.touched();
  set(ThingFeature::upright_share, levels == 0 ? 0 : std::popcount(s.bins) / levels);
  const double most = *std::max_element(s.pixels.begin(), s.pixels.end());
  const double all = std::accumulate(s.pixels.begin(), s.pixels.end(), 0.0);
  set(ThingFeature::evenness, levels == 0 ? 0 : all / (most * levels));
  set(ThingFeature::free_run, longest_run(s.bins & ~touched).length * scale.bin());
  set(ThingFeature::touch_share, share(touched, s.bins, 0));
  set(ThingFeature::joint_share, joint);
}

}  // namespace

void set_contacts(const PixelLabels& parts, const std::vector<Occupancy>& occupancy, std::span<const Join> joins,
                  const RasterScale& scale, std::span<Thing> things) {
  Stands stands = stands_of(parts, occupancy);
  for (const auto& [a, stand] : stands) set_stand(stand, 1, scale, things[a - 1]);
  std::uint32_t number = parts.count;
  for (const Join& pair : joins) {
    const Stand &a = stands.at(pair.a), &b = stands.at(pair.b);
    const auto both = a.touching.find(pair.b);
    const Occupancy lesser = std::popcount(a.bins) <= std::popcount(b.bins) ? a.bins : b.bins;
    const double joint = share(both == a.touching.end() ? 0 : both->second, lesser, 1);
    ++number;
    set_stand(join(pair, number, stands), joint, scale, things[number - 1]);
  }
}

}  // namespace ilot
