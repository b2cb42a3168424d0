// SPDX-License-Identifier: Apache-2.0
#include "scan/optics/material.h"

#include <algorithm>
#include <cmath>

#include "scan/optics/value_noise.h"

namespace ilot::scan {
namespace {

struct Recipe {
  double reflectance;
  std::array<double, 3> colour;  // 0 to 255
  double spots;                  // relative swing of the brightness, in spots of spot_size
  double spot_size;              // metres
  double grain;                  // relative swing from one centimetre to the next
  double warmth;                 // swing between red and blue, with the spots
};

Recipe recipe_of(Material material) {
  switch (material) {
    case Material::limestone:
      return {0.55, {208, 193, 165}, 0.13, 0.3, 0.08, 0.025};
    case Material::render:
      return {0.65, {214, 206, 190}, 0.07, 0.9, 0.04, 0.03};
    case Material::brick:
      return {0.4, {160, 92, 70}, 0.2, 0.15, 0.08, 0.06};
    case Material::mortar:
      return {0.45, {176, 164, 142}, 0.14, 0.2, 0.08, 0.04};
    case Material::slate:
      return {0.18, {84, 90, 102}, 0.2, 0.25, 0.06, 0.04};
    case Material::zinc:
      return {0.3, {142, 150, 158}, 0.08, 0.8, 0.03, 0.02};
    case Material::tile:
      return {0.4, {168, 88, 62}, 0.22, 0.2, 0.06, 0.05};
    case Material::glass:
    case Material::dark_glass:
    case Material::clear_glass:
    case Material::mirror_glass:
    case Material::dusty_glass:
      return {0.12, {92, 108, 118}, 0.25, 0.7, 0.02, 0.06};
    case Material::wood:
      return {0.45, {192, 188, 178}, 0.08, 0.4, 0.05, 0.03};
    case Material::iron:
      return {0.15, {48, 50, 54}, 0.15, 0.2, 0.06, 0.02};
    case Material::asphalt:
      return {0.12, {88, 88, 90}, 0.12, 0.8, 0.09, 0.01};
    case Material::paving:
      return {0.3, {150, 146, 138}, 0.14, 0.4, 0.07, 0.02};
    case Material::grass:
      return {0.45, {112, 122, 80}, 0.25, 0.3, 0.15, 0.06};
    case Material::foliage:
      return {0.45, {74, 108, 52}, 0.3, 0.25, 0.18, 0.06};
    case Material::cloth:
      return {0.4, {110, 104, 112}, 0.6, 0.5, 0.05, 0.35};
    case Material::car_paint:
      return {0.25, {124, 124, 130}, 0.7, 5, 0.02, 0.3};
    case Material::interior:
      return {0.5, {120, 108, 94}, 0.35, 0.6, 0.05, 0.08};
    case Material::white_target:
      break;
  }
  return {0.5, {220, 220, 220}, 0, 1, 0, 0};
}

// Tests for a bed joint: brickwork has mortar every 6.5 cm of height.
bool is_bed_joint(double z) {
  constexpr double kRow = 0.065, kJoint = 0.012;
  return z - kRow * std::floor(z / kRow) < kJoint;
}

}  // namespace

const char* name_of(Material material) {
  constexpr std::array<const char*, kMaterials> kNames{
      "limestone", "render",       "brick",      "mortar",      "slate",        "zinc",       "tile",  "glass",
      "wood",      "iron",         "asphalt",    "paving",      "grass",        "foliage",    "cloth", "car paint",
      "interior",  "white target", "dark glass", "clear glass", "mirror glass", "dusty glass"};
  return kNames[static_cast<std::size_t>(material)];
}

double reflectance(Material material) {
  return recipe_of(material).reflectance;
}

Rgb16 colour(Material material, Vec3 place) {
  if (material == Material::brick && is_bed_joint(place.z)) material = Material::mortar;
  const Recipe r = recipe_of(material);
  const auto key = static_cast<std::uint64_t>(material) * 0x9e3779b97f4a7c15ull;
  const double spot =
      0.6 * value_noise((1 / r.spot_size) * place, key) + 0.4 * value_noise((3.7 / r.spot_size) * place, key + 4);
  const double warm = value_noise((0.7 / r.spot_size) * place, key + 1);
  const double fine = value_noise(100.0 * place, key + 2);
  const double dirt = 0.05 * value_noise({place.x / 0.25, place.y / 0.25, place.z / 3}, key + 3);
  const double light = 1 + r.spots * spot + r.grain * fine + dirt;
  const std::array<double, 3> tint{1 + r.warmth * warm, 1, 1 - r.warmth * warm};
  Rgb16 rgb{};
  for (std::size_t c = 0; c < 3; ++c)
    rgb[c] = static_cast<std::uint16_t>(257 * std::clamp(r.colour[c] * light * tint[c], 0.0, 255.0));
  return rgb;
}

}  // namespace ilot::scan
