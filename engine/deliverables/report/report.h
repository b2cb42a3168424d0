// SPDX-License-Identifier: Apache-2.0
// report.html: a result on one page that needs no server and no network.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ilot {

struct ReportSummary {
  std::uint64_t bytes = 0;  // of report.html and what is beside it
  bool viewer = true;       // false: ilot was built without npm, so the page has no view in 3D
};

// Reads the result of a finished run in `folder` and writes folder/report.html, complete or not at all, and for many
// buildings report-tiles/ beside it. The same result gives the same bytes, except for seconds, threads and memory.
// Memory: a sample of the points, a row for each building and 24 bytes a plane. Throws Error.
// With `against`, the folder of another result, it also has what differs from that one.
ReportSummary write_report(const std::filesystem::path& folder, const std::filesystem::path& against = {});

// Removes the report of an earlier result.
void remove_report(const std::filesystem::path& folder);

}  // namespace ilot
