// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/label_store.h"

#include <algorithm>
#include <array>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/error.h"
#include "engine/labels/row_labels.h"
#include "engine/products/facades/facade_labels.h"
#include "engine/products/planes/plane_labels.h"
#include "engine/products/roofs/roof_labels.h"
#include "engine/products/streets/street_labels.h"
#include "engine/scale/plan_products.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr const char* kHead = "labels.json";  // written last
constexpr const char* kBlocks = "blocks.list";
constexpr const char* kPlanes = "planes.list";

bool is_needed(const fs::path& file) {
  const std::string column = file.extension().string();
  constexpr std::array kNeeded{&columns::kRowOrder.info, &columns::kPlaneRows.info, &columns::kRoofRows.info,
                               &columns::kFacadeRows.info, &columns::kStreetRows.info};
  return std::ranges::any_of(kNeeded, [&](const ColumnInfo* info) { return column == std::string(".") + info->name; });
}

void remove_what_no_label_needs(const fs::path& folder) {
  std::vector<fs::path> needless;
  for (const auto& entry : fs::directory_iterator(folder))
    if (entry.path().filename() != "blocks") needless.push_back(entry.path());
  for (const auto& entry : fs::directory_iterator(folder / "blocks"))
    if (!is_needed(entry.path())) needless.push_back(entry.path());
  for (const fs::path& path : needless) fs::remove_all(path);
}

nlohmann::json head_of(const fs::path& folder) {
  std::ifstream file(folder / kHead);
  return nlohmann::json::parse(file, nullptr, false);
}

ProductLabels kept_plane_labels(const Plan& plan, const fs::path& folder, bool shapes) {
  PlaneLabelParams params;
  params.planes = read_column<JoinedPlane>(folder / kPlanes);
  params.write_normals = plan.settings.normals.write;
  if (shapes) params.final_shape = {0};  // the field is there; rows have the ids already
  return plane_labels(std::move(params));
}

// In the order of labels_of().
std::vector<ProductLabels> kept_labels(const Plan& plan, const fs::path& folder, bool shapes) {
  const auto asked = [&](const char* product) { return std::ranges::count(plan.products, product) > 0; };
  std::vector<ProductLabels> labels;
  if (searches_planes(plan)) labels.push_back(kept_plane_labels(plan, folder, shapes));
  if (makes_roofs(plan)) labels.push_back(roof_labels(searches_planes(plan)));
  if (asked("facades")) labels.push_back(facade_labels());
  if (asked("streets")) labels.push_back(street_labels());
  return labels;
}

}  // namespace

void prepare_labels(const Store& store, std::span<const ProductLabels> labels,
                    const std::optional<LabelledPlanes>& planes, const PassContext& context) {
  rows_pass(store, labels, context);
  const fs::path folder = store.folder();
  remove_what_no_label_needs(folder);
  write_column<Block>(folder / kBlocks, store.blocks());
  if (planes) write_column<JoinedPlane>(folder / kPlanes, planes->planes);
  write_whole_file(folder / kHead, nlohmann::json{{"shapes", planes && planes->shapes}}.dump() + "\n");
}

void publish_labels(const fs::path& folder, const Plan& plan, const fs::path& plan_folder,
                    const std::string& result_hash) {
  nlohmann::json head = head_of(folder);
  head["plan"] = plan.hash;
  head["result"] = result_hash;
  write_whole_file(folder / kHead, head.dump() + "\n");
  const fs::path kept = plan_folder / kLabelsFolder;
  fs::remove_all(kept);
  fs::rename(folder, kept);
}

KeptLabels open_labels(const Plan& plan, const fs::path& plan_folder, const IndexBox& box) {
  const fs::path folder = plan_folder / kLabelsFolder;
  const nlohmann::json head = head_of(folder);
  if (!head.is_object() || head.value("plan", "") != plan.hash)
    throw Error(folder.string() + ": no merge of this plan has left labels there; run ilot merge with --labels first",
                ExitCode::usage);
  std::vector<Block> blocks = read_column<Block>(folder / kBlocks);
  std::erase_if(blocks, [&](const Block& b) { return box.is_empty() || !b.box.intersects(box); });
  return {Store(folder, plan.lattice.unit, std::move(blocks)), kept_labels(plan, folder, head.value("shapes", false)),
          head.value("result", "")};
}

}  // namespace ilot
