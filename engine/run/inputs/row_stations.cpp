// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/row_stations.h"

#include <algorithm>

#include "engine/formats/writer.h"

namespace ilot {
namespace {

// Returns the only station for which `is_it` is true; 0 when there is none or there are two.
template <class IsIt>
StationNumber only_one(std::span<const Station> stations, const IsIt& is_it) {
  StationNumber found = 0;
  for (std::size_t i = 0; i < stations.size(); ++i) {
    if (!is_it(stations[i])) continue;
    if (found != 0) return 0;
    found = static_cast<StationNumber>(i + 1);
  }
  return found;
}

StationNumber called(const std::string& name, std::span<const Station> stations) {
  return only_one(stations, [&](const Station& s) { return s.name == name; });
}

InputStations of_sources(std::span<const Station> stations, std::size_t first, std::size_t count) {
  InputStations input;
  for (const Station& s : stations.subspan(first, count)) {
    if (s.source_id == 0) continue;
    const StationNumber one =
        only_one(stations.subspan(first, count), [&](const Station& other) { return other.source_id == s.source_id; });
    if (one != 0) input.of_source[s.source_id] = static_cast<StationNumber>(first + one);
  }
  return input;
}

InputStations of_file(const CloudInfo& info, std::span<const Station> stations) {
  if (const StationNumber all = called(cloud_stem(info.path), stations)) return {all, {}};
  InputStations input;
  for (std::size_t s = 0; s < std::min<std::size_t>(info.scans.size(), UINT16_MAX); ++s)
    if (const StationNumber scan = called(info.scans[s].name, stations))
      input.of_source[static_cast<std::uint16_t>(s + 1)] = scan;
  return input.of_source.empty() ? of_sources(stations, 0, stations.size()) : input;
}

}  // namespace

std::vector<InputStations> row_stations(const std::vector<std::unique_ptr<PointReader>>& readers,
                                        std::span<const Station> stations, StationsFrom from) {
  stations = stations.first(std::min(stations.size(), kMostNumberedStations));
  std::vector<InputStations> inputs;
  std::size_t first = 0;
  for (const auto& reader : readers) {
    const CloudInfo& info = reader->info();
    if (from == StationsFrom::file) {
      inputs.push_back(of_file(info, stations));
      continue;
    }
    const std::size_t own = std::min(info.stations.size(), stations.size() - first);
    inputs.push_back(info.stations.size() == 1 && info.scans.size() < 2 && own == 1
                         ? InputStations{static_cast<StationNumber>(first + 1), {}}
                         : of_sources(stations, first, own));
    first += own;
  }
  return inputs;
}

}  // namespace ilot
