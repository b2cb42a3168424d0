// SPDX-License-Identifier: Apache-2.0
#include "scan/streets/object_classes.h"

#include <array>

namespace ilot::scan {
namespace {

using L = PointLabel;

struct VariantClass {
  std::string_view variant;
  PointLabel label;
};

// Sheds, awnings, tables, parasols, stalls, kiosks, shelters, steps, ramps, statues, fountains, hydrants, prams, dogs,
// trailers, advertising columns and poles of wires are `other`: they are not here. `van` is a low one of a form of
// cars.
constexpr std::array kClasses{
    VariantClass{"city", L::car},
    VariantClass{"hatchback", L::car},
    VariantClass{"saloon", L::car},
    VariantClass{"estate", L::car},
    VariantClass{"suv", L::car},
    VariantClass{"van", L::car},
    VariantClass{"pickup", L::car},
    VariantClass{"car", L::car},
    VariantClass{"covered_car", L::car},
    VariantClass{"panel_van", L::van},
    VariantClass{"lorry", L::van},
    VariantClass{"articulated_lorry", L::van},
    VariantClass{"bus", L::van},
    VariantClass{"caravan", L::van},
    VariantClass{"motorbike", L::two_wheeler},
    VariantClass{"motorcycle", L::two_wheeler},
    VariantClass{"moped", L::two_wheeler},
    VariantClass{"kick_scooter", L::two_wheeler},
    VariantClass{"bicycle", L::two_wheeler},
    VariantClass{"cargo_bicycle", L::two_wheeler},
    VariantClass{"bicycle_rack", L::two_wheeler},
    VariantClass{"cyclist", L::two_wheeler},
    VariantClass{"standing", L::pedestrian},
    VariantClass{"walking", L::pedestrian},
    VariantClass{"bag", L::pedestrian},
    VariantClass{"backpack", L::pedestrian},
    VariantClass{"umbrella", L::pedestrian},
    VariantClass{"phone", L::pedestrian},
    VariantClass{"child", L::pedestrian},
    VariantClass{"walker", L::pedestrian},
    VariantClass{"standing_person", L::pedestrian},
    VariantClass{"sitting_person", L::pedestrian},
    VariantClass{"wheelchair", L::pedestrian},
    VariantClass{"candelabra", L::lamppost},
    VariantClass{"arm", L::lamppost},
    VariantClass{"double_arm", L::lamppost},
    VariantClass{"mast", L::lamppost},
    VariantClass{"lantern", L::lamppost},
    VariantClass{"ball", L::lamppost},
    VariantClass{"lamppost", L::lamppost},
    VariantClass{"hung_lamp", L::lamppost},
    VariantClass{"sign", L::sign},
    VariantClass{"traffic_light", L::sign},
    VariantClass{"traffic_light_arm", L::sign},
    VariantClass{"round_sign", L::sign},
    VariantClass{"triangle_sign", L::sign},
    VariantClass{"direction_sign", L::sign},
    VariantClass{"bollard", L::bollard},
    VariantClass{"bollard_light", L::bollard},
    VariantClass{"stone_ball", L::bollard},
    VariantClass{"dustbin", L::bin},
    VariantClass{"wheelie_bin", L::bin},
    VariantClass{"litter_bin", L::bin},
    VariantClass{"wheelie_bins", L::bin},
    VariantClass{"waste_container", L::bin},
    VariantClass{"igloo_container", L::bin},
    VariantClass{"skip", L::bin},
    VariantClass{"bench", L::bench},
    VariantClass{"stone_bench", L::bench},
    VariantClass{"planter", L::planter},
    VariantClass{"slat_fence", L::fence},
    VariantClass{"mesh_fence", L::fence},
    VariantClass{"site_fence", L::fence},
    VariantClass{"railing", L::fence},
    VariantClass{"garden_wall", L::fence},
    VariantClass{"concrete_barrier", L::fence},
    VariantClass{"cabinet", L::cabinet},
    VariantClass{"parking_meter", L::cabinet},
    VariantClass{"pay_station", L::cabinet},
    VariantClass{"meter", L::cabinet},
    VariantClass{"post_box", L::cabinet},
    VariantClass{"letter_box", L::cabinet},
    VariantClass{"charging_post", L::cabinet},
};

}  // namespace

PointLabel object_class_of(std::string_view variant) {
  for (const VariantClass& v : kClasses)
    if (v.variant == variant) return v.label;
  return PointLabel::other;
}

ArtefactClass artefact_class_of(std::string_view variant) {
  switch (group_of(object_class_of(variant))) {
    case PointLabel::car:
      return ArtefactClass::car;
    case PointLabel::lamppost:
      return ArtefactClass::lamppost;
    case PointLabel::pedestrian:
      return ArtefactClass::pedestrian;
    default:
      return ArtefactClass::other;
  }
}

}  // namespace ilot::scan
