// SPDX-License-Identifier: Apache-2.0
#include "scan/wild/street/wild_tracer.h"

#include <algorithm>
#include <cmath>

#include "scan/optics/ray_box.h"
#include "scan/optics/value_noise.h"

namespace ilot::scan {
namespace {

constexpr std::size_t kMostEchoes = 5;
constexpr double kLeafStep = 0.2;   // metres along a ray within a crown
constexpr double kTwigs = 0.16;     // metres, size of the clumps of leaves
constexpr double kBranches = 0.55;  // metres, between branches
constexpr double kLeafCosine = 0.6;
constexpr double kPassesLeaf = 0.45;  // chance that a part of the pulse goes on behind a leaf
constexpr double kJump = 25;          // metres
constexpr double kThere = 0.6;        // chance that what comes and goes is there

constexpr double kWidest = 2.5;  // standard deviations of the footprint

// Returns how far the rays of a footprint are from its axis, at most.
double reach_of(const WildBeam& beam) {
  return 1.5 * kWidest * beam.divergence_mrad * 0.00025 * beam.range;
}

std::vector<Crown> crowns_of(const WildStreetModel& model) {
  std::vector<Crown> crowns;
  for (const LeafBall& ball : model.leaves) crowns.push_back(ball.crown);
  return crowns;
}

}  // namespace

std::optional<Vec3> offset_at(const WildMotion& motion, double time, std::uint16_t visit) {
  Rng rng(motion.key, visit);
  const double there = rng.uniform(), when = rng.uniform();
  if (motion.comes_and_goes && there > kThere) return std::nullopt;
  if (dot(motion.velocity, motion.velocity) == 0) return Vec3{};
  if (motion.jumps) return ((2 * when - 1) * kJump / norm(motion.velocity)) * motion.velocity;
  const double at_base = motion.sweep > 0 ? motion.sweep * when : motion.at_base;
  return (time - at_base) * motion.velocity;
}

WildOptics::WildOptics(const WildStreetModel& model, const WildBeam& beam, std::vector<WildMotion> motions, Vec3 anchor,
                       std::uint64_t seed)
    : model_(model),
      beam_(beam),
      motions_(std::move(motions)),
      crowns_(crowns_of(model)),
      parts_(model.street.scene.parts, reach_of(beam)),
      leaves_({}, crowns_, anchor),
      seed_(seed) {}

std::optional<WildTracer::Met> WildTracer::nearest(const Ray& ray, double from, double time,
                                                   std::uint16_t visit) const {
  std::optional<PartHit> best = optics_.parts_.nearest(ray, candidates_, from);
  for (std::size_t i = 0; i < optics_.motions_.size(); ++i) {
    const auto offset = offset_at(optics_.motions_[i], time, visit);
    if (!offset) continue;
    const WildMoving& moving = optics_.model_.moving[i];
    const Ray shifted{ray.origin - *offset, ray.direction};
    if (!std::isfinite(entry(shifted, moving.bounds))) continue;
    for (const Part& part : moving.parts)
      if (const auto hit = meet(shifted, part, from); hit && (!best || hit->t < best->t)) best = hit;
  }
  if (!best || best->t > optics_.beam_.range) return std::nullopt;
  return Met{best->t, -dot(best->normal, ray.direction), best->surface};
}

bool WildTracer::is_lost(const Met& met, Vec3 place, double chance) const {
  const Material material = optics_.model_.street.scene.surfaces[met.surface].material;
  if (material == Material::car_paint) return chance < 0.12;
  if (material == Material::iron) return chance < 0.06;
  if (material != Material::asphalt || optics_.beam_.wet <= 0) return false;
  const double puddle = 0.5 + 0.5 * value_noise(0.4 * place, optics_.seed_);
  return puddle < optics_.beam_.wet && chance < 0.95;
}

// Returns the echo of a solid; the pulse may pass up to four panes before it. `chance` is one number for the pulse.
std::optional<WildTracer::Met> WildTracer::solid_echo(const Ray& ray, double chance, const StreetPulse& pulse) const {
  double from = optics_.beam_.nearest;
  for (int pane = 0; pane < 4; ++pane) {
    const auto met = nearest(ray, from, pulse.time, pulse.visit);
    if (!met) return std::nullopt;
    if (optics_.model_.street.scene.surfaces[met->surface].material != Material::glass) {
      if (is_lost(*met, point_at(ray, met->range), chance)) return std::nullopt;
      return met;
    }
    const double echo = optics_.beam_.glass_echo;
    if (chance < echo) return met;
    chance = (chance - echo) / (1 - echo);
    if (chance >= optics_.beam_.glass_through) return std::nullopt;
    chance /= optics_.beam_.glass_through;
    from = met->range + 1e-4;
  }
  return std::nullopt;
}

// Returns how far a surface stands out of its plane, along the ray: ground and walls are not flat.
double WildTracer::relief(const SurfaceLabel& label, Vec3 place, double cosine) const {
  const double shorten = 1 / std::max(0.2, cosine);
  if (label.true_class == static_cast<std::uint8_t>(StreetClass::ground)) {
    const double share = label.material == Material::grass ? 1 : label.material == Material::paving ? 0.35 : 0.2;
    const double wide = value_noise(0.25 * place, optics_.seed_ + 1),
                 fine = value_noise(3.0 * place, optics_.seed_ + 2);
    return optics_.beam_.roughness * share * (1.2 * wide + 0.5 * fine) * shorten;
  }
  if (label.true_class == static_cast<std::uint8_t>(StreetClass::facade))
    return optics_.beam_.bow * value_noise(0.3 * place, optics_.seed_ + 3) * shorten;
  return 0;
}

WildEcho WildTracer::echo_of(const Met& met, const Ray& ray) const {
  const SurfaceLabel& label = optics_.model_.street.scene.surfaces[met.surface];
  const double range = met.range - relief(label, point_at(ray, met.range), met.cosine);
  return {range, range, met.cosine, label};
}

// Leaves hang in clumps on branches, with gaps between both, and thin out towards the outline of their ball.
double WildTracer::leaf_chance(const LeafBall& ball, Vec3 place) const {
  const Vec3 d = place - ball.crown.centre, r = ball.crown.radii;
  const double out = d.x * d.x / (r.x * r.x) + d.y * d.y / (r.y * r.y) + d.z * d.z / (r.z * r.z);
  const double branch = value_noise((1 / kBranches) * place, optics_.seed_ + 5);
  const double clump = 0.6 * branch + 0.4 * value_noise((1 / kTwigs) * place, optics_.seed_ + 4);
  return 6 * ball.density * kLeafStep * std::max(0.0, clump) * std::min(1.0, 1.8 * (1 - out));
}

void WildTracer::add_leaves(StreetPulse& pulse, double farthest, std::vector<WildEcho>& echoes) {
  optics_.leaves_.cast(pulse.ray, crossed_);
  std::sort(crossed_.crowns.begin(), crossed_.crowns.end(), [](const CrownHit& a, const CrownHit& b) {
    return a.chord.enter != b.chord.enter ? a.chord.enter < b.chord.enter : a.crown < b.crown;
  });
  double done = optics_.beam_.nearest;  // crowns overlap: what was passed is passed
  for (const CrownHit& hit : crossed_.crowns) {
    const LeafBall& ball = optics_.model_.leaves[hit.crown];
    const double end = std::min(hit.chord.leave, farthest);
    for (double t = std::max(done, hit.chord.enter) + kLeafStep * pulse.rng.uniform(); t < end; t += kLeafStep) {
      done = t;
      const double chance = leaf_chance(ball, point_at(pulse.ray, t));
      if (pulse.rng.uniform() >= chance) continue;
      const SurfaceLabel leaf{static_cast<std::uint8_t>(StreetClass::vegetation), 0, ball.object, Material::foliage};
      const bool apart = echoes.empty() || t - echoes.back().range > optics_.beam_.separation;
      if (apart) echoes.push_back({t, t, kLeafCosine, leaf});
      if (echoes.size() == kMostEchoes || pulse.rng.uniform() > kPassesLeaf) return;
    }
  }
}

void WildTracer::trace(StreetPulse& pulse, std::vector<WildEcho>& echoes) {
  echoes.clear();
  const WildBeam& beam = optics_.beam_;
  optics_.parts_.candidates(pulse.ray, candidates_);
  const double chance = pulse.rng.uniform();
  // The footprint is its axis and one more ray, which stands for the rest of it.
  const double spread = beam.divergence_mrad * 0.00025;
  const double right = spread * std::clamp(gaussian(pulse.rng), -kWidest, kWidest);
  const double up = spread * std::clamp(gaussian(pulse.rng), -kWidest, kWidest);
  const auto first = solid_echo(pulse.ray, chance, pulse);
  const Vec3 way = pulse.ray.direction + right * pulse.right + up * pulse.up;
  const auto second = solid_echo({pulse.ray.origin, (1 / norm(way)) * way}, chance, pulse);
  const double share = pulse.rng.uniform();
  add_leaves(pulse, first ? first->range : beam.range, echoes);
  const bool blocked = !echoes.empty() && pulse.rng.uniform() > kPassesLeaf;
  if (blocked || !first || echoes.size() == kMostEchoes) return;
  WildEcho echo = echo_of(*first, pulse.ray);
  const SceneModel& scene = optics_.model_.street.scene;
  const double apart = second ? second->range - first->range : 0;
  const bool same = !second || second->surface == first->surface ||
                    (scene.surfaces[first->surface].element == scene.surfaces[second->surface].element &&
                     std::abs(apart) < beam.noise);
  if (same || std::abs(apart) < 0.003) {
    echoes.push_back(echo);
  } else if (std::abs(apart) < beam.separation) {
    // Both reach the receiver as one: the point hangs between the surfaces.
    echo.range += 0.5 * share * apart;
    if (std::abs(echo.range - echo.surface_range) > std::max(beam.noise, 0.005))
      echo.label = {0, 0, 0, echo.label.material};
    echoes.push_back(echo);
  } else {
    const WildEcho other = echo_of(*second, pulse.ray);
    if (apart > 0) echoes.push_back(echo);
    if (share < 0.5 && echoes.size() < kMostEchoes) echoes.push_back(other);
    if (apart < 0 && echoes.size() < kMostEchoes) echoes.push_back(echo);
  }
}

std::uint32_t WildTracer::element_met(const Ray& ray, double time, std::uint16_t visit) {
  optics_.parts_.candidates(ray, candidates_);
  const auto met = nearest(ray, optics_.beam_.nearest, time, visit);
  const double range = met ? met->range : optics_.beam_.range;
  optics_.leaves_.cast(ray, crossed_);
  // A crown hides what is behind more than a metre and a half of it.
  double through = 0, first = range;
  std::uint32_t leaf = 0;
  for (const CrownHit& hit : crossed_.crowns) {
    const double enter = std::max(0.0, hit.chord.enter), leave = std::min(range, hit.chord.leave);
    if (leave <= enter) continue;
    through += leave - enter;
    if (enter < first) first = enter, leaf = optics_.model_.leaves[hit.crown].object;
  }
  if (through > 1.5) return leaf;
  return met ? optics_.model_.street.scene.surfaces[met->surface].element : leaf;
}

}  // namespace ilot::scan
