// SPDX-License-Identifier: Apache-2.0
#include "engine/run/roofs_product.h"

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <memory>

#include "engine/deliverables/roof_files.h"
#include "engine/deliverables/roofs_page.h"
#include "engine/evaluate/validity.h"
#include "engine/pass/pass.h"
#include "engine/roofs/building_attributes.h"
#include "engine/run/footprint_plan.h"
#include "engine/run/roof_labels.h"
#include "engine/run/site_gathering.h"
#include "kernels/core/parallel.h"

namespace ilot {
namespace {

constexpr std::size_t kSitesTogether = 512;
constexpr std::uint64_t kPointsTogether = 1u << 21;
constexpr std::uint64_t kBytesPerPoint = 200;
constexpr double kGridMetres = 0.001;

// A building as it is written, but for the numbers that depend on those before it.
struct SiteResult {
  std::vector<Building> levels;  // the first has id and attributes
  RoofStatus status = RoofStatus::footprint_only;
  std::string reason;
  std::uint32_t planes = 0;  // plane_id of the levels and labels: 1 to this, or 0
  std::vector<LabelledPoint> labels;
  std::vector<Vec3> points;  // some of the building's, coordinates of the CRS
  double share_off = 0;      // of its points that lie on no face
};

// Roof faces numbered from 1, whatever numbers the model gave them.
std::uint32_t number_planes(RoofModel& model) {
  std::map<std::uint32_t, std::uint32_t> numbers{{0, 0}};
  for (const BuildingSurface& s : model.lod22.surfaces)
    if (s.kind == SurfaceKind::roof) numbers.emplace(s.plane_id, 0);
  std::uint32_t last = 0;
  for (auto& [given, number] : numbers)
    if (given != 0) number = ++last;
  const auto of = [&](std::uint32_t given) {
    const auto entry = numbers.find(given);
    return entry == numbers.end() ? 0 : entry->second;
  };
  for (BuildingSurface& s : model.lod22.surfaces) s.plane_id = of(s.plane_id);
  for (BuildingSurface& s : model.lod12.surfaces) s.plane_id = 0;
  for (std::uint32_t& face : model.face_of_point) face = of(face);
  return last;
}

// val3dity's tolerances are metres.
ValidityParams tolerances(double metres_per_unit) {
  ValidityParams params;
  params.snap /= metres_per_unit;
  params.plane_distance /= metres_per_unit;
  return params;
}

// The first fault as a reason; empty without one.
std::string fault_of(const Faults& faults) {
  if (faults.empty()) return {};
  return "the solid is not valid: " + std::to_string(faults[0].code) + " " + validity_code_name(faults[0].code) + ", " +
         faults[0].where;
}

class SiteModeller {
 public:
  SiteModeller(const SiteWork& work, const RoofModelParams& params, const CityJsonParams& file,
               std::span<const std::vector<std::uint32_t>> overlapping)
      : work_(work), params_(params), file_(file), overlapping_(overlapping) {}

  SiteResult model(std::size_t number) const {
    const PlannedSite& planned = work_.sites[number];
    SiteResult result;
    if (planned.outline.polygon.empty()) {
      result.reason = planned.reason;
      result.levels.emplace_back().id = planned.id;
      result.levels[0].attributes = {{"status", std::string(name_of(result.status))}, {"reason", planned.reason}};
      return result;
    }
    const GatheredSite gathered = gather_site(work_, number);
    RoofModel model;
    if (gathered.site.points.empty()) {
      model.reason = why_empty(gathered);
    } else {
      model = model_roof(gathered.site, params_, work_.metres_per_unit, [&](const Building& b) {
        return fault_of(validate_building(b, file_.origin, file_.step, tolerances(work_.metres_per_unit)));
      });
    }
    result.planes = number_planes(model);
    label_points(gathered, model, result);
    BuildingAttributes attributes = building_attributes(gathered.site, model, work_.metres_per_unit);
    tell_of_outline(number, gathered, attributes);
    result.status = model.status;
    result.reason = model.reason;
    result.levels = levels_of(gathered.site, model);
    result.levels[0].attributes = std::move(attributes);
    result.points = points_to_show(gathered.site);
    const auto off = std::count(model.face_of_point.begin(), model.face_of_point.end(), 0u);
    if (off > 0) result.share_off = static_cast<double>(off) / static_cast<double>(model.face_of_point.size());
    return result;
  }

 private:
  static std::string why_empty(const GatheredSite& gathered) {
    if (gathered.points_around == 0) return "no point of the cloud lies in its outline or around it";
    return "none of the points in its outline is a building's";
  }

  void label_points(const GatheredSite& gathered, const RoofModel& model, SiteResult& result) const {
    const std::vector<PointLabel> labels = point_labels(gathered.site, model, work_.metres_per_unit);
    for (std::size_t i = 0; i < labels.size(); ++i) {
      const std::uint32_t plane = i < model.face_of_point.size() ? model.face_of_point[i] : 0;
      result.labels.push_back({gathered.places[i].block, gathered.places[i].point, {0, plane, labels[i]}});
    }
  }

