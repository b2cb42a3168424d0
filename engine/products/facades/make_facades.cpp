// SPDX-License-Identifier: Apache-2.0
#include "engine/products/facades/make_facades.h"

#include <fmt/format.h>
#include <algorithm>
#include <cmath>

#include "engine/columns/stations_pass.h"
#include "engine/pass/pass.h"
#include "engine/pass/resident.h"
#include "engine/products/facades/elements/facade_elements.h"
#include "engine/products/facades/elements/facade_model.h"
#include "engine/products/facades/elements/opening_odds.h"
#include "engine/products/facades/elements/outside_wall.h"
#include "engine/products/facades/facade_drawings.h"
#include "engine/products/facades/facade_edit_step.h"
#include "engine/products/facades/facade_gathering.h"
#include "engine/products/facades/facade_labels.h"
#include "engine/products/facades/facade_proofs.h"
#include "engine/products/facades/rays/registration_error.h"
#include "engine/products/facades/same_openings.h"
#include "engine/products/facades/screens.h"
#include "engine/products/facades/wall_pieces.h"
#include "engine/products/facades/wall_reach.h"
#include "engine/products/facades/wall_sides.h"
#include "engine/products/facades/walls/dormers.h"
#include "engine/products/facades/walls/facade_joints.h"
#include "engine/products/facades/walls/wall_groups.h"
#include "engine/report/counted.h"
#include "kernels/core/portable_math.h"

