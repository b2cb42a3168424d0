// SPDX-License-Identifier: Apache-2.0
#include "engine/products/roofs/make_roofs.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>

#include "engine/error.h"
#include "engine/pass/pass.h"
#include "engine/products/product_edits.h"
#include "engine/products/roofs/footprint_plan.h"
#include "engine/products/roofs/roof_sink.h"
#include "engine/products/roofs/solids/storeys.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr std::size_t kFewestTogether = 64, kMostTogether = 512;  // sites between two deliveries
constexpr std::uint64_t kBytesOfResult = 40u << 10;               // of a site: its model and the points to show

std::vector<std::size_t> wanted_sites(std::span<const PlannedSite> sites, const Store& store,
                                      const PassContext& context) {
  std::vector<std::size_t> wanted;
  const double per_unit = kGridMetres / (store.unit() * context.metres_per_unit);
  for (std::size_t i = 0; i < sites.size(); ++i) {
    const PlacedOutline& o = sites[i].outline;
    if (context.wanted) {
      if (o.polygon.empty()) continue;
      const Point2 first = o.polygon[0][0];
      const auto on_lattice = [&](std::int64_t mm) { return std::llround(static_cast<double>(mm) * per_unit); };
      if (!context.wanted({on_lattice(o.x + first.x), on_lattice(o.y + first.y), 0})) continue;
    }
    wanted.push_back(i);
  }
  return wanted;
}

std::vector<PassTask> costs_of(const SiteWork& work, std::span<const std::size_t> sites) {
  std::vector<PassTask> tasks(sites.size());
  parallel_for(sites.size(), [&](std::size_t i) {
    const std::uint64_t points = points_to_read(work, sites[i]);
    tasks[i] = {kBytesOfSite + std::min<std::uint64_t>(points, work.most_points) * kBytesOfSitePoint, points};
  });
  return tasks;
}

// The memory of all data that stay for every site: outlines, their map, costs and the positions of labels.
std::uint64_t bytes_of_tables(std::span<const PlannedSite> sites) {
  constexpr std::uint64_t kBytesOfSiteRow = sizeof(PlannedSite) + 200;
  std::uint64_t bytes = sites.size() * kBytesOfSiteRow;
  for (const PlannedSite& site : sites) {
    for (const auto& [name, value] : site.attributes) {
      const auto* text = std::get_if<std::string>(&value);
      bytes += 2 * sizeof site.attributes[0] + name.size() + (text == nullptr ? 0 : text->size());
    }
    for (const auto& ring : site.outline.polygon)
      bytes += sizeof(site.outline.polygon[0]) + ring.size() * sizeof(Point2);
  }
  return bytes;
}

// The memory that sites in work may take beside the tables and two batches of results.
struct RoofBudget {
  std::uint64_t tasks = 0;
  std::size_t together = kFewestTogether;

  RoofBudget(std::uint64_t all, std::span<const PlannedSite> sites, std::span<const PassTask> costs) {
    const std::uint64_t tables = bytes_of_tables(sites);
    const auto spare = all > tables ? all - tables : 0;
    together = std::clamp<std::size_t>(spare / 16 / kBytesOfResult, kFewestTogether, kMostTogether);
    const std::uint64_t results = 2 * std::min(together, costs.size()) * kBytesOfResult;
    tasks = spare > results ? spare - results : 0;
    std::uint64_t largest = 0;
    for (const PassTask& cost : costs) largest = std::max(largest, cost.bytes);
    if (largest <= tasks) return;
    throw Error("roofs: " + std::to_string(sites.size()) + " buildings, the largest with " +
                    std::to_string((largest - kBytesOfSite) / kBytesOfSitePoint) +
                    " points in its model, need --memory " + std::to_string(((largest - tasks) >> 20) + 1) +
                    "M more than was given",
                ExitCode::usage);
  }
};

