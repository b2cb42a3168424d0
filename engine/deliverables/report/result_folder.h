// SPDX-License-Identifier: Apache-2.0
// A finished result, as its report reads it.
#pragma once
#include <cstdint>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "engine/report/run_record.h"
#include "kernels/core/types.h"

namespace ilot {

// Positions in a scene: metres from `origin`, axes as the CRS has them.
struct SceneFrame {
  Vec3 origin;                 // CRS units
  double metres_per_unit = 1;  // of all three axes

  Vec3 at(Vec3 p) const { return metres_per_unit * (p - origin); }
};

struct ResultFolder {
  std::filesystem::path path;
  nlohmann::ordered_json run;       // run.json
  std::vector<ResultRecord> files;  // of the result, in the order of run.json; paths as they are on disk
  double metres_per_unit = 1;
  std::uint64_t memory_bytes = std::uint64_t{2} << 30;  // that the run was allowed

  bool has(const std::string& file) const;  // one of `files`
  bool makes(const char* product) const;
  std::uint64_t count(const char* product, const char* what) const;  // counts.PRODUCT.WHAT; 0 where there is none
};

// Throws a usage Error that says what to do when the folder has no run.json or one that cannot be read.
ResultFolder open_result(const std::filesystem::path& path);

}  // namespace ilot
