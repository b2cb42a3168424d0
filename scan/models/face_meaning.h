// SPDX-License-Identifier: Apache-2.0
// What a face of a model is and what it is made of, as far as the file says it.
#pragma once
#include <array>
#include <cstdint>
#include <optional>
#include <string_view>

#include "engine/model/polygon_model.h"
#include "scan/optics/material.h"

namespace ilot::scan {

// The values of true_class of scanned models; 0 is a point between two surfaces. Ground and roof have the same values
// as in the scenes seen from the air.
enum class FaceClass : std::uint8_t {
  mixed = 0,
  ground = 1,
  roof = 2,
  facade = 3,
  vegetation = 4,
  window = 5,
  door = 6,
  installation = 7,  // balconies, chimneys, gutters, railings
  floor = 8,         // terraces and the undersides of buildings
  ceiling = 9,       // soffits
  other = 10         // also what is seen through a pane or mirrored by it
};
constexpr std::size_t kFaceClasses = 11;

// The name in the truth.
const char* name_of(FaceClass face_class);

struct FaceMeaning {
  FaceClass face_class = FaceClass::other;
  Material material = Material::render;
  bool known = false;   // false: the file says nothing, and only the geometry can tell
  bool absent = false;  // a closure surface: it closes a space, and nothing is built there
};

// Reads the type of the surface and of its object (CityJSON), then the name of the material, then that of the group
// (OBJ). Names are searched for words in English, German and French: "Glas_02" is a window.
FaceMeaning meaning_of(const ModelSurface& surface);

// The material of a class when nothing names one. Walls of different buildings differ: `key` chooses.
Material usual_material(FaceClass face_class, std::uint64_t key);

}  // namespace ilot::scan
