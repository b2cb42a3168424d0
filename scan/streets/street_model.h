// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "scan/optics/part_scene.h"
#include "scan/streets/street_objects.h"
#include "scan/streets/street_plan.h"
#include "scan/truth_writer.h"

namespace ilot::scan {

// Values of true_class.
enum class StreetClass : std::uint8_t {
  ground = 1,
  facade = 2,
  car = 3,
  lamppost = 4,
  pedestrian = 5,
  other = 6,
  vegetation = 7,
  roof = 8
};
constexpr std::size_t kStreetClasses = static_cast<std::size_t>(StreetClass::roof) + 1;  // the last one, and none
StreetClass class_of(ArtefactClass artefact_class);
const char* name_of(StreetClass street_class);
std::map<int, std::string> street_class_names();  // all of them, by value, as truth files list them

// Returns the ASPRS class of points: 2 ground, 5 vegetation, 6 building, 1 for all else.
std::uint8_t las_class(StreetClass street_class);

// The street as the objects that rays meet, in street coordinates. true_plane numbers the planes, true_element the
// objects.
struct StreetModel {
  SceneModel scene;
  std::vector<Crown> crowns;
  std::vector<TruePlane> planes;  // street coordinates; points are not counted yet
};

StreetModel build_street_model(const Street& street, const std::vector<StreetObject>& objects);

}  // namespace ilot::scan
