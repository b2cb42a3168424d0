// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/merge/merge_roofs.h"

#include <algorithm>
#include <memory>
#include <optional>
#include <queue>

#include "engine/error.h"
#include "engine/pass/pass.h"
#include "engine/products/roofs/footprint_outcome.h"
#include "engine/products/roofs/make_roofs.h"
#include "engine/products/roofs/product.h"
#include "engine/products/roofs/roof_sink.h"
#include "engine/products/roofs/solids/storeys.h"
#include "engine/scale/parts/part_file.h"
#include "engine/scale/records.h"
#include "engine/scale/site_records.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// The own sites of an area, front to back, which is the order of their numbers.
class OwnSites {
 public:
  OwnSites(const fs::path& path, std::size_t buffer) : path_(path), file_(path, buffer) {}
  std::optional<NumberedSite> next() {
    try {
      while (const auto record = file_.next())
        if (NumberedSite site = numbered_site(*record); site.own) return site;
    } catch (const nlohmann::json::exception&) {
      throw Error(path_.string() + ": is damaged; make the plan again");
    }
    return std::nullopt;
  }

 private:
  fs::path path_;
  RecordFileReader file_;
};

// A building with what the plan knows of its site.
struct MergedSite {
  std::uint64_t number = 0;
  bool outside = false;
  BuiltSite built;
  PlacedOutline outline;
};

// The buildings of one part, one for each own site of the area.
class PartReader {
 public:
  PartReader(const fs::path& plan, const fs::path& parts, const std::string& area, std::size_t buffer)
      : path_(parts / area), sites_(plan / kSitesFolder / area, buffer), file_(path_, buffer) {
    advance();
  }
  bool ended() const { return ended_; }
  std::uint64_t number() const { return next_.number; }
  MergedSite take() {
    MergedSite site = std::move(next_);
    advance();
    return site;
  }
  const ShiftCounts& shifts() const { return shifts_; }

 private:
  [[noreturn]] void damaged() const { throw Error(path_.string() + ": is damaged; remove it and run its task again"); }

  void advance() {
    try {
      const auto record = file_.next();
      auto site = sites_.next();
      ended_ = !record || is_summary(*record);
      if (ended_ == site.has_value()) damaged();  // not one building for each site
      if (record && ended_) {
        shifts_ = summary_of(*record).shifts;
        file_.next();  // the end, which proves that the file is whole
      }
      if (!ended_) next_ = {site->number, site->outside, built_site(*record), std::move(site->site.outline)};
    } catch (const nlohmann::json::exception&) {
      damaged();
    }
  }

  fs::path path_;
  OwnSites sites_;
  RecordFileReader file_;
  MergedSite next_;
  ShiftCounts shifts_;
  bool ended_ = false;
};

// What a merge keeps of all sites until the last part is read.
struct Merged {
  SiteNames names;
  ShiftCounts shifts;
  MergedRoofs roofs;
};

// Hands the buildings of all parts to the sink in the order of their numbers.
Merged merge_buildings(const fs::path& folder, const Plan& plan, const fs::path& from,
                       const std::vector<std::uint64_t>& areas, const StoreyCounter& counter, RoofSink& sink,
                       Progress& progress) {
  // Choice: some records fit, and 10,000 parts take 320 MiB at most; with fewer parts each gets more.
  constexpr std::size_t kLeastBuffer = 1u << 15, kMostBuffer = 1u << 20, kAllBuffers = 64u << 20;
  const std::size_t buffer = std::clamp(kAllBuffers / areas.size(), kLeastBuffer, kMostBuffer);
  std::vector<std::unique_ptr<PartReader>> parts;
  using Next = std::pair<std::uint64_t, std::size_t>;
  std::priority_queue<Next, std::vector<Next>, std::greater<>> order;
  for (const std::uint64_t area : areas) {
    parts.push_back(std::make_unique<PartReader>(folder, from, std::to_string(area), buffer));
    if (!parts.back()->ended()) order.push({parts.back()->number(), parts.size() - 1});
  }
  progress.begin_stage("roofs", plan.roofs.sites, {plan.roofs.sites, "buildings"});
  Merged merged;
  merged.roofs.numbers.resize(areas.size());
  std::uint32_t planes = 0;
  while (!order.empty()) {
    stop_if_asked();
    const std::size_t n = order.top().second;
    order.pop();
    MergedSite site = parts[n]->take();
    if (!parts[n]->ended()) order.push({parts[n]->number(), n});
    merged.roofs.labelled += site.built.labelled;
    merged.roofs.numbers[n].push_back({static_cast<std::uint32_t>(++merged.names.sites), planes + 1});
    planes += site.built.result.planes;
    const std::string& id = site.built.result.levels.at(0).id;
    if (site.built.result.status == RoofStatus::footprint_only) {
      merged.names.all.insert(id);
      if (site.outside) merged.names.beyond.insert(id);
    }
    counter.add_to(site.built.result.levels[0].attributes, site.outline);
    sink.take(site.built.result);
    progress.advance(1);
  }
  for (const auto& part : parts) add(merged.shifts, part->shifts());
  progress.end_stage();
  return merged;
}

// All sites of these areas in the order of a run, for a run that made no building of them.
std::vector<PlannedSite> sites_of(const fs::path& plan, const std::vector<std::uint64_t>& areas) {
  constexpr std::size_t kBuffer = 1u << 20;
  std::vector<NumberedSite> sites;
  for (const std::uint64_t area : areas) {
    OwnSites own(plan / kSitesFolder / std::to_string(area), kBuffer);
    while (auto site = own.next()) sites.push_back(std::move(*site));
  }
  std::ranges::sort(sites, {}, &NumberedSite::number);
  std::vector<PlannedSite> ordered;
  for (NumberedSite& site : sites) ordered.push_back(std::move(site.site));
  return ordered;
}

}  // namespace

MergedRoofs merge_roofs(const fs::path& folder, const Plan& plan, const MergedForRoofs& other, const fs::path& parts,
                        const std::vector<std::uint64_t>& areas, const fs::path& staging, Progress& progress,
                        RunRecord& record) {
  record.chosen.insert(record.chosen.end(), other.chosen.begin(), other.chosen.end());
  fs::create_directories(staging / "roofs");
  RoofSink sink(staging / "roofs", roof_files_params(plan.roofs.frame, plan.settings, plan.crs), plan.crs, nullptr,
                record);
  const StoreyCounter counter(other.openings, plan.crs.metres_per_unit);
  Merged merged = merge_buildings(folder, plan, parts, areas, counter, sink, progress);
  sink.finish();
  const bool given = plan.roofs.footprints.has_value();
  if (given) {
    record_misalignment(merged.shifts, progress, record);
    resolve_skipped_footprints(merged.names, progress, record);
  }
  if (record.roofs->buildings == (given ? record.footprints->outside.size() : 0)) {
    const std::string reason = why_no_building(given ? sites_of(folder, areas) : std::vector<PlannedSite>{}, given,
                                               false, plan.roofs.extent, record.crs);
    record.skipped.push_back({"product", roofs_product().name, reason});
    progress.unit_skipped(roofs_product().name, reason);
  }
  return std::move(merged.roofs);
}

}  // namespace ilot
