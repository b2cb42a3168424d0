// SPDX-License-Identifier: Apache-2.0
// A model that somebody made (CityJSON, OBJ), brought into the metres of a scene.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "kernels/geometry/box3.h"
#include "kernels/geometry/closest.h"
#include "scan/models/face_meaning.h"
#include "scan/scanners/scan_record.h"

namespace ilot::scan {

// How a file is to be read, where it does not say so itself.
struct ModelInput {
  std::filesystem::path path;
  std::string lod;        // of CityJSON: "2" takes 2, 2.0, 2.1 ...; empty = the highest of each object
  std::string crs;        // of the coordinates: "EPSG:25832"; empty = as the file says
  std::string unit;       // of the coordinates: m, ft, us-ft, cm, mm; empty = as the CRS says, or metres
  bool y_up = false;      // of OBJ: y points up, as in files of many modellers
  bool closures = false;  // closure surfaces are walls; otherwise nothing is built there
};

// One polygon of the model.
struct ScannedFace {
  std::vector<std::vector<Vec3>> rings;  // outer ring first, metres in the scene
  std::vector<Triangle3> triangles;      // those without area are left out; never empty
  Vec3 normal;                           // unit length, as the ring turns; may point inwards
  double area = 0;                       // square metres
  FaceClass face_class = FaceClass::other;
  Material material = Material::render;
  std::uint32_t building = 0;  // from 1; 0 = terrain and other things that are no building
  std::uint32_t surface = 0;   // index into ScannedModel::surfaces
};

struct ScannedSurface {
  FaceClass face_class = FaceClass::other;
  bool semantic = false;                // the file names its type; all its faces are one thing
  std::optional<std::uint32_t> parent;  // the surface that contains it
};

struct ScannedModel {
  ScenePlace place;
  std::vector<std::string> buildings;  // names; building b is at [b - 1]
  std::vector<ScannedFace> faces;
  std::vector<ScannedSurface> surfaces;
  Box3<Vec3> box = Box3<Vec3>::none();  // of the faces
  std::vector<std::string> notes;       // what was assumed or left out, for people
};

// Throws Error with one line for a file that cannot be read, for coordinates in degrees, and for a model that is empty,
// smaller than 10 cm or larger than 4 km.
ScannedModel read_scanned_model(const ModelInput& input);

}  // namespace ilot::scan
