// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/pulse_tracer.h"

#include <algorithm>

namespace ilot::scan {
namespace {

constexpr double kMinSeparation = 0.5;  // metres between echoes that the receiver can distinguish

// Leaves stop a pulse somewhere along its chord, more likely early than late. Half of the light continues. Returns
// whether any of it reaches the last echo.
bool add_crown_echoes(std::span<const CrownHit> crowns, double last, Rng& rng, std::vector<PulseEcho>& echoes) {
  bool passes = true;
  for (const CrownHit& hit : crowns) {
    const double length = hit.chord.leave - hit.chord.enter;
    const double first = rng.uniform(), second = rng.uniform(), share = rng.uniform();
    if (hit.chord.enter >= last || share > 0.9) continue;
    echoes.push_back({hit.chord.enter + length * first * first, PulseEcho::From::crown, 0});
    if (share < 0.5) echoes.push_back({hit.chord.enter + length * second, PulseEcho::From::crown, 0});
    if (share > 0.25 && share < 0.6) passes = false;
  }
  return passes;
}

void keep_separate(std::vector<PulseEcho>& echoes, double last) {
  std::erase_if(echoes, [&](const PulseEcho& e) { return e.range > last - kMinSeparation; });
  std::sort(echoes.begin(), echoes.end(), [](const PulseEcho& a, const PulseEcho& b) { return a.range < b.range; });
  const auto merged = std::unique(echoes.begin(), echoes.end(), [](const PulseEcho& a, const PulseEcho& b) {
    return b.range - a.range < kMinSeparation;
  });
  echoes.erase(merged, echoes.end());
  if (echoes.size() > kMaxEchoes - 1) echoes.resize(kMaxEchoes - 1);
}

}  // namespace

void find_echoes(std::span<const CrownHit> crowns, const PulseEcho& last, Rng& rng, std::vector<PulseEcho>& echoes) {
  echoes.clear();
  bool passes = true;
  if (!crowns.empty()) {
    passes = add_crown_echoes(crowns, last.range, rng, echoes);
    keep_separate(echoes, last.range);
  }
  if (passes || echoes.empty()) echoes.push_back(last);
}

void PulseTracer::trace(const Ray& ray, Rng& rng, std::vector<PulseEcho>& echoes) {
  scene_.cast(ray, found_);
  PulseEcho last{-signed_distance(ground_, ray.origin) / dot(ground_.n, ray.direction)};
  if (found_.solid && found_.solid->t < last.range) last = {found_.solid->t, PulseEcho::From::face, found_.solid->face};
  find_echoes(found_.crowns, last, rng, echoes);
}

}  // namespace ilot::scan
