// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/cut_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "engine/error.h"
#include "engine/products/planes/cells/cells.h"
#include "engine/products/roofs/make_roofs.h"
#include "engine/products/roofs/roof_roles.h"
#include "engine/report/counted.h"
#include "engine/scale/area_key.h"
#include "engine/scale/chunk_boxes.h"
#include "engine/scale/parts/cell_part.h"
#include "engine/scale/plan_areas.h"
#include "engine/scale/plan_products.h"
#include "engine/scale/plan_sites.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostAreas = 100'000;  // Choice: plan.json has some 400 bytes for each
constexpr std::uint64_t kLeastMemory = 96u << 20;
// Choice: a house of two levels; the estimate of disk follows from it, no result does.
constexpr std::uint64_t kPartBytesOfSite = 2000;

// What a task of this area will need. Memory: what a run of few threads needs, and the sites of the area.
void estimate_area(const PointSurvey& survey, std::uint64_t neighbours, const Plan& plan, PlanArea& area) {
  constexpr std::uint64_t kBytesOfSiteInMemory = 2000;  // Choice: an outline of some ten corners, its record and map
  area.points = survey.map.in(area.read);
  std::uint64_t rows = 0;
  for (std::uint32_t i = 0; i < plan.inputs.size(); ++i) {
    const std::uint64_t before = rows;
    for (const RowRange& range : rows_that_meet(survey.chunks[i], area.read)) rows += range.end - range.first;
    if (rows == before) continue;
    area.inputs.push_back(i);
    const double share = static_cast<double>(rows - before) / static_cast<double>(plan.inputs[i].record.points);
    area.input_bytes += static_cast<std::uint64_t>(share * static_cast<double>(plan.inputs[i].record.bytes));
  }
  constexpr double kMicroseconds = 1e-6, kReading = 0.5;  // as in run_estimate.cpp, for each row that is decoded
  area.processor_seconds = kMicroseconds * (static_cast<double>(rows) * kReading +
                                            static_cast<double>(area.points) * microseconds_of_point(plan));
  area.memory_bytes = kLeastMemory + (area.sites + neighbours) * kBytesOfSiteInMemory;
  area.part_bytes = area.sites * kPartBytesOfSite + survey.map.in(area.own) * part_bytes_of_point(plan, area);
}

void check_count(std::size_t areas) {
  if (areas <= kMostAreas) return;
  throw Error("--area-size: gives " + grouped(areas) + " areas, at most " + grouped(kMostAreas) +
                  " are possible; give a larger one",
              ExitCode::usage);
}

// What is read around outlines and around cells.
struct Halos {
  double outlines = 0;     // metres
  std::int64_t cells = 0;  // lattice steps
  double larger = 0;       // metres
  std::string why;
};

Halos halos_of(const Plan& plan, const SitePointsParams& points, double step) {
  Halos halos;
  if (makes_roofs(plan)) {
    const double roles = plan.roofs.by_shape ? reach_of_found_roles(plan.settings) : 0;
    halos.outlines = farthest_points(points) + roles;
    halos.why = fmt::format("ground is searched up to {:.0f} m around an outline", farthest_points(points));
    if (roles > 0)
      halos.why +=
          fmt::format("; what is ground and building is found by shape, from points up to {:.1f} m away", roles);
  }
  if (carries_points(plan)) {
    halos.cells = halo_of_cells(plan, step);
    if (!makes_roofs(plan))
      halos.why = searches_planes(plan) ? "margins of cells, and the neighbours from which normals in them follow"
                                        : "points alone are read and sorted";
  }
  halos.larger = std::max(halos.outlines, static_cast<double>(halos.cells) * step);
  return halos;
}

}  // namespace

void cut_plan(const PlanOptions& options, double step, const PointSurvey& survey, std::span<const PlannedSite> sites,
              Plan& plan) {
  SitePointsParams points;
  points.margin = plan.settings.roofs.margin;
  const Halos halos = halos_of(plan, points, step);
  plan.halo = halos.larger;
  plan.halo_why = halos.why;
  plan.area_size = options.area_size > 0 ? options.area_size : suitable_area_size(survey.map, step, plan.halo);
  std::vector<PlanArea> cells;
  if (carries_points(plan)) {  // the number of cells whose side is nearest to the one that is asked for
    const std::int64_t edge = largest_cell(step);
    const double cell = static_cast<double>(edge) * step;
    const std::int64_t side = std::max<std::int64_t>(1, std::llround(plan.area_size / cell));
    plan.area_size = static_cast<double>(side) * cell;
    cells = cut_cell_areas(survey.map, {edge, side, halos.cells});
  }
  const std::vector<AreaSites> areas =
      cut_areas(sites, std::move(cells), step, {plan.area_size, halos.outlines, reach_of(points)});
  check_count(areas.size());
  SiteMarks marks{plan.roofs.extent, {}};
  if (plan.roofs.footprints) marks.sampled = sample_of_sites(sites.size());
  const fs::path folder = options.run.output / kSitesFolder;
  fs::remove_all(folder);
  if (makes_roofs(plan)) fs::create_directories(folder);
  for (const AreaSites& a : areas) {
    PlanArea& area = plan.areas.emplace_back(a.area);
    estimate_area(survey, a.neighbours.size(), plan, area);
    std::string decides;
    if (makes_roofs(plan)) decides = write_sites(folder / std::to_string(plan.areas.size()), a, sites, marks, area);
    area.key = area_key(plan, area, decides);
  }
}

}  // namespace ilot
