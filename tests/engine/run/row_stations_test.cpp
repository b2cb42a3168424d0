// SPDX-License-Identifier: Apache-2.0
#include "engine/run/inputs/row_stations.h"

#include <gtest/gtest.h>

namespace ilot {
namespace {

class NamedReader final : public PointReader {
 public:
  NamedReader(const char* path, std::vector<ScanPart> scans, std::vector<Station> stations) {
    info_.path = path;
    info_.scans = std::move(scans);
    info_.stations = std::move(stations);
  }
  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return true; }
  std::vector<std::uint64_t> boundaries() const override { return {0}; }
  std::size_t read(std::uint64_t, std::span<std::byte>, std::span<std::uint8_t>) override { return 0; }

 private:
  CloudInfo info_;
};

using Readers = std::vector<std::unique_ptr<PointReader>>;

Station station(const char* name, std::uint16_t source) {
  Station s;
  s.name = name;
  s.source_id = source;
  return s;
}

using Sources = std::map<std::uint16_t, StationNumber>;

TEST(RowStations, OfAStationsFileByTheNumberOfTheirSource) {
  Readers readers;
  readers.push_back(std::make_unique<NamedReader>("/scans/all.laz", std::vector<ScanPart>{}, std::vector<Station>{}));
  const std::vector<Station> stations{station("1", 1), station("court", 7), station("street", 0)};
  const auto recorded = row_stations(readers, stations, StationsFrom::file);
  ASSERT_EQ(recorded.size(), 1u);
  EXPECT_EQ(recorded[0].of_all, 0);
  EXPECT_EQ(recorded[0].of_source, (Sources{{1, 1}, {7, 2}}));
}

TEST(RowStations, ANumberThatTwoHaveSaysNothing) {
  Readers readers;
  readers.push_back(std::make_unique<NamedReader>("all.laz", std::vector<ScanPart>{}, std::vector<Station>{}));
  const std::vector<Station> stations{station("a", 3), station("b", 3), station("c", 4)};
  EXPECT_EQ(row_stations(readers, stations, StationsFrom::file)[0].of_source, (Sources{{4, 3}}));
}

TEST(RowStations, ACloudCalledAsAStationIsAllItsOwn) {
  Readers readers;
  for (const char* path : {"/scans/court.laz", "/scans/street.e57"})
    readers.push_back(
        std::make_unique<NamedReader>(path, std::vector<ScanPart>{{"s1", 5}, {"s2", 5}}, std::vector<Station>{}));
  const std::vector<Station> stations{station("s2", 9), station("court", 2)};
  const auto recorded = row_stations(readers, stations, StationsFrom::file);
  EXPECT_EQ(recorded[0].of_all, 2);
  EXPECT_EQ(recorded[1].of_all, 0);
  EXPECT_EQ(recorded[1].of_source, (Sources{{2, 1}})) << "the second scan, whatever the station's number";
}

// Scans of each input are numbered from 1, stations of the run over all inputs.
TEST(RowStations, OfTheInputsThemselves) {
  Readers readers;
  readers.push_back(std::make_unique<NamedReader>("a.e57", std::vector<ScanPart>{{"s", 5}, {"t", 5}},
                                                  std::vector<Station>{station("t", 2)}));
  readers.push_back(std::make_unique<NamedReader>("b.las", std::vector<ScanPart>{}, std::vector<Station>{}));
  readers.push_back(std::make_unique<NamedReader>("c.ptx", std::vector<ScanPart>{{"s", 5}, {"t", 5}},
                                                  std::vector<Station>{station("s", 1), station("t", 2)}));
  std::vector<Station> stations;
  for (const auto& r : readers) stations.insert(stations.end(), r->info().stations.begin(), r->info().stations.end());
  const auto recorded = row_stations(readers, stations, StationsFrom::inputs);
  EXPECT_EQ(recorded[0].of_source, (Sources{{2, 1}}));
  EXPECT_TRUE(recorded[1].of_source.empty());
  EXPECT_EQ(recorded[2].of_source, (Sources{{1, 2}, {2, 3}}));
}

}  // namespace
}  // namespace ilot
