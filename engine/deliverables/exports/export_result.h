// SPDX-License-Identifier: Apache-2.0
// A finished result in the formats of other programs.
#pragma once
#include <cstdint>
#include <filesystem>
#include <span>
#include <string>
#include <vector>

namespace ilot {

struct ExportFormat {
  const char* name;     // as --to has it
  const char* product;  // of which it needs the result, or names with " or " between them
  const char* meaning;
};

std::span<const ExportFormat> export_formats();

struct ExportParams {
  std::vector<std::string> formats;  // names of export_formats()
  std::string crs;                   // of the coordinates: "EPSG:n"; empty = as the result says
  double geoid_m = 0;                // added to heights where they become heights above the ellipsoid
};

struct ExportSummary {
  std::uint64_t buildings = 0, without_model = 0, facades = 0, objects = 0;
  std::vector<std::string> notes;  // what a user of the files must know, a sentence each
};

// Writes the formats into a new folder, which appears whole or not at all. The same result gives the same bytes. Throws
// a usage Error when the result does not have what a format needs, or when the folder exists.
ExportSummary export_result(const std::filesystem::path& result, const std::filesystem::path& folder,
                            const ExportParams& params);

}  // namespace ilot
