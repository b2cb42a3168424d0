// SPDX-License-Identifier: Apache-2.0
// A plan: everything that is decided once for a whole run, so that each area can be worked on alone, on any machine,
// with the result that one run would have. docs/scale.md says what it freezes and why.
#pragma once
#include <array>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/columns/stations_pass.h"
#include "engine/formats/tables/text_dialect.h"
#include "engine/products/roofs/roof_setup.h"
#include "engine/report/run_record.h"
#include "engine/settings/settings.h"
#include "engine/store/sorted_run.h"
#include "engine/store/strays.h"
#include "kernels/geometry/box3.h"

namespace ilot {

constexpr const char* kPlanFile = "plan.json";
constexpr const char* kSitesFolder = "sites";  // sites/N: the sites of area N and their neighbours; of roofs
constexpr const char* kPartsFolder = "parts";  // parts/N: the result of area N

// An input as it was when the plan was made.
struct PlanInput {
  InputRecord record;               // its path is absolute
  std::string ends;                 // hash of its first and last 4 KiB: what a task compares
  std::string sha256;               // of the whole file
  IndexBox box = IndexBox::none();  // of its points in the store, lattice steps
  std::string date;                 // InputSource::date
  InputStations stations;           // of its rows
  bool colours = false;             // has_colours()
};

// What the product roofs needs of the whole run.
struct PlanRoofs {
  bool by_shape = false;  // ground and buildings are found by shape, because no point has a class of buildings
  RoofFrame frame;
  GridBox extent;           // of all points, millimetres
  std::uint64_t sites = 0;  // all: the list in which sites have numbers
  std::optional<FootprintsRecord> footprints;
  std::optional<ClustersRecord> clusters;
};

// An area owns the sites whose first corner lies in its square, and the cells of planes whose corner does. Areas have
// numbers from 1, their place in the list.
struct PlanArea {
  std::int64_t row = 0, column = 0;   // of the square, counted from the origin of the coordinates
  IndexBox own = IndexBox::none();    // whole cells, whose points the part has; none: it has no points
  IndexBox read = IndexBox::none();   // points of this box are read; empty: none
  std::uint64_t sites = 0;            // that it owns
  std::vector<std::uint32_t> inputs;  // places in the list of inputs, ascending
  std::uint64_t points = 0;           // in `read`, estimated from squares of some metres
  std::uint64_t input_bytes = 0;      // of these inputs
  std::uint64_t memory_bytes = 0;     // the least --memory
  std::uint64_t part_bytes = 0;       // expected
  double processor_seconds = 0;       // expected
  std::string sites_sum;              // of the file of its sites
  std::string key;                    // area_key.h: by what its part is known
};

struct Plan {
  std::string version, git_hash;
  std::vector<std::string> products;
  bool labels = false;  // parts of roofs alone have the points too, so that their clouds can be labelled
  Settings settings;
  std::string crs_option;  // --crs
  std::optional<TextDialect> dialect;
  Crs crs;  // of the inputs
  std::vector<PlanInput> inputs;
  InputLattice lattice;
  double rounding = 0;  // PassContext::rounding
  Index3 corner;        // IndexResult::corner
  int stray_bits = 0;
  std::vector<CoarseCell> strays;
  std::uint64_t points = 0;  // of the inputs
  std::map<std::string, std::uint64_t> rejected;
  std::vector<ChosenRecord> chosen;
  std::vector<SkippedRecord> skipped;
  std::vector<std::string> warnings;
  std::string parts;                    // URL of an object store that has the parts; empty: the folder of the plan
  std::filesystem::path stations_file;  // --stations, absolute
  std::vector<Station> stations;        // RunInputs::stations, without their names
  PlanRoofs roofs;                      // where roofs are made
  double halo = 0;                      // metres around the outlines of an area's sites or around its cells, the larger
  std::string halo_why;
  double area_size = 0;  // metres
  std::vector<PlanArea> areas;
  std::string hash;  // of plan.json; filled in when it is written or read
};

// The text of plan.json, without the hash.
std::string plan_text(const Plan& plan);

// Reads PLAN/plan.json. Throws Error with ExitCode::usage where there is none, and Error where it is damaged or of
// another version of the program, whose results could differ.
Plan read_plan(const std::filesystem::path& folder);

// The hash of a text: of plan.json, by which a plan and its labels know each other, or of what decides a part.
std::string plan_hash(const std::string& text);

}  // namespace ilot