namespace ilot {
namespace {

constexpr const char* kNoRowStations =
    "facades: no input says which points are whose station's (point_source_id); it is guessed";
constexpr const char* kStationsUnrecorded =
    "facades: {} of {} points do not say which station they are from; theirs are guessed";
constexpr const char* kOutlinesDropped =
    "facades: the {} smallest planes are not held against lines of sight; occluded shares may be too small";
constexpr const char* kNoStations =
    "facades: no station is known (see --stations): laser shadows cannot be distinguished from openings by their rays";
constexpr const char* kScreens =
    "facades: {} before a wall let many rays through to it and {} not drawn: scaffolds or fences";
constexpr const char* kUndecidedSide =
    "facades: which side is the street is not certain for {} of {}, which are drawn from the likelier side; "
    "--set facades.side=[N] turns N: {}";
// Choice: odds of three to one.
constexpr double kDecided = 1.1;  // natural logarithm of the odds

std::vector<Vec3> places_of(std::span<const Station> stations) {
  std::vector<Vec3> places;
  for (const Station& s : stations) places.push_back(s.position);
  return places;
}

std::vector<FacadeStation> steps_of(std::span<const Station> stations) {
  std::vector<FacadeStation> steps;
  for (const Station& s : stations) steps.push_back({{}, s.azimuth_step, s.elevation_step});
  return steps;
}

WallParams wall_params(const FacadesSettings& s, double metres_per_unit) {
  WallParams p;
  p.least_width = s.least_width;
  p.least_height = s.least_height;
  p.least_area = s.least_width * s.least_height;
  p.bias = s.bias;
  p.gap = s.gap;
  p.relief_front = s.relief;
  p.lean_deg = s.advanced.lean;
  p.relief_behind = s.advanced.relief_behind;
  p.large_part = s.advanced.large_part;
  p.metres_per_unit = metres_per_unit;
  return p;
}

FacadeParams facade_params(const FacadesSettings& s) {
  const AdvancedFacades& a = s.advanced;
  FacadeParams p;
  p.openings = {s.least_opening,     a.least_reveal, a.shadow,     a.room_depth,
                a.room_depth_square, a.hidden_above, a.arch_misfit};
  p.relief.least_size = a.least_relief_size;
  p.relief.least_depth = a.least_relief;
  const auto [from, to] = std::minmax(a.joint_depth_from, a.joint_depth_to);
  p.stones = {from, to, a.joint_width};
  p.kinds = {a.door_height, a.door_sill, a.balcony_depth, a.balcony_width, a.balcony_height};
  p.large.most_depth = a.most_relief;
  p.irregular.psi = a.bulge;
  p.irregular.least_area = a.bulge_area;
  p.regular = {s.alike, a.line_up};
  p.regularise = s.regularise;
  return p;
}

// The number of steps of one facade that may run at once.
std::size_t concurrency_of(std::uint64_t budget_bytes) {
  constexpr std::uint64_t kOneFor = 64 << 20;
  return static_cast<std::size_t>(std::clamp<std::uint64_t>(budget_bytes / kOneFor, 1, 16));
}

DormerParams dormer_params(const FacadesSettings& s) {
  const FacadeParams facade = facade_params(s);
  return {facade.openings, facade.regular, facade.outline, facade.regularise};
}

DormerFrontParams front_params(const AdvancedFacades& a) {
  DormerFrontParams p;
  p.least_width = a.dormer_width;
  p.least_height = a.dormer_height;
  p.most_width = a.dormer_most_width;
  p.behind = a.dormer_behind;
  p.reach = a.dormer_reach;
  return p;
}

// Finds the fronts in the roof of each wall. Records in each wall how high its fronts reach.
std::vector<std::vector<WallGroup>> dormers_of(std::vector<WallGroup>& walls, std::span<const Segment> segments,
                                               const WallParams& params, const AdvancedFacades& advanced) {
  DormerFronts fronts(walls, segments, params, front_params(advanced));
  std::vector<std::vector<WallGroup>> dormers;
  for (WallGroup& wall : walls) {
    dormers.push_back(fronts.of(wall));
    for (const WallGroup& front : dormers.back()) {
      const double foot = dot(front.axes.origin - wall.axes.origin, wall.axes.up) * params.metres_per_unit;
      wall.above = std::max(wall.above, foot + front.height - wall.height);
    }
  }
  return dormers;
}

Vec3 middle_of(std::span<const Segment> segments) {
  double points = 0;
  Vec3 sum;
  for (const Segment& s : segments) {
    sum = sum + static_cast<double>(s.points) * (s.centroid - segments[0].centroid);
    points += static_cast<double>(s.points);
  }
  return segments.empty() ? Vec3{} : segments[0].centroid + (1 / points) * sum;
}

bool is_wanted(const WallGroup& wall, double unit, const PassContext& context) {
  if (!context.wanted) return true;
  const double half = 0.5 / context.metres_per_unit;
  const Vec3 middle = wall.axes.origin + (half * wall.width) * wall.axes.right + (half * wall.height) * wall.axes.up;
  return context.wanted({std::llround(middle.x / unit), std::llround(middle.y / unit), std::llround(middle.z / unit)});
}

// Writes the column "station" where it is useful and some input records it.
bool write_station_column(const Store& store, const RunInputs& inputs, const PassContext& context, Progress& progress,
                          RunRecord& record) {
  const bool any = std::any_of(inputs.row_stations.begin(), inputs.row_stations.end(), [](const InputStations& input) {
    return input.of_all != 0 || !input.of_source.empty();
  });
  if (!any) {
    record.warnings.push_back(kNoRowStations);
    return false;
  }
  const StationTally tally = stations_pass(store, inputs.readers, inputs.row_stations, context);
  if (tally.unrecorded > 0) {
    const std::string warning =
        fmt::format(kStationsUnrecorded, grouped(tally.unrecorded), grouped(tally.recorded + tally.unrecorded));
    progress.warn(warning);
    record.warnings.push_back(warning);
  }
  return tally.recorded > 0;
}

// Finds the relations of facades to each other, and to walls that are no facades, once all are known.
void join_facades(std::vector<FoundFacade>& found, std::span<const WallGroup> small, const AdvancedFacades& advanced,
                  double metres_per_unit) {
  std::vector<Facade> facades;
  for (FoundFacade& f : found) facades.push_back(std::move(f.facade));
  for (const WallGroup& wall : small) facades.push_back(bare_facade(wall, metres_per_unit));
  JointParams joints;
  joints.reach = advanced.corner_reach;
  joints.least_turn_deg = advanced.corner_angle;
  joints.most_step = advanced.storey_step;
  joints.metres_per_unit = metres_per_unit;
  close_corners(facades, joints);
  for (Facade& f : facades) cut_unseen_at_outline(f, metres_per_unit);
  add_storey_steps(facades, joints);
  for (std::size_t i = 0; i < found.size(); ++i) found[i].facade = std::move(facades[i]);
}

// Elements may reach beyond the top of a wall. The walls are extended, so that the points of these elements are read
// too.
void reach_tops(std::span<const FoundFacade> found, std::vector<WallGroup>& walls, double metres_per_unit) {
  // Choice: more than the 0.3 m around a picture; memory alone depends on it.
  constexpr double kAbove = 0.5;  // metres: a little more than pictures reach
  for (std::size_t i = 0; i < found.size(); ++i)
    for (const FacadeElement& e : found[i].facade.elements)
      for (const Vec3& p : e.ring) {
        const double top = dot(p - walls[i].axes.origin, walls[i].axes.up) * metres_per_unit;
        walls[i].above = std::max(walls[i].above, top + kAbove - walls[i].height);
      }
}

// Without stations: the log odds of the street side of each segment, from the points around the walls.
std::vector<double> odds_of_sides(const FacadesOfRun& run, std::span<const Segment> segments, const WallPieces& pieces,
                                  Vec3 middle, const WallParams& params, const PassContext& context) {
  if (!run.stations.empty()) return {};
  const std::vector<WallGroup> walls = find_walls(pieces.segments, {{}, middle, {}}, params, pieces.ends);
  return segment_side_odds(walls, wall_side_odds(run.work, walls, params.gap, context), segments);
}

// Turns the facades that the settings name, and warns of those whose side is not decided.
void settle_sides(std::vector<WallGroup>& walls, const FacadesSettings& settings, double metres_per_unit,
                  Progress& progress, RunRecord& record) {
  const auto warn = [&](const std::string& text) {
    progress.warn(text);
    record.warnings.push_back(text);
  };
  for (const int number : settings.side) {
    if (static_cast<std::size_t>(number) > walls.size()) {
      warn(fmt::format("facades.side: there is no facade {}; the run drew {}", number, walls.size()));
      continue;
    }
    WallGroup& wall = walls[static_cast<std::size_t>(number) - 1];
    turn_wall(wall, metres_per_unit);
    wall.side_odds = INFINITY;
  }
  std::size_t undecided = 0;
  std::string numbers;
  for (std::size_t i = 0; i < walls.size(); ++i) {
    if (walls[i].side_odds >= kDecided) continue;
    const double percent = 100 / (1 + natural_exp(-walls[i].side_odds));
    numbers += fmt::format("{}{} ({:.0f} %)", undecided++ > 0 ? ", " : "", i + 1, percent);
  }
  if (undecided > 0) warn(fmt::format(kUndecidedSide, undecided, counted(walls.size(), "facade"), numbers));
}

// The inputs of the search for facades.
struct FacadeSearch {
  const Settings& settings;
  const RunInputs& inputs;
  const PassContext& context;
  std::size_t concurrency;
  const FacadeObserver* observer;
};

// The memory that the rays of a facade get, which are read dozens of times: none where they need more than a quarter of
// the budget.
std::uint64_t bytes_of_rays(std::uint64_t points, std::uint64_t budget_bytes) {
  const std::uint64_t bytes = points * RaySamples::kBytesInMemory;
  return bytes <= budget_bytes / 4 ? bytes : 0;
}

RayRoom room_of_rays(const std::filesystem::path& folder, std::uint64_t points, std::uint64_t budget_bytes) {
  RayRoom room{folder};
  if (bytes_of_rays(points, budget_bytes) > 0) room.most_in_memory = std::max(room.most_in_memory, points + 1);
  return room;
}

void find_each(const FacadeSearch& search, std::span<const std::vector<WallGroup>> dormers,
               std::span<const PassTask> tasks, FacadesOfRun& run) {
  const FacadeWork& work = run.work;
  const RunInputs& inputs = search.inputs;
  FacadeParams params = facade_params(search.settings.facades);
  params.concurrency = search.concurrency;
  const DormerParams of_dormers = dormer_params(search.settings.facades);
  run_pass(tasks, search.context.budget_bytes, [&](std::size_t i) {
    GatheredFacade gathered = gather_facade(work, run.walls[i]);
    if (inputs.crs.epsg > 0) gathered.site.crs = fmt::format("EPSG:{}", inputs.crs.epsg);
    RayRoom room = room_of_rays(work.store.folder(), tasks[i].points, search.context.budget_bytes);
    const RaySamples samples(gathered.site, gathered.points, std::move(room), gathered.far);
    const bool observed = search.observer != nullptr && search.observer->facade == i + 1;
    run.found[i] = find_facade(samples, params, observed ? &search.observer->steps : nullptr,
                               sparse_findings(work, run.walls[i], params.openings));
    if (observed && search.observer->look) search.observer->look(samples);
    std::vector<DormerFront> fronts;
    for (const WallGroup& front : dormers[i]) {
      const GatheredFacade of_front = gather_facade(work, front);
      fronts.push_back(
          find_dormer(RaySamples(of_front.site, of_front.points, {work.store.folder()}, of_front.far), of_dormers));
    }
    run.found[i].occluded_edges += add_dormers(fronts, run.found[i].facade, of_dormers);
    add_registration(registration_error(samples), run.found[i].facade.elements);
    search.context.advance(tasks[i].points);
  });
}

// The openings of a facade that have a place in plan: walls that lean far have none.
void add_openings(const Facade& facade, std::vector<FacadeOpening>& openings) {
  const double level = std::sqrt(facade.out.x * facade.out.x + facade.out.y * facade.out.y);
  for (const FacadeElement& e : facade.elements) {
    if (!e.opening || e.ring.empty() || !(level > 0)) continue;
    Vec3 middle;
    for (const Vec3& p : e.ring) middle = middle + (1.0 / static_cast<double>(e.ring.size())) * p;
    openings.push_back({middle, facade.out.x / level, facade.out.y / level});
  }
}

}  // namespace

FacadesOfRun::FacadesOfRun(const Store& store, const PlanesResult& planes, const RunInputs& inputs,
                           const PassContext& context)
    : stations(places_of(inputs.stations)),
      steps(steps_of(inputs.stations)),
      work{store, planes.final_id, stations, steps, planes.outlines.outlines()} {
  work.metres_per_unit = context.metres_per_unit;
  work.outline_numbers = numbers_of(work.outlines);
}

std::unique_ptr<FacadesOfRun> find_facades(const Store& store, const PlanesResult& planes, const Settings& settings,
                                           const RunInputs& inputs, const PassContext& context, Progress& progress,
                                           RunRecord& record, const FacadeObserver* observer) {
  auto run = std::make_unique<FacadesOfRun>(store, planes, inputs, context);
  FacadeWork& work = run->work;
  const WallParams params = wall_params(settings.facades, context.metres_per_unit);
  const Vec3 middle = middle_of(planes.segments);
  if (run->stations.empty()) record.warnings.push_back(kNoStations);
  const WallPieces pieces = wall_pieces(work, planes.segments, params, context);
  const std::vector<double> odds = odds_of_sides(*run, planes.segments, pieces, middle, params, context);
  const StreetSides sides{run->stations, middle, odds};
  run->walls = find_walls(pieces.segments, sides, params, pieces.ends);
  find_sparse_parts(work, run->walls, params, context);
  work.recorded = run->stations.size() > 1 && write_station_column(store, inputs, context, progress, record);
  const auto wanted = [&](const WallGroup& wall) { return is_wanted(wall, store.unit(), context); };
  const std::vector<WallGroup> screens = take_screens(work, wanted, run->walls);
  if (!screens.empty())
    record.warnings.push_back(
        fmt::format(kScreens, counted(screens.size(), "sheet"), screens.size() == 1 ? "is" : "are"));
  std::erase_if(run->walls, [&](const WallGroup& wall) { return !wanted(wall); });
  FacadeEditStep edits(inputs.edits, run->walls, context, store.unit(), EditTally(progress, record));
  settle_sides(run->walls, settings.facades, context.metres_per_unit, progress, record);
  const std::vector<std::vector<WallGroup>> dormers =
      dormers_of(run->walls, planes.segments, params, settings.facades.advanced);
  const std::size_t concurrency = concurrency_of(context.budget_bytes);
  std::vector<PassTask> tasks;
  std::uint64_t points = 0;
  for (const WallGroup& wall : run->walls) {
    const std::uint64_t count = points_to_read(work, wall);
    const std::uint64_t bytes = facade_bytes(gather_facade(work, wall).site, count, concurrency);
    const std::uint64_t of_rays = bytes_of_rays(count, context.budget_bytes);
    tasks.push_back({bytes + bytes_of_sparse_parts(work, wall) + of_rays, count});
    points += count;
  }
  progress.begin_stage("facades", points, {run->walls.size(), run->walls.size() == 1 ? "facade" : "facades"});
  run->found.resize(run->walls.size());
  find_each({settings, inputs, context, concurrency, observer}, dormers, tasks, *run);
  for (WallGroup& wall : run->walls) include_sparse_parts(wall, context.metres_per_unit);
  drop_same_openings(run->found, context.metres_per_unit);
  if (settings.facades.regularise && !settings.facades.keep_unlikely)
    for (FoundFacade& f : run->found) f.occluded_edges -= keep_likely_openings(f.facade, context.metres_per_unit);
  edits.edit(run->found);
  std::vector<WallGroup> known = run->walls;
  known.insert(known.end(), screens.begin(), screens.end());
  join_facades(run->found, small_walls(known, pieces.segments, sides, params, pieces.ends), settings.facades.advanced,
               context.metres_per_unit);
  for (std::size_t i = 0; i < run->found.size(); ++i) run->found[i].facade.id = static_cast<std::uint32_t>(i + 1);
  if (planes.outlines.dropped() > 0)
    record.warnings.push_back(fmt::format(kOutlinesDropped, grouped(planes.outlines.dropped())));
  reach_tops(run->found, run->walls, context.metres_per_unit);
  prove_facades(work, run->walls, planes.outlines.outlines(), run->found, context);
  trim_memory();  // memory of the lines of sight; --memory counts what the allocator would keep
  return run;
}

std::vector<FacadeOpening> make_facades(const Store& store, const PlanesResult& planes, const Settings& settings,
                                        const RunInputs& inputs, const PassContext& context,
                                        const std::filesystem::path& folder, Progress& progress, RunRecord& record) {
  std::filesystem::create_directories(folder);
  const auto run = find_facades(store, planes, settings, inputs, context, progress, record);
  FacadeCounts counts;
  std::vector<FacadeOpening> openings;
  for (const FoundFacade& f : run->found) {
    ++counts.facades;
    counts.elements += f.facade.elements.size();
    counts.occluded_edges += f.occluded_edges;
    add_openings(f.facade, openings);
  }
  write_facade_labels(run->work, run->walls, run->found, context);
  if (!run->found.empty()) write_facade_drawings(*run, settings, inputs, context, folder, progress);
  record.facades = counts;
  progress.end_stage();
  return openings;
}

}  // namespace ilot
