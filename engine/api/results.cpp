// SPDX-License-Identifier: Apache-2.0
// What a run wrote, read back.
#include <algorithm>

#include "engine/deliverables/layers/gpkg_readers.h"
#include "engine/deliverables/layers/pavements_gpkg.h"
#include "engine/deliverables/solids/roofs_reader.h"
#include "engine/deliverables/tables/facade_json.h"
#include "engine/deliverables/tables/planes_csv.h"
#include "engine/error.h"
#include "engine/model/point_label.h"
#include "ilot/facades.h"
#include "ilot/planes.h"
#include "ilot/roofs.h"
#include "ilot/streets.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// A file of a product in a run's folder.
fs::path result_file(const fs::path& folder, const char* name, const char* product) {
  fs::path path = folder / name;
  if (!fs::exists(path))
    throw Error(path.string() + ": is missing: a run with the product " + product + " writes it", ExitCode::usage);
  return path;
}

const AttributeValue* find_attribute(const BuildingModel& model, const std::string& name) {
  for (const auto& [key, value] : model.attributes)
    if (key == name) return &value;
  return nullptr;
}

}  // namespace

PlaneSet read_planes(const fs::path& run_folder) {
  PlaneSet set;
  set.segments = read_planes_csv(result_file(run_folder, "planes.csv", "planes"));
  set.neighbours = read_planes_neighbours_csv(result_file(run_folder, "planes_neighbours.csv", "planes"));
  set.outlines = read_planes_gpkg(result_file(run_folder, "planes.gpkg", "planes"));
  bool good = set.outlines.size() == set.segments.size();
  for (std::size_t i = 0; good && i < set.segments.size(); ++i)
    good = set.segments[i].id == i + 1 && set.outlines[i].plane_id == i + 1;
  if (!good) throw Error((run_folder / "planes.csv").string() + ": does not agree with planes.gpkg beside it");
  return set;
}

std::vector<BuildingModel> read_roofs(const fs::path& run_folder) {
  return read_roofs_sequence(result_file(run_folder, "roofs/roofs.city.jsonl", "roofs"));
}

std::optional<double> BuildingModel::number(const std::string& name) const {
  const AttributeValue* value = find_attribute(*this, name);
  if (value == nullptr) return std::nullopt;
  if (const auto* whole = std::get_if<std::int64_t>(value)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(value)) return *real;
  return std::nullopt;
}

std::optional<std::string> BuildingModel::text(const std::string& name) const {
  const AttributeValue* value = find_attribute(*this, name);
  const auto* found = value == nullptr ? nullptr : std::get_if<std::string>(value);
  return found == nullptr ? std::nullopt : std::optional(*found);
}

std::vector<Facade> read_facades(const fs::path& run_folder) {
  const fs::path folder = result_file(run_folder, "facades", "facades");
  std::vector<Facade> facades;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder)) {
    const std::string name = entry.path().filename().string();
    if (name.starts_with("facade-") && name.ends_with(".json")) facades.push_back(read_facade_json(entry.path()));
  }
  std::sort(facades.begin(), facades.end(), [](const Facade& a, const Facade& b) { return a.id < b.id; });
  return facades;
}

StreetPlan read_streets(const fs::path& run_folder) {
  StreetPlan plan;
  plan.objects = read_objects_gpkg(result_file(run_folder, "streets/objects.gpkg", "streets"));
  read_blocks_gpkg(result_file(run_folder, "streets/blocks.gpkg", "streets"), plan);
  // Runs of earlier versions have neither.
  if (const fs::path trees = run_folder / "streets" / "trees.gpkg"; fs::exists(trees))
    plan.trees = read_trees_gpkg(trees);
  if (const fs::path kerbs = run_folder / "streets" / "kerbs.gpkg"; fs::exists(kerbs))
    plan.kerbs = read_kerbs_gpkg(kerbs);
  if (const fs::path pavements = run_folder / "streets" / "pavements.gpkg"; fs::exists(pavements)) {
    plan.widths = read_pavement_widths(pavements);
    plan.pavements = read_pavements_gpkg(pavements);
    plan.carriageways = read_carriageways(pavements);
  }
  return plan;
}

const char* pavement_end_name(PavementEnd end) {
  return name_of(end);
}

std::string label_name(PointLabel label) {
  return class_name_of(label, {});
}

}  // namespace ilot
