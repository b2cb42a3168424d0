// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/beam.h"

#include <algorithm>
#include <array>
#include <span>

#include "scan/optics/exact_math.h"
#include "scan/scanners/pulse_tracer.h"

namespace ilot::scan {
namespace {

constexpr double kRadiansPerDegree = 3.14159265358979323846 / 180;
constexpr double kMinEnergy = 0.004;  // the receiver detects nothing below this energy
constexpr double kBehind = 1e-4;      // metres behind a pane where the ray continues

// A position in the footprint in units of its radius, and its share of the light. A Gaussian beam has a quarter of its
// energy within 0.38 of its 1/e2 radius. The rest is spread over a ring with a mean radius of 0.62.
struct Spot {
  double right, up, share;
};
constexpr double kRing = 0.62, kHalf = 0.5 * kRing, kHeight = 0.8660254037844386 * kRing;
constexpr std::array<Spot, 7> kFootprint{{{0, 0, 0.25},
                                          {kRing, 0, 0.125},
                                          {kHalf, kHeight, 0.125},
                                          {-kHalf, kHeight, 0.125},
                                          {-kRing, 0, 0.125},
                                          {-kHalf, -kHeight, 0.125},
                                          {kHalf, -kHeight, 0.125}}};

double cosine_of(const PartHit& hit, const Ray& ray) {
  constexpr double kGrazing = 0.05;  // rays along a pane do not run through rooms for ever
  return std::max(kGrazing, -dot(hit.normal, ray.direction));
}

// Dust lies in patches of half a metre. Returns a smooth value in [0, 1] for a place.
double dust_at(Vec3 place) {
  WallRelief patches;
  patches.roughness = 0.5;
  patches.grain = 0.5;
  return std::clamp(0.5 + relief_at(patches, place.x + 0.7 * place.y, place.z), 0.0, 1.0);
}

// The flatter the light falls on a dusty pane, the more of it is mirrored away.
Transmission through_dust(const PartHit& pane, const Ray& ray) {
  const double cosine = -dot(pane.normal, ray.direction);
  return {std::clamp(1.1 - 1.2 * cosine, 0.05, 0.95), 0};
}

Vec3 unit(Vec3 v) {
  return (1 / norm(v)) * v;
}

}  // namespace

Transmission transmission(Material material) {
  switch (material) {
    case Material::glass:
      return {0.66, 0.13};
    case Material::dark_glass:
      return {1, 0};
    case Material::clear_glass:
      return {0.25, 0.7};
    case Material::car_paint:
      return {0.15, 0};
    case Material::iron:
      return {0.08, 0};
    case Material::foliage:
      return {0.05, 0.45};
    default:
      return {};
  }
}

// Rooms are from half to one and a half times as deep as the mean, the same for all of a window's panes.
double BeamTracer::room_depth(SurfaceId pane) const {
  const std::uint64_t key = model_.surfaces[pane].element ? model_.surfaces[pane].element : pane;
  return beam_.room * (0.5 + Rng(0x726f6f6dull, key).uniform());
}

Transmission BeamTracer::way_of(Material material) const {
  return material == Material::glass ? beam_.glass : transmission(material);
}

// The scanner sees what a mirror shows as if it were behind the mirror, at the length of the whole way. Mirrors in a
// mirror show nothing.
void BeamTracer::follow_mirror(const Ray& ray, const PartHit& mirror, double weight, const MirrorImage& image) {
  const Ray way{point_at(ray, mirror.t), unit(ray.direction - 2 * dot(ray.direction, mirror.normal) * mirror.normal)};
  scene_.candidates(way, mirrored_);
  const auto hit = scene_.nearest(way, mirrored_, kBehind);
  if (!hit || mirror.t + hit->t > beam_.farthest) return;
  const Material material = model_.surfaces[hit->surface].material;
  if (transmission(material).lost > 0.5) return;
  const double cosine = -dot(hit->normal, way.direction);
  touches_.push_back({mirror.t + hit->t, weight * reflectance(material) * cosine, image.surface.value_or(hit->surface),
                      cosine, image.pane});
}

// `chance` is one number in [0, 1) for the whole pulse, so a pane has the same effect on the whole footprint.
void BeamTracer::touch(const Ray& ray, double weight, double chance) {
  double from = 0;
  std::optional<SurfaceId> behind;
  double room_end = beam_.farthest;
  for (int pane = 0; pane < 4; ++pane) {
    const auto hit = scene_.nearest(ray, candidates_, from);
    if (behind && room_end < beam_.farthest && (!hit || hit->t > room_end)) {
      touches_.push_back({room_end, weight * reflectance(Material::interior), *behind, 1, behind});
      return;
    }
    if (!hit || hit->t > beam_.farthest) return;
    if (!first_) first_ = hit->surface;
    const Material material = model_.surfaces[hit->surface].material;
    if (material == Material::mirror_glass) {
      if (beam_.mirrored) follow_mirror(ray, *hit, weight, {beam_.mirrored, {}});
      return;
    }
    const bool dusty = material == Material::dusty_glass;
    const Transmission way = dusty ? through_dust(*hit, ray) : way_of(material);
    if (dusty) chance = dust_at(point_at(ray, hit->t));
    if (chance < way.lost) return;
    if (chance >= way.lost + way.through + way.mirrored) {
      const double cosine = -dot(hit->normal, ray.direction);
      touches_.push_back({hit->t, weight * reflectance(material) * cosine, hit->surface, cosine, behind});
      return;
    }
    if (!behind) behind = hit->surface;
    if (chance >= way.lost + way.through) {
      follow_mirror(ray, *hit, weight, {{}, behind});
      return;
    }
    from = hit->t + kBehind;
    if (beam_.room > 0 && *behind == hit->surface) room_end = hit->t + room_depth(hit->surface) / cosine_of(*hit, ray);
    weight *= 0.7;
    chance = (chance - way.lost) / way.through;  // makes it uniform again
  }
}

bool BeamTracer::one_plane(SurfaceId a, SurfaceId b) const {
  const std::uint32_t plane = model_.surfaces[a].plane;
  return a == b || (plane != 0 && plane == model_.surfaces[b].plane);
}

void BeamTracer::gather(std::vector<Echo>& echoes) const {
  for (std::size_t first = 0; first < touches_.size();) {
    std::size_t end = first;
    double energy = 0, moment = 0;
    while (end < touches_.size() && touches_[end].range - touches_[first].range <= beam_.separation) {
      energy += touches_[end].energy;
      moment += touches_[end].energy * touches_[end].range;
      ++end;
    }
    // The echo gets the surface with most energy, of equal ones the nearest, and the mean range of that surface.
    Echo echo{energy > 0 ? moment / energy : 0, energy, 0, 0, 1, {}};
    double most = 0;
    for (std::size_t i = first; i < end; ++i) {
      double own = 0, own_moment = 0;
      for (std::size_t j = first; j < end; ++j) {
        if (!one_plane(touches_[j].surface, touches_[i].surface)) continue;
        own += touches_[j].energy;
        own_moment += touches_[j].energy * touches_[j].range;
      }
      if (!(own > most)) continue;
      most = own;
      echo.surface = touches_[i].surface;
      echo.pane = touches_[i].pane;
      echo.surface_range = own_moment / own;
      echo.cosine = touches_[i].cosine;
    }
    if (energy >= kMinEnergy && echoes.size() < kMaxEchoes) echoes.push_back(echo);
    first = end;
  }
}

void BeamTracer::trace(Vec3 origin, const Aim& aim, Rng& rng, std::vector<Echo>& echoes) {
  echoes.clear();
  touches_.clear();
  first_.reset();
  const double wander = beam_.angle_noise_deg * kRadiansPerDegree;
  const double right = wander * gaussian(rng), up = wander * gaussian(rng);
  const double chance = rng.uniform();
  const Vec3 axis = unit(aim.axis + right * aim.right + up * aim.up);
  scene_.candidates({origin, axis}, candidates_);
  if (candidates_.empty()) return;
  const double spread = beam_.divergence_mrad * 0.0005;
  const bool thin = spread == 0 && beam_.diameter == 0;
  if (thin) touch({origin, axis}, 1, chance);
  for (const Spot& spot : std::span(kFootprint).first(thin ? 0 : kFootprint.size())) {
    const Vec3 offset = spot.right * aim.right + spot.up * aim.up;
    touch({origin + (beam_.diameter / 2) * offset, unit(axis + spread * offset)}, spot.share, chance);
  }
  std::sort(touches_.begin(), touches_.end(), [](const Touch& a, const Touch& b) {
    return a.range != b.range ? a.range < b.range : a.surface < b.surface;
  });
  gather(echoes);
}

}  // namespace ilot::scan
