// SPDX-License-Identifier: Apache-2.0
#include "scan/scanners/scene_truth.h"

namespace ilot::scan {

void write_scene_truth(TruthWriter& truth, const TerrestrialScene& scene, const BeamParams& beam,
                       const PointTally& tally) {
  truth.noise({beam.range_noise, beam.angle_noise_deg, beam.divergence_mrad, beam.diameter});
  truth.classes(scene.classes);
  std::map<int, std::string> materials;
  for (const SurfaceLabel& label : scene.model.surfaces)
    materials.emplace(1 + static_cast<int>(label.material), name_of(label.material));
  truth.materials(materials);
  for (const StationParams& s : scene.stations)
    truth.add(TrueStation{s.id, s.position, s.step_horizontal_deg, s.step_vertical_deg});
  for (TruePlane plane : scene.planes) {
    plane.points = PointTally::of(tally.planes, plane.id);
    truth.add(plane);
  }
  for (TrueShape shape : scene.shapes) {
    shape.points = PointTally::of(tally.planes, shape.id);
    truth.add(shape);
  }
  for (TrueElement element : scene.elements) {
    element.points = PointTally::of(tally.elements, element.id);
    truth.add(element);
  }
  for (const TrueOpening& opening : scene.openings) truth.add(opening);
  for (const TrueControlPoint& point : scene.control_points) truth.add(point);
  for (const TrueBuilding& building : scene.buildings) truth.add(building);
}

ScanCounts scene_counts(const TerrestrialScene& scene, const PointTally& tally) {
  ScanCounts counts{{"points", tally.points}, {"planes", scene.planes.size()}};
  if (!scene.shapes.empty()) counts.emplace_back("shapes", scene.shapes.size());
  if (!scene.elements.empty()) counts.emplace_back("elements", scene.elements.size());
  for (const auto& [value, class_name] : scene.classes)
    counts.emplace_back("points of " + class_name, tally.classes[static_cast<std::size_t>(value)]);
  return counts;
}

}  // namespace ilot::scan
