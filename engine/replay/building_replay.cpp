// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/building_replay.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>

#include "engine/deliverables/solids/model_file.h"
#include "engine/error.h"
#include "engine/products/roofs/cluster_plan.h"
#include "engine/products/roofs/footprint_plan.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr std::size_t kMostAround = 1u << 19;  // points that are shown

std::vector<PlannedSite> planned_sites(const KeptRun& run, Progress& progress) {
  RunRecord record;
  Progress silent;  // the run has reported everything
  if (!run.options().footprints.empty())
    return plan_footprints(run.options().footprints, run.options().id_field, run.inputs().crs, silent, record);
  return plan_clusters(run.store(), run.options().settings.roofs, run.context(), progress, record);
}

// Returns the id with the longest common beginning.
std::string nearest_id(std::span<const PlannedSite> sites, const std::string& id) {
  const auto common = [&](const std::string& other) {
    return std::mismatch(id.begin(), id.end(), other.begin(), other.end()).first - id.begin();
  };
  const auto best = std::max_element(sites.begin(), sites.end(), [&](const PlannedSite& a, const PlannedSite& b) {
    return common(a.id) < common(b.id);
  });
  return best->id;
}

std::size_t number_of(std::span<const PlannedSite> sites, const std::string& id) {
  const auto found = std::find_if(sites.begin(), sites.end(), [&](const PlannedSite& s) { return s.id == id; });
  if (found != sites.end()) return static_cast<std::size_t>(found - sites.begin());
  if (sites.empty()) throw Error("building:" + id + ": the run had no building", ExitCode::usage);
  throw Error("building:" + id + ": the run had no such building; the nearest of its " + grouped(sites.size()) +
                  " is building:" + nearest_id(sites, id) + " (ilot replay OUT --list)",
              ExitCode::usage);
}

const PolygonModel* model_named(const ModelFile& file, const std::string& name) {
  const auto found =
      std::find_if(file.models.begin(), file.models.end(), [&](const PolygonModel& m) { return m.name == name; });
  return found == file.models.end() ? nullptr : &*found;
}

bool same_faces(const PolygonModel& a, const PolygonModel& b) {
  const auto same_place = [](Vec3 p, Vec3 q) { return p.x == q.x && p.y == q.y && p.z == q.z; };
  const auto same_face = [](const PolygonFace& f, const PolygonFace& g) {
    return f.rings == g.rings && f.kind == g.kind && f.shell == g.shell;
  };
  return std::equal(a.vertices.begin(), a.vertices.end(), b.vertices.begin(), b.vertices.end(), same_place) &&
         std::equal(a.faces.begin(), a.faces.end(), b.faces.begin(), b.faces.end(), same_face);
}

// Returns the labels in the store for the points from which the building's model was made.
std::vector<RoofLabel> labels_in_store(const BuildingReplay& building, const Store& store) {
  const auto& places = building.steps.gathered.places;
  std::vector<RoofLabel> labels, of_block;
  for (std::size_t i = 0; i < places.size(); ++i) {
    if (i == 0 || places[i].block != places[i - 1].block) of_block = store.read(places[i].block, columns::kRoof);
    labels.push_back(of_block[places[i].point]);
  }
  return labels;
}

// Counts points that have another face in the column "roof". The run numbered planes continuously from building to
// building, and a point in two outlines belongs to another building there.
std::uint64_t points_of_other_faces(const BuildingReplay& building, const Store& store) {
  const std::vector<RoofLabel> labels = labels_in_store(building, store);
  std::map<std::uint32_t, std::uint64_t> units;
  for (const RoofLabel& label : labels) ++units[label.unit];
  const auto most =
      std::max_element(units.begin(), units.end(), [](const auto& a, const auto& b) { return a.second < b.second; });
  const auto& faces = building.steps.face_of_point;
  std::uint64_t others = 0;
  std::optional<std::uint32_t> before;  // planes of the buildings before
  for (std::size_t i = 0; i < std::min(labels.size(), faces.size()); ++i) {
    if (labels[i].unit != most->first) continue;
    const std::uint32_t written = labels[i].plane;
    if (!before && written > 0 && faces[i] > 0) before = written - faces[i];
    others += written != (faces[i] > 0 ? faces[i] + before.value_or(0) : 0);
  }
  return others;
}

}  // namespace

BuildingReplay replay_building(const KeptRun& run, const std::string& id, Progress& progress) {
  if (!run.made("roofs"))
    throw Error("building:" + id + ": the run made no buildings (--products roofs)", ExitCode::usage);
  const std::vector<PlannedSite> sites = planned_sites(run, progress);
  const std::size_t number = number_of(sites, id);
  const RoofSetup setup(run.store(), sites, run.options().settings, run.inputs().crs, run.context(),
                        run.inputs().edits);
  RoofLabels labels(run.store());
  BuildingReplay building;
  building.planned = sites[number];
  building.file = setup.file.city_json;
  building.result = SiteModeller(setup.work, setup.model, setup.file.city_json, labels).model(number, &building.steps);
  if (building.planned.outline.polygon.empty()) return building;
  const auto reach = static_cast<std::int64_t>(1000 * reach_of(setup.work.params)) + 1;
  for (const std::uint32_t other : setup.map.near(building.planned.outline.box.grown(reach)))
    if (other != number) building.around.push_back(sites[other]);
  building.points = SiteReader(setup.work, number).points_around(kMostAround);
  return building;
}

std::vector<std::string> differences_of(const BuildingReplay& building, const KeptRun& run, const fs::path& model) {
  std::vector<std::string> differences;
  const ModelFile written = read_models(run.options().output / "roofs" / "roofs.city.jsonl"), now = read_models(model);
  const PolygonModel *a = model_named(written, building.planned.id), *b = model_named(now, building.planned.id);
  if (a == nullptr && b != nullptr) differences.push_back("the run did not write this building");
  if (a != nullptr && (b == nullptr || !same_faces(*a, *b)))
    differences.push_back("its faces are not those in roofs/roofs.city.jsonl");
  if (a == nullptr || building.result.thinned || !run.store().has(0, columns::kRoof)) return differences;
  if (const std::uint64_t others = points_of_other_faces(building, run.store()); others > 0)
    differences.push_back(grouped(others) + " points lie on another face than in the store");
  return differences;
}

std::vector<std::string> buildings_to_replay(const fs::path& out, double metres_per_unit) {
  std::vector<std::string> lines;
  for (const PolygonModel& model : read_models(out / "roofs" / "roofs.city.jsonl").models) {
    Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
    for (const Vec3& p : model.vertices) {
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    const Vec3 size = metres_per_unit * (high - low), middle = 0.5 * (low + high);
    lines.push_back(fmt::format("building:{}  at {:.1f} {:.1f}  {:.1f} x {:.1f} m, {:.1f} m high, {} faces", model.name,
                                middle.x, middle.y, size.x, size.y, size.z, model.faces.size()));
  }
  return lines;
}

}  // namespace ilot
