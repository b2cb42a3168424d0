// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/artefact.h"

#include <algorithm>
#include <array>

namespace ilot::scan {
namespace {

constexpr std::array<std::string_view, 7> kCars{"city", "hatchback", "saloon", "estate", "suv", "van", "pickup"};
constexpr std::array<std::string_view, 6> kLampposts{"candelabra", "arm", "double_arm", "mast", "lantern", "ball"};
constexpr std::array<std::string_view, 7> kPedestrians{"standing", "walking", "bag",  "backpack",
                                                       "umbrella", "phone",   "child"};

struct Share {
  std::string_view variant;
  int of_144;
};
constexpr std::array<Share, 12> kOthers{{{"dustbin", 22},
                                         {"wheelie_bin", 14},
                                         {"motorbike", 22},
                                         {"bicycle", 12},
                                         {"parking_meter", 16},
                                         {"pay_station", 12},
                                         {"bus_shelter", 8},
                                         {"bollard", 12},
                                         {"bench", 8},
                                         {"sign", 8},
                                         {"advert_column", 4},
                                         {"post_box", 6}}};

std::vector<std::string_view> spread(std::span<const Share> shares) {
  std::vector<std::string_view> all;
  for (const Share& share : shares) all.insert(all.end(), static_cast<std::size_t>(share.of_144), share.variant);
  return all;
}

SurfaceId surface(Material material) {
  return static_cast<SurfaceId>(material);
}

}  // namespace

const char* name_of(ArtefactClass artefact_class) {
  switch (artefact_class) {  // without a default: the compiler names what a new class lacks
    case ArtefactClass::car:
      return "car";
    case ArtefactClass::lamppost:
      return "lamppost";
    case ArtefactClass::pedestrian:
      return "pedestrian";
    case ArtefactClass::other:
      return "other";
  }
  return "other";
}

void Artefact::box(Vec3 centre, Vec3 size, Material material) {
  const Vec3 low = centre - 0.5 * size;
  const std::array<Vec3, 4> ring{
      {low, low + Vec3{size.x, 0, 0}, low + Vec3{size.x, size.y, 0}, low + Vec3{0, size.y, 0}}};
  solids.push_back(prism(ring, {0, 0, size.z}, surface(material)));
}

Solid& Artefact::profile(std::span<const FlatPoint> outline, double width, Material material) {
  std::vector<Vec3> ring;
  for (FlatPoint p : outline) ring.push_back({p.x, -width / 2, p.y});
  solids.push_back(prism(ring, {0, width, 0}, surface(material)));
  return solids.back();
}

void Artefact::column(std::span<const FlatPoint> outline, double from, double to, Material material) {
  std::vector<Vec3> ring;
  for (FlatPoint p : outline) ring.push_back({p.x, p.y, from});
  solids.push_back(prism(ring, {0, 0, to - from}, surface(material)));
}

void Artefact::rod(Vec3 from, Vec3 to, double radius, Material material) {
  const double length = norm(to - from);
  solids.push_back(cylinder(from, (1 / length) * (to - from), length, radius, surface(material)));
}

void Artefact::disc(Vec3 centre, Vec3 axis, double thickness, double radius, Material material) {
  solids.push_back(cylinder(centre - thickness / 2 * axis, axis, thickness, radius, surface(material)));
}

void Artefact::ball(Vec3 centre, double radius, Material material) {
  solids.push_back(sphere(centre, radius, surface(material)));
}

void Artefact::taper(Vec3 base, double height, double bottom_radius, double top_radius, Material material) {
  const double tangent = (bottom_radius - top_radius) / height;
  const Vec3 apex = base + Vec3{0, 0, bottom_radius / tangent};
  solids.push_back(cone(apex, {0, 0, -1}, top_radius / tangent, bottom_radius / tangent, tangent, surface(material)));
}

Box3<Vec3> bounds_of(const Artefact& artefact) {
  Box3<Vec3> all = artefact.solids[0].bounds;
  for (const Solid& solid : artefact.solids) all.add_box(solid.bounds);
  return all;
}

std::span<const std::string_view> variants_of(ArtefactClass artefact_class) {
  static const std::vector<std::string_view> others = spread(kOthers);
  switch (artefact_class) {
    case ArtefactClass::car:
      return kCars;
    case ArtefactClass::lamppost:
      return kLampposts;
    case ArtefactClass::pedestrian:
      return kPedestrians;
    default:
      return others;
  }
}

Artefact make_artefact(ArtefactClass artefact_class, std::string_view variant, Rng& rng) {
  switch (artefact_class) {
    case ArtefactClass::car:
      return make_car(variant, rng);
    case ArtefactClass::lamppost:
      return make_lamppost(variant, rng);
    case ArtefactClass::pedestrian:
      return make_pedestrian(variant, rng);
    default:
      return make_furniture(variant, rng);
  }
}

}  // namespace ilot::scan