  void tell_of_outline(std::size_t number, const GatheredSite& gathered, BuildingAttributes& attributes) const {
    if (!gathered.by_class && !gathered.site.points.empty())
      attributes.emplace_back("points_of", std::string("unclassified"));
    if (!work_.sites[number].repair.empty()) attributes.emplace_back("outline", work_.sites[number].repair);
    std::string others;
    for (const std::uint32_t other : overlapping_[number])
      others += (others.empty() ? "" : ", ") + work_.sites[other].id;
    if (!others.empty()) attributes.emplace_back("overlaps", others);
  }

  std::vector<Vec3> points_to_show(const RoofSite& site) const {
    constexpr std::size_t kMost = 400;
    std::vector<Vec3> points;
    const std::size_t every = std::max<std::size_t>(1, site.points.size() / kMost);
    for (std::size_t i = 0; i < site.points.size(); i += every)
      points.push_back(site.anchor + (1 / work_.metres_per_unit) * site.points[i]);
    return points;
  }

  std::vector<Building> levels_of(const RoofSite& site, RoofModel& model) const {
    std::vector<Building> levels;
    if (!model.lod12.surfaces.empty()) levels.push_back(std::move(model.lod12)), levels.back().lod = "1.2";
    if (!model.lod22.surfaces.empty()) levels.push_back(std::move(model.lod22)), levels.back().lod = "2.2";
    if (levels.empty()) levels.push_back(flat_outline(site, work_.metres_per_unit));
    for (Building& level : levels) level.id = site.id;
    return levels;
  }

  const SiteWork& work_;
  RoofModelParams params_;
  CityJsonParams file_;
  std::span<const std::vector<std::uint32_t>> overlapping_;
};

// A corner of the CRS's own raster of 100 km, so that a part of a district is written from the same origin.
Vec3 origin_near(const Store& store, double metres_per_unit) {
  const double raster = 100000 / metres_per_unit;
  if (store.blocks().empty()) return {};
  const IndexBox& box = store.blocks().front().box;
  const auto corner = [&](std::int64_t v) {
    return std::round(static_cast<double>(v) * store.unit() / raster) * raster;
  };
  return {corner(box.min.x), corner(box.min.y), 0};
}

// Takes results in the order of ids: numbers them, writes them, counts them.
class RoofSink {
 public:
  RoofSink(const Store& store, const std::filesystem::path& folder, const CityJsonParams& params, const Crs& crs,
           Progress& progress, RunRecord& record)
      : files_(folder, {params}, crs),
        page_(folder / "roofs.html", params.metres_per_unit),
        labels_(store),
        progress_(progress),
        record_(record) {
    record.roofs.emplace();
  }

  void take(SiteResult& result, std::vector<LabelledPoint>& labels) {
    ++units_;
    for (Building& level : result.levels)
      for (BuildingSurface& s : level.surfaces) s.plane_id += s.plane_id > 0 ? planes_ : 0;
    result.levels[0].attributes.emplace_back("unit_id", std::int64_t{units_});
    files_.add(result.levels);
    page_.add(result.levels, result.points, result.share_off);
    for (LabelledPoint& p : result.labels) {
      p.label.unit = units_;
      p.label.plane += p.label.plane > 0 ? planes_ : 0;
      labels.push_back(p);
    }
    planes_ += result.planes;
    count(result);
  }
  void keep(std::vector<LabelledPoint> labels) { labels_.add(std::move(labels)); }

  const RoofLabels& finish() {
    files_.finish();
    page_.finish();
    return labels_;
  }

 private:
  void count(const SiteResult& result) {
    RoofCounts& counts = *record_.roofs;
    ++counts.buildings;
    counts.lod22 += result.status == RoofStatus::lod22;
    counts.lod12 += result.status == RoofStatus::lod12;
    counts.valid += result.status != RoofStatus::footprint_only;  // others are not delivered
    if (result.status != RoofStatus::footprint_only) return;
    ++counts.footprint_only;
    progress_.unit_skipped(result.levels[0].id, result.reason);
    record_.skipped.push_back({"unit", result.levels[0].id, result.reason});
  }

  RoofFiles files_;
  RoofsPage page_;
  RoofLabels labels_;
  Progress& progress_;
  RunRecord& record_;
  std::uint32_t units_ = 0, planes_ = 0;
};

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
    tasks[i] = {points * kBytesPerPoint, points};
  });
  return tasks;
}

RoofModelParams model_params(const RoofsSettings& s) {
  RoofModelParams params;
  params.epsilon = s.epsilon.value_or(0);
  params.min_points = s.min_points.value_or(0);
  params.least_face_area = s.least_face_area.value_or(0);
  params.superstructures = s.superstructures;
  return params;
}

