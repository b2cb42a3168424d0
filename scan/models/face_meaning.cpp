// SPDX-License-Identifier: Apache-2.0
#include "scan/models/face_meaning.h"

#include <algorithm>
#include <cctype>
#include <string>

#include "kernels/core/rng.h"

namespace ilot::scan {
namespace {

struct ClassWord {
  std::string_view word;
  FaceClass face_class;
};

// Semantic surfaces of CityJSON 2.0, and the type "Installation" of converted models.
constexpr std::array<ClassWord, 16> kSurfaceTypes{{{"WallSurface", FaceClass::facade},
                                                   {"RoofSurface", FaceClass::roof},
                                                   {"GroundSurface", FaceClass::floor},
                                                   {"OuterCeilingSurface", FaceClass::ceiling},
                                                   {"OuterFloorSurface", FaceClass::floor},
                                                   {"Window", FaceClass::window},
                                                   {"Door", FaceClass::door},
                                                   {"Installation", FaceClass::installation},
                                                   {"InteriorWallSurface", FaceClass::other},
                                                   {"CeilingSurface", FaceClass::other},
                                                   {"FloorSurface", FaceClass::other},
                                                   {"TrafficArea", FaceClass::ground},
                                                   {"AuxiliaryTrafficArea", FaceClass::ground},
                                                   {"TransportationMarking", FaceClass::ground},
                                                   {"WaterSurface", FaceClass::ground},
                                                   {"WaterGroundSurface", FaceClass::ground}}};

constexpr std::array<ClassWord, 14> kObjectTypes{{{"Road", FaceClass::ground},
                                                  {"Railway", FaceClass::ground},
                                                  {"Waterway", FaceClass::ground},
                                                  {"TransportSquare", FaceClass::ground},
                                                  {"LandUse", FaceClass::ground},
                                                  {"TINRelief", FaceClass::ground},
                                                  {"WaterBody", FaceClass::ground},
                                                  {"PlantCover", FaceClass::vegetation},
                                                  {"SolitaryVegetationObject", FaceClass::vegetation},
                                                  {"BuildingInstallation", FaceClass::installation},
                                                  {"BuildingConstructiveElement", FaceClass::installation},
                                                  {"CityFurniture", FaceClass::other},
                                                  {"BuildingFurniture", FaceClass::other},
                                                  {"GenericCityObject", FaceClass::other}}};

struct MaterialWord {
  std::string_view word;
  FaceClass face_class;
  Material material;
};

// The first word that a name contains decides, so words within other words come after them.
constexpr std::array<MaterialWord, 56> kWords{{{"window", FaceClass::window, Material::glass},
                                               {"fenster", FaceClass::window, Material::glass},
                                               {"fenetre", FaceClass::window, Material::glass},
                                               {"glass", FaceClass::window, Material::glass},
                                               {"glas", FaceClass::window, Material::glass},
                                               {"verre", FaceClass::window, Material::glass},
                                               {"vitre", FaceClass::window, Material::glass},
                                               {"pane", FaceClass::window, Material::glass},
                                               {"outdoor", FaceClass::ground, Material::paving},
                                               {"door", FaceClass::door, Material::wood},
                                               {"porte", FaceClass::door, Material::wood},
                                               {"gate", FaceClass::door, Material::wood},
                                               {"slate", FaceClass::roof, Material::slate},
                                               {"ardoise", FaceClass::roof, Material::slate},
                                               {"zinc", FaceClass::roof, Material::zinc},
                                               {"roof", FaceClass::roof, Material::tile},
                                               {"dach", FaceClass::roof, Material::tile},
                                               {"toit", FaceClass::roof, Material::tile},
                                               {"tile", FaceClass::roof, Material::tile},
                                               {"ziegel", FaceClass::roof, Material::tile},
                                               {"brick", FaceClass::facade, Material::brick},
                                               {"brique", FaceClass::facade, Material::brick},
                                               {"limestone", FaceClass::facade, Material::limestone},
                                               {"stone", FaceClass::facade, Material::limestone},
                                               {"pierre", FaceClass::facade, Material::limestone},
                                               {"plaster", FaceClass::facade, Material::render},
                                               {"render", FaceClass::facade, Material::render},
                                               {"stucco", FaceClass::facade, Material::render},
                                               {"putz", FaceClass::facade, Material::render},
                                               {"concrete", FaceClass::facade, Material::render},
                                               {"beton", FaceClass::facade, Material::render},
                                               {"wall", FaceClass::facade, Material::render},
                                               {"wand", FaceClass::facade, Material::render},
                                               {"mur", FaceClass::facade, Material::render},
                                               {"facade", FaceClass::facade, Material::render},
                                               {"fassade", FaceClass::facade, Material::render},
                                               {"asphalt", FaceClass::ground, Material::asphalt},
                                               {"road", FaceClass::ground, Material::asphalt},
                                               {"street", FaceClass::ground, Material::asphalt},
                                               {"terrain", FaceClass::ground, Material::grass},
                                               {"ground", FaceClass::ground, Material::paving},
                                               {"grass", FaceClass::ground, Material::grass},
                                               {"lawn", FaceClass::ground, Material::grass},
                                               {"paving", FaceClass::ground, Material::paving},
                                               {"pavement", FaceClass::ground, Material::paving},
                                               {"tree", FaceClass::vegetation, Material::foliage},
                                               {"leaf", FaceClass::vegetation, Material::foliage},
                                               {"leaves", FaceClass::vegetation, Material::foliage},
                                               {"foliage", FaceClass::vegetation, Material::foliage},
                                               {"railing", FaceClass::installation, Material::iron},
                                               {"balcon", FaceClass::installation, Material::render},
                                               {"gutter", FaceClass::installation, Material::zinc},
                                               {"chimney", FaceClass::installation, Material::brick},
                                               {"metal", FaceClass::installation, Material::iron},
                                               {"steel", FaceClass::installation, Material::iron},
                                               {"iron", FaceClass::installation, Material::iron}}};

std::string lower(std::string_view text) {
  std::string out(text);
  for (char& c : out) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return out;
}

std::optional<FaceMeaning> meaning_of_name(std::string_view name) {
  const std::string text = lower(name);
  for (const MaterialWord& w : kWords)
    if (text.find(w.word) != text.npos) return FaceMeaning{w.face_class, w.material, true};
  return std::nullopt;
}

template <std::size_t N>
std::optional<FaceClass> class_of_type(const std::array<ClassWord, N>& words, std::string_view type) {
  const auto found = std::find_if(words.begin(), words.end(), [&](const ClassWord& w) { return w.word == type; });
  return found == words.end() ? std::nullopt : std::optional(found->face_class);
}

}  // namespace

const char* name_of(FaceClass face_class) {
  constexpr std::array<const char*, kFaceClasses> kNames{
      "mixed", "ground", "roof", "facade", "vegetation", "window", "door", "installation", "floor", "ceiling", "other"};
  return kNames[static_cast<std::size_t>(face_class)];
}

Material usual_material(FaceClass face_class, std::uint64_t key) {
  constexpr std::array<Material, 3> kWalls{Material::render, Material::brick, Material::limestone};
  constexpr std::array<Material, 2> kRoofs{Material::tile, Material::slate};
  switch (face_class) {
    case FaceClass::facade:
    case FaceClass::ceiling:
      return kWalls[mix64(key) % kWalls.size()];
    case FaceClass::roof:
      return kRoofs[mix64(key ^ 1) % kRoofs.size()];
    case FaceClass::window:
      return Material::glass;
    case FaceClass::door:
      return Material::wood;
    case FaceClass::installation:
      return Material::iron;
    case FaceClass::vegetation:
      return Material::foliage;
    case FaceClass::ground:
    case FaceClass::floor:
      return Material::paving;
    default:
      return Material::interior;
  }
}

FaceMeaning meaning_of(const ModelSurface& surface) {
  if (surface.type == "ClosureSurface" || surface.type == "WaterClosureSurface") {
    FaceMeaning closure;
    closure.absent = true;
    return closure;
  }
  const auto of = [](FaceClass c) { return FaceMeaning{c, usual_material(c, 0), true}; };
  const std::optional<FaceClass> of_object = class_of_type(kObjectTypes, surface.object_type);
  if (const auto type = class_of_type(kSurfaceTypes, surface.type)) {
    // The walls of a balcony belong to the balcony; openings stay openings.
    const bool opening = *type == FaceClass::window || *type == FaceClass::door;
    return of(of_object == FaceClass::installation && !opening ? FaceClass::installation : *type);
  }
  if (of_object) return of(*of_object);
  if (const auto named = meaning_of_name(surface.material)) return *named;
  if (const auto named = meaning_of_name(surface.id)) return *named;
  return {};
}

}  // namespace ilot::scan
