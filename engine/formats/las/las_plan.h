// SPDX-License-Identifier: Apache-2.0
// All parts of an output of the LAS family except its points. The LAS and the LAZ writer use it.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/formats/writer.h"

namespace ilot {

// Counts and bounds of rows, as the header needs them. They are sums and extremes of integers, so any order of add and
// merge gives the same result, and ranges may be measured in parallel.
struct PointStatistics {
  std::uint64_t count = 0;
  std::array<std::uint64_t, 15> by_return{};  // return numbers 1 to 15
  std::array<std::int32_t, 3> min{INT32_MAX, INT32_MAX, INT32_MAX}, max{INT32_MIN, INT32_MIN, INT32_MIN};

  // `records` is a multiple of layout.record_length. O(rows).
  void add(std::span<const std::byte> records, const RecordLayout& layout);
  void merge(const PointStatistics& other);
};

struct LasPlan {
  std::vector<std::byte> header;  // counts and bounds are zero until finish_header
  std::vector<Vlr> vlrs, evlrs;
  RecordLayout layout;  // of the rows written, appended fields included
};

// Returns the layout of the rows of an output: the layout of the input, followed by the appended fields with their
// offsets and sizes. Throws Error when the record would exceed 65,535 bytes.
RecordLayout output_layout(const CloudSpec& spec);

// Plans an output that keeps the input's version, header fields, VLRs, EVLRs and CRS, and appends our fields behind its
// extra bytes. Records that describe the compression of the input (LASzip, COPC) are left out. A malformed description
// of extra bytes is replaced by an opaque one. Version 1.4 is chosen when the point format or the number of points
// (spec.like.points) needs it. Throws Error when the record would exceed 65,535 bytes.
LasPlan plan_las(const CloudSpec& spec);

// Returns header and VLRs as bytes up to the points. Sets the number of VLRs and the place of the points. Throws Error
// when a VLR or the whole does not fit its field.
std::vector<std::byte> las_prefix(LasPlan& plan);

// Fills in counts, bounds and the place of the EVLRs, which begin at `evlr_offset`. Throws Error when a version before
// 1.4 cannot represent the count.
void finish_header(LasPlan& plan, const PointStatistics& statistics, std::uint64_t evlr_offset);

// Returns all EVLRs as bytes.
std::vector<std::byte> las_suffix(const LasPlan& plan);

}  // namespace ilot