// How far the outlines lie beside the points, from at most 64 of them, evenly spread.
void measure_misalignment(const SiteWork& work, std::span<const std::size_t> sites, std::span<const PassTask> costs,
                          const PassContext& context, Progress& progress, FootprintsRecord& record) {
  constexpr std::size_t kMost = 64;
  constexpr double kWorthMoving = 0.02;  // share of the points that would come to lie inside
  std::vector<std::size_t> sample;
  std::vector<PassTask> tasks;
  for (std::size_t n = 0; n < kMost; ++n) {
    const std::size_t i = n * sites.size() / kMost;
    if (i >= sites.size() || work.sites[sites[i]].outline.polygon.empty()) continue;
    if (!sample.empty() && sample.back() == sites[i]) continue;
    sample.push_back(sites[i]);
    tasks.push_back(costs[i]);
  }
  std::vector<ShiftCounts> counts(sample.size());
  run_pass(tasks, context.budget_bytes, [&](std::size_t i) { counts[i] = shifts_around(work, sample[i]); });
  ShiftCounts all;
  for (const ShiftCounts& c : counts) add(all, c);
  const Misalignment found = misalignment_of(all);
  record.shift_x_m = found.dx_m;
  record.shift_y_m = found.dy_m;
  record.inside = found.inside;
  record.inside_shifted = found.inside_moved;
  if (found.inside_moved - found.inside < kWorthMoving) return;
  char text[160];
  std::snprintf(
      text, sizeof text,
      "the footprints lie beside the points: moved by %.2f, %.2f m they would hold %.1f %% of them, not %.1f %%",
      found.dx_m, found.dy_m, 100 * found.inside_moved, 100 * found.inside);
  progress.warn(text);
}

// Consecutive sites and what became of them.
struct Batch {
  std::size_t first = 0, end = 0;
  std::vector<SiteResult> results;
};

Batch batch_from(std::size_t first, std::span<const PassTask> costs) {
  Batch batch{first, first, {}};
  for (std::uint64_t points = 0; batch.end < costs.size(); ++batch.end) {
    if (batch.end > first && (batch.end - first >= kSitesTogether || points >= kPointsTogether)) break;
    points += costs[batch.end].points;
  }
  batch.results.resize(batch.end - first);
  return batch;
}

void deliver(Batch& batch, RoofSink& sink) {
  std::vector<LabelledPoint> labels;
  for (SiteResult& result : batch.results) {
    sink.take(result, labels);
    result = {};
  }
  sink.keep(std::move(labels));
}

// Sites in the order of ids, some at a time: worked on in parallel, taken in order. While one batch is worked on, one
// thread takes the one before.
void model_sites(const SiteModeller& modeller, std::span<const std::size_t> sites, std::span<const PassTask> costs,
                 const PassContext& context, RoofSink& sink) {
  Batch before;
  while (before.end < sites.size()) {
    Batch batch = batch_from(before.end, costs);
    parallel_for(2, [&](std::size_t turn) {
      if (turn == 1) return deliver(before, sink);
      run_pass(costs.subspan(batch.first, batch.results.size()), context.budget_bytes, [&](std::size_t i) {
        batch.results[i] = modeller.model(sites[batch.first + i]);
        context.advance(costs[batch.first + i].points);
      });
    });
    before = std::move(batch);
  }
  deliver(before, sink);
}

// Points of no building: those that the cloud says are ground.
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

void make_roofs(const Store& store, std::span<const PlannedSite> sites, const Settings& settings, const Crs& crs,
                const PassContext& context, const std::filesystem::path& folder, Progress& progress,
                RunRecord& record) {
  std::vector<PlacedOutline> outlines;
  for (const PlannedSite& site : sites) outlines.push_back(site.outline);
  const OutlineMap map(outlines);
  SiteWork work{store, sites, map, {}, context.metres_per_unit};
  work.params.margin = settings.roofs.margin;
  const std::vector<std::size_t> wanted = wanted_sites(sites, store, context);
  const std::vector<PassTask> costs = costs_of(work, wanted);
  std::uint64_t points = 0;
  for (const PassTask& cost : costs) points += cost.points;
  progress.begin_stage("roofs", points);
  const auto overlapping = overlaps(sites, map);
  if (record.footprints) {
    for (const auto& others : overlapping) record.footprints->overlapping += !others.empty();
    measure_misalignment(work, wanted, costs, context, progress, *record.footprints);
  }
  std::filesystem::create_directories(folder);
  const CityJsonParams file{crs.epsg, origin_near(store, context.metres_per_unit), 0.0001,
                            settings.roofs.attribute_style, context.metres_per_unit};
  RoofSink sink(store, folder, file, crs, progress, record);
  model_sites(SiteModeller(work, model_params(settings.roofs), file, overlapping), wanted, costs, context, sink);
  sink.finish().write_columns(context, [&](std::uint32_t block) { return labels_of_others(work, context, block); });
  progress.end_stage();
}

}  // namespace ilot
