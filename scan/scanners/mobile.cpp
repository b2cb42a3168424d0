// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/mobile.h"

#include <algorithm>
#include <cmath>

#include "kernels/core/rng.h"
#include "scan/optics/exact_math.h"

namespace ilot::scan {
namespace {

constexpr double kNearest = 0.8;  // metres: nearer echoes are from the vehicle itself

// Leaves stop two pulses in three, more likely early than late on the path through a crown.
std::optional<double> leaf_range(const std::vector<CrownHit>& crowns, double farthest, Rng& rng) {
  std::optional<double> nearest;
  for (const CrownHit& hit : crowns) {
    const double chance = rng.uniform(), depth = rng.uniform();
    if (chance > 0.66) continue;
    const double range = hit.chord.enter + (hit.chord.leave - hit.chord.enter) * depth * depth;
    if (range > kNearest && range < farthest && (!nearest || range < *nearest)) nearest = range;
  }
  return nearest;
}

}  // namespace

std::uint64_t profile_count(const MobileParams& params) {
  return static_cast<std::uint64_t>(std::floor((params.to - params.from) * params.profiles));
}

Vec3 head_position(const MobileParams& params, const MobileScene& scene, double s) {
  return {s, params.lane, scene.base + scene.slope * s + params.height};
}

Vec3 pulse_direction(const MobileParams& params, int head, double angle_deg) {
  const SinCos turned = sin_cos_deg(head == 1 ? params.turned_deg : -params.turned_deg), angle = sin_cos_deg(angle_deg);
  return {angle.sin * turned.sin, angle.sin * turned.cos, angle.cos};
}

MobileScanner::MobileScanner(const MobileParams& params, const MobileScene& scene) : params_(params), scene_(scene) {
  const auto steps = static_cast<std::int64_t>((180 - params.blind_deg / 2) / params.step_deg);
  for (std::int64_t step = -steps; step <= steps; ++step) {
    angles_.push_back(static_cast<double>(step) * params.step_deg);
    for (int head : {1, 2})
      directions_[static_cast<std::size_t>(head - 1)].push_back(pulse_direction(params, head, angles_.back()));
  }
}

std::optional<MobileScanner::Found> MobileScanner::look(const Ray& ray, Rng& rng) {
  std::optional<Found> found;
  scene_.parts.candidates(ray, candidates_);
  if (const auto hit = scene_.parts.nearest(ray, candidates_, kNearest); hit && hit->t < params_.range)
    found = Found{hit->t, -dot(hit->normal, ray.direction), scene_.model.surfaces[hit->surface]};
  scene_.crowns.cast(ray, crowns_);
  if (crowns_.crowns.empty()) return found;
  if (const auto leaf = leaf_range(crowns_.crowns, found ? found->range : params_.range, rng))
    found = Found{*leaf, 0.7, scene_.leaves};
  return found;
}

void MobileScanner::scan(std::uint64_t profile, int head, const std::function<void(const MobileEcho&)>& visit) {
  const double duration = 1 / (params_.profiles * params_.speed);
  const auto index = static_cast<std::size_t>(head - 1);
  for (std::size_t pulse = 0; pulse < angles_.size(); ++pulse) {
    Rng rng(params_.seed ^ 0x6d6f62696c65ull, (profile << 24) ^ (index << 23) ^ pulse);
    // The second head is half a turn behind.
    const double turns = static_cast<double>(profile) + angles_[pulse] / 360 + 0.5 + (head == 1 ? 0 : 0.5);
    const Ray ray{head_position(params_, scene_, params_.from + turns / params_.profiles), directions_[index][pulse]};
    const auto found = look(ray, rng);
    if (!found) continue;
    MobileEcho echo;
    echo.surface_place = point_at(ray, found->range);
    echo.place = point_at(ray, found->range + params_.noise * gaussian(rng));
    echo.cosine = found->cosine;
    echo.range = found->range;
    echo.label = found->label;
    echo.head = static_cast<std::uint8_t>(head);
    echo.angle_deg = angles_[pulse];
    echo.time = turns * duration;
    visit(echo);
  }
}

}  // namespace ilot::scan
