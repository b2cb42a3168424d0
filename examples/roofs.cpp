// SPDX-License-Identifier: Apache-2.0
// The buildings of a run: attributes, faces of the highest level of detail, and volume.
// Usage: roofs RUN_FOLDER
#include <ilot/error.h>
#include <ilot/roofs.h>

#include <cstdio>

int main(int argc, char** argv) try {
  if (argc < 2) return 2;
  const std::vector<ilot::BuildingModel> buildings = ilot::read_roofs(argv[1]);
  for (const ilot::BuildingModel& building : buildings) {
    std::printf("%s: %s, up to %.2f\n", building.id.c_str(), building.text("status").value_or("").c_str(),
                building.number("h_roof_max").value_or(0));
    if (building.levels.empty()) continue;
    const ilot::Building& solid = building.levels.back();
    for (const ilot::BuildingSurface& surface : solid.surfaces) {
      if (surface.kind != ilot::SurfaceKind::roof) continue;
      const ilot::SurfaceShape shape = ilot::surface_shape(solid, surface, 1);
      std::printf("  roof face %u: %.1f m2, %.1f degrees\n", surface.plane_id, shape.area_m2, shape.slope_deg);
    }
    std::printf("  %.1f m3\n", ilot::volume_m3(solid, 1));
  }
  return buildings.empty() ? 1 : 0;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
