// SPDX-License-Identifier: Apache-2.0
// A whole run: clouds of any size into planes, roofs, facades and streets, within a budget of memory. The same as the
// command `ilot run`; what it writes is in docs/outputs.md, and planes.h, roofs.h, facades.h and streets.h read it
// back.
//
//   ilot::RunOptions options;
//   options.inputs = {"district.laz"};
//   options.output = "out";
//   options.products = {"planes", "roofs"};
//   const ilot::RunReport report = ilot::run(options);
//
// The same inputs and settings give the same bytes, whatever the threads, the memory and the machine.
#pragma once
#include <atomic>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "ilot/array_cloud.h"
#include "ilot/cloud_info.h"
#include "ilot/error.h"
#include "ilot/geometry.h"
#include "ilot/settings.h"

namespace ilot {

// What to do when the output folder exists.
enum class Existing { refuse, resume, overwrite };

struct RunOptions {
  std::vector<std::filesystem::path> inputs;    // point clouds; folders of them; patterns with * ? [
  std::vector<ArrayCloud> arrays;               // point clouds in memory, after those of inputs
  std::filesystem::path output;                 // folder for the results
  std::vector<std::string> products{"planes"};  // planes, roofs, facades, streets
  Settings settings;
  std::uint64_t memory_bytes = std::uint64_t{2} << 30;  // upper bound of resident memory, at least 96 MiB
  int threads = 0;                                      // 0 = all that the process may use, at most 1024
  std::filesystem::path store;                          // for the blocks while it works; empty = output/.store
  std::optional<Area> area;                             // products inside only, neighbours as halo
  std::filesystem::path footprints;                     // outlines of buildings; empty = none
  std::string id_field;                                 // attribute of the footprints that names them; empty = found
  std::filesystem::path stations;                       // where the scanners stood; empty = as the inputs say
  std::filesystem::path train;               // streets: a model of things (objects.model); empty = the own one
  std::vector<std::filesystem::path> edits;  // tables of corrections by hand, made one after the other; empty = none
  std::optional<TextDialect> dialect;        // of text inputs; none: found from their rows
  std::string to_crs;                        // reproject to: "EPSG:2154", "utm" or empty
  std::string crs;                           // overrides the inputs'; "EPSG:2154" or empty
  Existing existing = Existing::refuse;
  bool strict = false;      // the first skipped file or unit ends the run with ExitCode::failed
  bool dry_run = false;     // say what would be done and needed, write nothing
  bool keep_store = false;  // leave the block store behind
  bool clouds = true;       // write the inputs again with labels, into points/
  bool report = false;      // write report.html, the result on one page for people
};

// Where a run is. Stages follow one another: index, normals, planes, join, boundaries, ..., write.
struct RunProgress {
  std::string stage;
  std::uint64_t points_done = 0, points_total = 0;  // of the stage; total 0: not known
  double seconds = 0;                               // since the run began
};

// Called from several threads, never two at once. An exception out of one of them ends the program, so that they should
// only note, draw or ask for a stop.
struct RunCallbacks {
  std::function<void(const RunProgress&)> progress;  // at the start and the end of stages, and every second
  std::function<void(std::string_view)> message;     // a line for people with its newline: what `ilot run` prints
  // True: this run ends soon with ExitCode::interrupted, and no other, also while it waits for its turn. May be set by
  // any thread or a signal handler; looked at after every call of a function above and five times a second.
  const std::atomic<bool>* stop = nullptr;
};

struct SkippedRecord {
  std::string what;    // "input", "unit", "product", "edit"
  std::string where;   // path or id
  std::string reason;  // one sentence
};

// What a run did: what run.json says of it. points_read = labelled + unlabelled + all rejected.
struct RunReport {
  ExitCode exit = ExitCode::ok;  // ok; incomplete: something was skipped; failed: so with options.strict
  std::filesystem::path folder;
  std::vector<std::string> products;
  std::uint64_t points_read = 0, points_labelled = 0, points_unlabelled = 0;
  std::map<std::string, std::uint64_t> points_rejected;  // reason -> points
  std::vector<SkippedRecord> skipped;
  std::vector<std::string> warnings;
  std::map<std::string, std::string> chosen;  // setting that was auto -> the value that was used
  std::vector<std::filesystem::path> files;   // of the result, relative to the folder; without run.json
  std::vector<std::filesystem::path> clouds;  // labelled clouds, one an input, relative to the folder; may be none
  double seconds = 0;
  std::uint64_t peak_memory_bytes = 0;
  std::string result_hash;  // SHA-256 over the files
};

// Does what the options say and writes the output folder, which appears when it is complete. Throws Error with
// ExitCode::usage (nothing was begun), failed, or interrupted (`Existing::resume` goes on from there). Of a dry run the
// report holds only the folder and the exit code; what it found out comes as messages.
//
// May be called any number of times in one process, one after the other: a call from a second thread waits until the
// first is done or its own stop is asked for, since memory is counted by process. While it works it uses
// options.threads threads of its own. The peak of memory is that of the process since it began. GDAL's error handler of
// the process is set to a silent one.
RunReport run(const RunOptions& options, const RunCallbacks& callbacks = {});

// What run.json in the folder of a finished run says. Error (usage) when there is none.
RunReport read_run(const std::filesystem::path& run_folder);

// Ends all that runs in this process, soon, with ExitCode::interrupted: from any thread, from a signal handler, from a
// callback. Holds for later runs too, until accept_runs().
void request_stop();
void accept_runs();

// "X0,Y0,X1,Y1" in the units of the CRS, corners in any order. Error (usage) for other text.
Area parse_bounds(std::string_view text);

// GeoJSON or WKT polygons in the coordinates of the clouds, at most 64 MiB. Error (usage) for anything else.
Area read_area(const std::filesystem::path& path);

}  // namespace ilot
