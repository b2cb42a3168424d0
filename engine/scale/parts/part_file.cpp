// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/parts/part_file.h"

#include "engine/error.h"
#include "engine/scale/parts/part_place.h"
#include "engine/scale/records.h"

namespace ilot {

using nlohmann::json;

json part_head(const std::string& key) {
  return {{"kind", "part"}, {"key", key}};
}

PartState part_state(const std::filesystem::path& path, const std::string& key, PartSummary& summary) {
  if (!part_exists(path)) return PartState::missing;
  try {
    RecordFileReader file(path);
    if (file.head() != part_head(key)) return PartState::stale;
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

json summary_record(const PartSummary& summary) {
  json counts;
  if (summary.shifts.points > 0) counts = summary.shifts.inside;
  return {{"without_model", summary.without_model},
          {"cells", summary.cells},
          {"shift_points", summary.shifts.points},
          {"shifts", counts}};
}

bool is_summary(const json& record) {
  return record.contains("without_model");
}

PartSummary summary_of(const json& record) {
  PartSummary summary{record.at("without_model").get<std::uint64_t>(), record.at("cells").get<std::uint64_t>(), {}};
  summary.shifts.points = record.at("shift_points").get<std::uint64_t>();
  if (summary.shifts.points > 0) summary.shifts.inside = record.at("shifts").get<decltype(summary.shifts.inside)>();
  return summary;
}

}  // namespace ilot
