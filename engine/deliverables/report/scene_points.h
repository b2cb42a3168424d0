// SPDX-License-Identifier: Apache-2.0
// A sample of the labelled points of a result, for pictures.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "engine/deliverables/report/result_folder.h"

namespace ilot {

struct ScenePoint {
  Vec3 at;  // CRS
  std::uint32_t plane = 0, unit = 0, object = 0, element = 0;
  std::uint16_t facade = 0;
  std::uint8_t label = 0, classification = 0;
  float residual_m = 0;
  std::array<std::uint16_t, 3> colour{};  // as in the file; grey: the intensity three times
};

struct SampleParams {
  std::size_t most_points = 400000;  // about; each point is taken by a number that depends on its place alone
  std::set<std::uint32_t> units;     // of these buildings more points are kept, for their drawings
  std::size_t tasks = 64;            // parts of clouds that are read at a time
  std::size_t most_of_units = 400;   // of each of them
};

struct SampledPoints {
  std::vector<ScenePoint> points;
  std::map<std::uint32_t, std::vector<Vec3>> of_unit;
  std::uint64_t read = 0;
  std::set<std::string> fields;  // which of plane_id, unit_id, object_id, facade_id, residual, label, colour there are
  std::string problem;           // why there is no point, for people; else empty
};

// Reads the clouds in points/ once. The sample is the same for any number of threads and order of points within equal
// places. Memory: the sample, and a few MiB a thread. O(points).
SampledPoints sample_points(const ResultFolder& result, const SampleParams& params = {});

// Packs a sample: `about` gets the count, the scale and the columns, and the bytes of the columns are returned, one
// column after the other.
std::string packed_points(const SampledPoints& sample, const SceneFrame& frame, nlohmann::ordered_json& about);

}  // namespace ilot
