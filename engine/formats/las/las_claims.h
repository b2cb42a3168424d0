// SPDX-License-Identifier: Apache-2.0
// What the header of a LAS or LAZ file declares about its points, for comparison with the points. (LAS 1.4 R15)
#pragma once
#include <array>
#include <cstdint>
#include <string>

#include "engine/cloud/cloud_info.h"

namespace ilot {

struct LasClaims {
  std::uint64_t legacy_count = 0;  // 32 bits, in every version
  std::array<std::uint64_t, 5> legacy_returns{};
  bool has_counts = false;  // the file has the 64-bit fields of version 1.4
  std::uint64_t count = 0;
  std::array<std::uint64_t, 15> returns{};
  std::array<double, 3> min{}, max{};                       // units of the CRS
  std::uint64_t header_bytes = 0, needed_header_bytes = 0;  // actual size; size that the version requires
  int needed_minor = 0;                                     // lowest version 1.x that supports the point format
  std::uint32_t vlrs = 0;                                   // records before the points
  std::uint64_t whole_vlrs = 0;                             // number of these that were read
  bool wkt_flag = false, has_wkt = false, has_geotiff = false;
  std::string extra_bytes_fault;        // empty: the descriptors fit the record
  std::uint64_t undescribed_bytes = 0;  // at the end of each point
};

// True for clouds of the LAS family. claims_of is meaningful only for these.
bool has_las_header(const CloudInfo& info);

// Checks nothing. `info` must come from a reader of the LAS family. O(bytes of the VLRs).
LasClaims claims_of(const CloudInfo& info);

}  // namespace ilot
