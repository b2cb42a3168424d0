// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <memory>
#include <vector>

#include "engine/formats/reader.h"
#include "engine/report/progress.h"
#include "engine/report/run_record.h"
#include "engine/run/options.h"
#include "engine/segments/stations_pass.h"

namespace ilot {

struct RunInputs {
  std::vector<std::unique_ptr<PointReader>> readers;  // by path
  Crs crs;                                            // of them all, one unit in all axes; what products are in
  std::uint64_t points = 0;
  std::vector<Station> stations;            // of the stations file, or else of the inputs
  std::vector<InputStations> row_stations;  // per reader: which of these its rows are from
};

// Opens every input and settles one CRS (input_crs.h). Files that cannot be read are skipped and recorded (Error with
// --strict or when none is left). Mixed CRS and degrees are Errors with ExitCode::usage.
RunInputs open_inputs(const RunOptions& options, Progress& progress, RunRecord& record);

}  // namespace ilot
