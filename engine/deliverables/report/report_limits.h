// SPDX-License-Identifier: Apache-2.0
// How much a report may hold, so that it fits into the memory that its run was allowed, and into a page.
#pragma once
#include <algorithm>
#include <cstddef>
#include <cstdint>

namespace ilot {

// Choice: a page of some ten MB opens at once, and a point takes about 10 bytes of it. With less memory each bound is a
// fixed part of it; the sum of them is about a fifth.
struct ReportLimits {
  std::size_t points = 400000;           // 160 bytes each while they are packed
  std::size_t planes = 20000;            // one by one; 300 bytes
  std::size_t outline_corners = 200000;  // of planes; 60 bytes
  std::size_t sheet_bytes = 7u << 20;    // of HTML with drawings of facades
  std::size_t image_bytes = 5u << 20;    // of their images
  std::size_t tasks = 64;                // parts of clouds that are read at a time; up to 10 MB each
};

inline ReportLimits report_limits(std::uint64_t memory_bytes) {
  const ReportLimits most;
  const auto part = [&](std::size_t limit, std::uint64_t one_in) {
    return std::min<std::size_t>(limit, std::max<std::uint64_t>(1, memory_bytes / one_in));
  };
  return {part(most.points, 1600),    part(most.planes, 10000),   part(most.outline_corners, 1600),
          part(most.sheet_bytes, 40), part(most.image_bytes, 80), part(most.tasks, 64u << 20)};
}

}  // namespace ilot
