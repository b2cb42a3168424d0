// SPDX-License-Identifier: Apache-2.0
// run.json: what was asked for, what was done, which resources it took, what was left out and why. Scripts depend on
// the names.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "engine/error.h"
#include "engine/report/progress.h"
#include "engine/settings/settings.h"
#include "ilot/run.h"

namespace ilot {

struct InputRecord {
  std::string path, format, crs;  // crs: name or empty
  std::uint64_t points = 0;       // number that was read
  std::uint64_t bytes = 0;
  std::string output;   // the labelled cloud, relative to OUT; empty when none is written
  std::string dialect;  // for text: separators, decimal point or comma; else empty
};

// A file of the result.
struct ResultRecord {
  std::string path;  // relative to OUT
  std::uint64_t bytes = 0;
};

// A value that was chosen for `auto`.
struct ChosenRecord {
  std::string key;  // "planes.epsilon"
  std::variant<double, std::string> value;
  std::string why;
};

// read = labelled + unlabelled + rejected.
struct PointCounts {
  std::uint64_t read = 0, labelled = 0, unlabelled = 0;
  std::map<std::string, std::uint64_t> rejected;  // reason -> points

  std::uint64_t rejected_total() const;
};

struct RoofCounts {
  std::uint64_t buildings = 0, lod22 = 0, lod12 = 0, footprint_only = 0;  // the first is the sum of the others
  std::uint64_t valid = 0, invalid = 0;  // buildings with solids, by the validity of these as written
  std::uint64_t thinned = 0;             // modelled from a sample of their points
};

struct StreetCounts {
  std::uint64_t objects = 0, blocks = 0, gaps = 0, trees = 0, kerbs = 0;
  std::uint64_t pavement_widths = 0, pavements = 0, carriageways = 0;
};

struct FacadeCounts {
  std::uint64_t facades = 0, elements = 0, occluded_edges = 0;  // occluded_edges: edges of elements that were not seen
};

// An outline that shares a square metre or more with others.
struct OverlapRecord {
  std::string id;
  std::vector<std::string> with;  // ids of the others
};

// The content of a file of footprints.
struct FootprintsRecord {
  std::string path, id_attribute;  // no attribute: features were numbered
  std::uint64_t footprints = 0;
  std::uint64_t mended = 0, without_outline = 0;  // of the outlines that were made from them
  std::vector<OverlapRecord> overlaps;            // the same
  std::vector<std::string> outside;       // ids of those completely outside the extent of the cloud, which is no fault
  bool transformed = false;               // from another CRS
  double shift_x_m = 0, shift_y_m = 0;    // shift with which the outlines would contain the most points
  double inside = 0, inside_shifted = 0;  // share of the building points around them inside, now and with the shift
};

// The result without footprints.
struct ClustersRecord {
  std::uint64_t clusters = 0, too_small = 0, points_of_too_small = 0;
  // Outlines that were made from clusters and have no model, by reason. No fault: nobody said that these are buildings.
  std::map<std::string, std::uint64_t> without_model;
};

// The cells in which planes are searched: cubes aligned with the origin of the coordinates.
struct CellsRecord {
  double unit = 0;                // step of the lattice, CRS units
  std::int64_t edge = 0;          // steps
  std::uint64_t most_points = 0;  // a cell with more is cut into eight
};

// What became of the corrections by hand (--edits).
struct EditsRecord {
  std::uint64_t given = 0, made = 0;
  std::uint64_t repeated = 0;         // say again what another one says
  std::uint64_t without_partner = 0;  // nothing was found where they are; each is in `skipped`
  std::uint64_t outside = 0;          // outside of the area that was asked for
  std::uint64_t not_asked = 0;        // of products that were not asked for
};

// The CRS of the coordinates of all results.
struct CrsRecord {
  std::string name;  // "EPSG:2154", else its name; "none"
  double metres_per_unit = 1;
  std::string wkt;  // where no one code says it, as for plan and heights from two; else empty
};

// What --train learnt. judged: samples that a model of the other folds classified; right: as they are.
struct TrainedClass {
  std::string name;
  std::uint32_t label = 0;  // of points; from 100 on one's own
  std::uint64_t samples = 0, judged = 0, right = 0;
};

struct RunRecord {
  ExitCode exit = ExitCode::ok;
  Settings settings;
  std::vector<std::string> products;
  int threads = 0;
  std::uint64_t memory_bytes = 0;  // the budget
  std::vector<InputRecord> inputs;
  CrsRecord crs;
  std::vector<StageRecord> stages;  // Progress::stages()
  double seconds = 0;
  std::uint64_t peak_rss_bytes = 0;
  std::uint64_t blocks = 0;
  PointCounts points;
  std::optional<std::uint64_t> planes;  // products that did not run have no counts
  std::optional<std::uint64_t> shapes;  // spheres, cylinders and cones, if they were asked for
  std::optional<CellsRecord> cells;     // where planes were searched
  std::optional<RoofCounts> roofs;
  std::optional<StreetCounts> streets;
  std::optional<FacadeCounts> facades;
  std::optional<FootprintsRecord> footprints;
  std::optional<ClustersRecord> clusters;
  std::optional<EditsRecord> edits;  // none: no edits were given
  std::vector<SkippedRecord> skipped;
  std::vector<ChosenRecord> chosen;
  std::vector<TrainedClass> training;  // empty: nothing was trained
  std::vector<std::string> warnings;
  bool unit_assumed = false;
  std::string request;                // what was asked for, JSON (run_request); empty = not recorded
  std::vector<ResultRecord> results;  // every file except run.json
  std::string result_hash;
};

// Returns the text of run.json; version, git hash and the hash of the settings are added.
std::string run_json(const RunRecord& record);

// Writes OUT/run.json completely or not at all.
void write_run_json(const RunRecord& record, const std::filesystem::path& out);

}  // namespace ilot