// Counts the points inside shifted outlines of the numbers of `sites` in the sample.
ShiftCounts count_all_shifts(const SiteWork& work, std::span<const std::size_t> sites,
                             std::span<const std::size_t> sample, std::span<const PassTask> costs,
                             const RoofBudget& budget) {
  std::vector<std::size_t> counted;
  std::vector<PassTask> tasks;
  for (const std::size_t i : sample) {
    if (work.sites[sites[i]].outline.polygon.empty()) continue;
    counted.push_back(sites[i]);
    tasks.push_back(costs[i]);
  }
  std::vector<ShiftCounts> counts(counted.size());
  run_pass(tasks, budget.tasks, [&](std::size_t i) { counts[i] = shifts_around(work, counted[i]); });
  ShiftCounts all;
  for (const ShiftCounts& c : counts) add(all, c);
  return all;
}

}  // namespace

std::vector<std::size_t> sample_of_sites(std::size_t sites) {
  constexpr std::size_t kMost = 64;
  std::vector<std::size_t> sample;
  for (std::size_t n = 0; n < kMost; ++n)
    if (const std::size_t i = n * sites / kMost; i < sites && (sample.empty() || sample.back() != i))
      sample.push_back(i);
  return sample;
}

void record_misalignment(const ShiftCounts& counts, Progress& progress, RunRecord& record_of_run) {
  // Choice: 2 % of the points; smaller moves are within the noise of the outline.
  constexpr double kWorthMoving = 0.02;  // least share of the points that a move would bring inside
  FootprintsRecord& record = *record_of_run.footprints;
  const Misalignment found = misalignment_of(counts);
  record.shift_x_m = found.dx_m;
  record.shift_y_m = found.dy_m;
  record.inside = found.inside;
  record.inside_shifted = found.inside_moved;
  if (found.inside_moved - found.inside < kWorthMoving) return;
  char text[160];
  std::snprintf(
      text, sizeof text,
      "the footprints lie beside the points: moved by %.2f, %.2f m they would contain %.1f %% of them, not %.1f %%",
      found.dx_m, found.dy_m, 100 * found.inside_moved, 100 * found.inside);
  progress.warn(text);
}

namespace {

// Consecutive sites and their results.
struct Batch {
  std::size_t first = 0, end = 0;
  std::vector<SiteResult> results;
};

Batch batch_from(std::size_t first, std::size_t sites, std::size_t together) {
  Batch batch{first, std::min(sites, first + together), {}};
  batch.results.resize(batch.end - first);
  return batch;
}

void deliver(Batch& batch, const TakeSite& take) {
  for (std::size_t i = 0; i < batch.results.size(); ++i) {
    take(batch.first + i, batch.results[i]);
    batch.results[i] = {};
  }
}

// Models the sites in batches in the order of ids. The sites of a batch are processed in parallel, and their results
// are taken in order. While one batch is processed, one thread takes the results of the batch before.
void model_sites(const SiteModeller& modeller, std::span<const std::size_t> sites, std::span<const PassTask> costs,
                 const RoofBudget& budget, const PassContext& context, const TakeSite& take) {
  Batch before;
  while (before.end < sites.size()) {
    Batch batch = batch_from(before.end, sites.size(), budget.together);
    const auto costs_here = costs.subspan(batch.first, batch.results.size());
    std::vector<PassTask> tasks(costs_here.begin(), costs_here.end());
    tasks.push_back({0, std::numeric_limits<std::uint64_t>::max()});  // the delivery, which starts first
    run_pass(tasks, budget.tasks, [&](std::size_t i) {
      if (i == batch.results.size()) return deliver(before, take);
      batch.results[i] = modeller.model(sites[batch.first + i]);
      context.advance(costs_here[i].points);
    });
    before = std::move(batch);
  }
  deliver(before, take);
}

// The labels of points of no building: those that the cloud classifies as ground are labelled ground.
std::vector<PointLabel> labels_of_others(const SiteWork& work, const PassContext& context, std::uint32_t block) {
  const auto roles = work.store.read(block, columns::kRole);
  const auto codes = context.wanted ? work.store.read(block, columns::kCodes) : std::vector<std::uint64_t>{};
  std::vector<PointLabel> labels(roles.size(), PointLabel::none);
  const Tile tile = work.store.blocks()[block].node.tile;
  for (std::size_t i = 0; i < roles.size(); ++i) {
    if (roles[i] != PointRole::ground) continue;
    if (!context.wanted || context.wanted(index_of({tile, codes[i]}))) labels[i] = PointLabel::ground;
  }
  return labels;
}

}  // namespace

