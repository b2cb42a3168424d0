// SPDX-License-Identifier: Apache-2.0
// report.html: a result on one page that needs no server and no network.
#pragma once
#include <cstdint>
#include <filesystem>
#include <string>

namespace ilot {

struct ReportSummary {
  std::uint64_t bytes = 0;  // of report.html and what is beside it
  bool viewer = true;       // false: ilot was built without npm, so the page has no view in 3D
};

// What a page can have beside the result itself.
struct ReportAdditions {
  std::filesystem::path against;  // folder of another result: also what differs from that one; empty: none
  std::string truth;              // HTML of a <section id="truth">: the result against its truth; empty: none
};

// Reads the result of a finished run in `folder` and writes folder/report.html, complete or not at all, and for many
// buildings report-tiles/ beside it. The same result gives the same bytes, except for seconds, threads and memory.
// Memory: a sample of the points, a row for each building and 24 bytes a plane. Throws Error.
ReportSummary write_report(const std::filesystem::path& folder, const ReportAdditions& additions = {});

// Removes the report of an earlier result.
void remove_report(const std::filesystem::path& folder);

}  // namespace ilot
