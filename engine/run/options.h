// SPDX-License-Identifier: Apache-2.0
// What one run is asked to do: plain data, filled by the command line or any other caller.
#pragma once
#include <cstdint>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "engine/cloud/area.h"
#include "engine/formats/tables/text_dialect.h"
#include "engine/products/streets/make_streets.h"
#include "engine/settings/settings.h"

namespace ilot {

// What to do when the output folder exists.
enum class Existing { refuse, resume, overwrite };

struct RunOptions {
  std::vector<std::filesystem::path> inputs;  // files, each once, sorted (expand_inputs)
  std::filesystem::path output;
  std::vector<std::string> products{"planes"};
  Settings settings;
  std::uint64_t memory_bytes = std::uint64_t{2} << 30;  // upper bound of resident memory
  int threads = 0;                                      // 0 = all that the process may use
  std::filesystem::path store;                          // empty = output/.store
  std::optional<Area> area;                             // products inside only, neighbours as halo
  std::filesystem::path footprints;                     // outlines of buildings; empty = none
  std::filesystem::path stations;                       // where the scanners stood; empty = as the inputs say
  StreetTraining train;                                 // what things on streets are, to learn from
  std::optional<TextDialect> dialect;                   // of text inputs; none: found from their rows
  std::string to_crs;                                   // reproject to: "EPSG:2154", "utm" or empty
  std::string crs;                                      // overrides the inputs'; "EPSG:2154" or empty
  Existing existing = Existing::refuse;
  bool strict = false;      // the first skipped file or unit ends the run with exit 1
  bool dry_run = false;     // say what would be done and needed, write nothing
  bool keep_store = false;  // leave the block store behind
  bool clouds = true;       // write the inputs again with labels, into points/
};

}  // namespace ilot
