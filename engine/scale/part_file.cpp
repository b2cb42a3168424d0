// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/part_file.h"

#include "engine/error.h"
#include "engine/scale/records.h"

namespace ilot {

using nlohmann::json;

json part_head(const std::string& plan_hash, std::uint64_t area) {
  return {{"kind", "part"}, {"plan", plan_hash}, {"area", area}};
}

PartState part_state(const std::filesystem::path& path, const std::string& plan_hash, std::uint64_t area,
                     PartSummary& summary) {
  if (!std::filesystem::exists(path)) return PartState::missing;
  try {
    RecordFileReader file(path);
    if (file.head() != part_head(plan_hash, area)) return PartState::stale;
    bool ended = false;
    while (const auto record = file.next())
      if (is_summary(*record)) {
        summary = summary_of(*record);
        ended = true;
      }
    return ended ? PartState::whole : PartState::damaged;
  } catch (const Error&) {
    return PartState::damaged;
  } catch (const json::exception&) {
    return PartState::damaged;
  }
}

json summary_record(const PartSummary& summary, const ShiftCounts& shifts) {
  json counts;
  if (shifts.points > 0) counts = shifts.inside;
  return {{"without_model", summary.without_model}, {"shift_points", shifts.points}, {"shifts", counts}};
}

bool is_summary(const json& record) {
  return record.contains("without_model");
}

PartSummary summary_of(const json& record) {
  return {record.at("without_model").get<std::uint64_t>()};
}

ShiftCounts shifts_of(const json& record) {
  ShiftCounts counts;
  counts.points = record.at("shift_points").get<std::uint64_t>();
  if (counts.points > 0) counts.inside = record.at("shifts").get<decltype(counts.inside)>();
  return counts;
}

}  // namespace ilot