std::vector<OverlapRecord> overlaps_of(std::span<const PlannedSite> sites, const OutlineMap& map) {
  std::vector<std::vector<std::uint32_t>> others(sites.size());
  parallel_for(sites.size(), [&](std::size_t i) { others[i] = overlapping(sites, map, i); });
  std::vector<OverlapRecord> overlaps;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    if (others[i].empty()) continue;
    OverlapRecord& record = overlaps.emplace_back();
    record.id = sites[i].id;
    for (const std::uint32_t other : others[i]) record.with.push_back(sites[other].id);
  }
  return overlaps;
}

ShiftCounts model_buildings(const RoofSetup& setup, std::span<const std::size_t> sites,
                            std::span<const std::size_t> sample, const PassContext& context, Progress& progress,
                            RoofLabels& labels, const TakeSite& take) {
  const SiteWork& work = setup.work;
  const std::vector<PassTask> costs = costs_of(work, sites);
  const RoofBudget budget(context.budget_bytes, work.sites, costs);
  std::uint64_t points = 0;
  for (const PassTask& cost : costs) points += cost.points;
  progress.begin_stage("roofs", points, {sites.size(), sites.size() == 1 ? "building" : "buildings"});
  const ShiftCounts shifts = count_all_shifts(work, sites, sample, costs, budget);
  const SiteModeller modeller(work, setup.model, setup.file.city_json, labels);
  model_sites(modeller, sites, costs, budget, context, take);
  return shifts;
}

namespace {

// Tells what became of the edits that merge faces, in their order. Those of sites that were not modelled are outside of
// the part of the cloud that is asked for.
void tally_merges(const RoofSetup& setup, const PassContext& context,
                  const std::vector<std::vector<EditResult>>& by_site, EditTally tally) {
  std::map<std::size_t, std::size_t> counted;  // edits of each site
  for (const PlannedMerge& merge : setup.merges) {
    if (!merge.site) {
      if (lies_outside(*merge.edit, context, setup.work.store.unit()))
        tally.outside();
      else
        tally.without_partner(*merge.edit, merge.reason);
      continue;
    }
    const std::vector<EditResult>& results = by_site[*merge.site];
    const std::size_t number = counted[*merge.site]++;
    if (number >= results.size())
      tally.outside();
    else
      tally.add(*merge.edit, results[number]);
  }
}

}  // namespace

void make_roofs(const Store& store, std::span<const PlannedSite> sites, std::span<const FacadeOpening> openings,
                const Settings& settings, const RunInputs& inputs, const PassContext& context,
                const ProductOutput& out) {
  const Crs& crs = inputs.crs;
  const RoofSetup setup(store, sites, settings, crs, context, inputs.edits);
  const std::vector<std::size_t> wanted = wanted_sites(sites, store, context);
  const bool given = out.record.footprints.has_value();
  if (given) out.record.footprints->overlaps = overlaps_of(sites, setup.map);
  std::filesystem::create_directories(out.folder);
  RoofLabels labels(store);
  RoofSink sink(out.folder, setup.file, crs, &labels, out.record);
  const StoreyCounter counter(openings, context.metres_per_unit);
  std::vector<std::vector<EditResult>> merges(setup.merges.empty() ? 0 : sites.size());
  const ShiftCounts shifts =
      model_buildings(setup, wanted, given ? sample_of_sites(wanted.size()) : std::vector<std::size_t>{}, context,
                      out.progress, labels, [&](std::size_t place, SiteResult& result) {
                        if (!merges.empty()) merges[wanted[place]] = result.merges;
                        counter.add_to(result.levels[0].attributes, sites[wanted[place]].outline);
                        sink.take(result);
                      });
  tally_merges(setup, context, merges, {out.progress, out.record});
  if (given) record_misalignment(shifts, out.progress, out.record);
  sink.finish();
  labels.write_columns(context, [&](std::uint32_t block) { return labels_of_others(setup.work, context, block); });
  out.progress.end_stage();
}

}  // namespace ilot
