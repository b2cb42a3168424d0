// SPDX-License-Identifier: Apache-2.0
// A model as a scene: the triangles that rays meet, their labels, and the truth about walls, roofs, windows and doors.
#pragma once
#include <cstdint>
#include <vector>

#include "scan/models/model_input.h"
#include "scan/optics/part_scene.h"
#include "scan/truth_writer.h"

namespace ilot::scan {

struct ModelStage {
  SceneModel scene;
  ScenePlace place;
  Box3<Vec3> box;       // of the model, without the ground around it
  double ground_z = 0;  // of the flat ground
  std::vector<TruePlane> planes;
  std::vector<TrueElement> elements;
  std::vector<TrueOpening> openings;
  std::vector<Vec3> opening_normals;  // outward, one for each opening
  std::vector<TrueBuilding> buildings;
  std::vector<std::vector<Vec3>> footprints;  // convex, counter-clockwise, one for each building
};

// Faces of one class and element that touch and lie within 1 cm and 1 degree of one plane share a true plane. Pieces of
// less than 500 cm2 have none. Windows, doors and installations are elements, one for each semantic surface, or for
// each connected piece where a file has no semantics. An opening is the outline of all faces of a window or door,
// projected on the plane of the wall that contains it. `ground` metres of flat ground are added around the model at its
// lowest point; with 0, and for models with terrain of their own, there is none. Takes the faces out of the model.
ModelStage make_stage(ScannedModel&& model, double ground);

}  // namespace ilot::scan
