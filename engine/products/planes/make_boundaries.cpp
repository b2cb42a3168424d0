// SPDX-License-Identifier: Apache-2.0
#include "engine/products/planes/make_boundaries.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

#include "engine/deliverables/layers/density_files.h"
#include "engine/deliverables/layers/planes_gpkg.h"
#include "engine/model/outline_area.h"
#include "engine/products/planes/boundaries/density_pass.h"

namespace ilot {
namespace {

constexpr int kMapsByDefault = 4;

void record_step(const BoundariesSettings& settings, std::size_t scanners, std::size_t stations, RunRecord& record) {
  if (settings.step || settings.threshold) return;
  const std::string why = scanners > 0   ? "the angular steps of " + std::to_string(scanners) + " stations are known"
                          : stations > 0 ? "stations are known, but not their angular steps: see --stations"
                                         : "no station is known: see --stations";
  record.chosen.push_back({"boundaries.step", std::string(scanners > 0 ? "stations" : "neighbours"), why});
}

// Ids of the planes with the most points (ties: the smaller id), as many as are asked for.
std::vector<std::uint32_t> largest_planes(const std::vector<Segment>& segments, std::size_t count) {
  std::vector<std::uint32_t> ids;
  for (const Segment& s : segments) ids.push_back(s.id);
  std::sort(ids.begin(), ids.end(), [&](std::uint32_t a, std::uint32_t b) {
    const std::uint64_t pa = segments[a - 1].points, pb = segments[b - 1].points;
    return pa != pb ? pa > pb : a < b;
  });
  ids.resize(std::min(ids.size(), count));
  return ids;
}

void make_density_maps(const Store& store, const PlanesResult& planes, const std::map<std::uint32_t, Outline>& outlines,
                       std::span<const Scanner> scanners, const PassContext& context,
                       const std::filesystem::path& folder) {
  std::vector<DensityRequest> requests;
  for (const auto& [id, outline] : outlines) {
    const double area = area_of(outline);
    if (area > 0) requests.push_back({outline, planes.segments[id - 1].points, area});
  }
  if (requests.empty()) return;
  DensityFiles files(folder / "density", context.metres_per_unit);
  density_pass(store, {planes.planes, planes.final_id, scanners}, requests, context,
               [&](const DensityMap& map) { files.add(map); });
  files.finish();
}

}  // namespace

std::vector<Scanner> scanners_of(const std::vector<Station>& stations, double unit) {
  std::vector<Scanner> scanners;
  for (const Station& s : stations)
    if (s.azimuth_step > 0 && s.elevation_step > 0)
      scanners.push_back({(1 / unit) * s.position, s.axis, s.azimuth_step, s.elevation_step});
  return scanners;
}

void make_boundaries(const Store& store, PlanesResult& planes, const Settings& settings, const RunInputs& inputs,
                     const PassContext& context, const std::filesystem::path& folder, RunRecord& record) {
  const BoundariesSettings& s = settings.boundaries;
  const double metre = 1 / (store.unit() * context.metres_per_unit);
  std::vector<Scanner> scanners = scanners_of(inputs.stations, store.unit());
  record_step(s, scanners.size(), inputs.stations.size(), record);
  const std::vector<Scanner> all_scanners = scanners;  // the maps are compared with them, whatever the outlines use
  const auto maps = static_cast<std::size_t>(s.density_maps.value_or(all_scanners.empty() ? 0 : kMapsByDefault));
  std::map<std::uint32_t, Outline> mapped;  // outlines of the planes whose density is asked for
  for (const std::uint32_t id : largest_planes(planes.segments, maps)) mapped[id];
  if (s.step == StepSource::neighbours) scanners.clear();
  BoundaryParams params{s.gamma, s.tolerance * metre, planes.planes, planes.final_id, planes.ranges, scanners};
  params.threshold = s.threshold.value_or(0) * metre;
  params.rule = s.rule == BoundaryRule::circumradius ? TriangleRule::kCircumradius : TriangleRule::kLongestEdge;
  params.edge_length = s.edge_length;
  params.erosion = s.erosion;
  std::filesystem::create_directories(folder);
  PlanesGpkg file(folder / "planes.gpkg", inputs.crs);
  boundaries_pass(store, params, context, [&](Outline outline) {
    Segment& segment = planes.segments[outline.plane_id - 1];
    segment.area_m2 = area_of(outline) * context.metres_per_unit * context.metres_per_unit;
    planes.outlines.add(outline, segment.area_m2);
    if (const auto asked = mapped.find(outline.plane_id); asked != mapped.end()) asked->second = outline;
    file.add(segment, std::move(outline));
  });
  file.finish();
  make_density_maps(store, planes, mapped, all_scanners, context, folder);
}

}  // namespace ilot
