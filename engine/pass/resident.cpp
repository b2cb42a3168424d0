// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/resident.h"

#include <malloc.h>

#include <algorithm>
#include <atomic>

#include "engine/report/resources.h"

namespace ilot {
namespace {

std::atomic<std::uint64_t> limit{0};

}  // namespace

void set_memory_limit(std::uint64_t bytes) {
  limit = bytes;
}

std::uint64_t free_memory() {
  const std::uint64_t allowed = limit;
  if (allowed == 0) return UINT64_MAX;
  const std::uint64_t used = resident_bytes();
  return used >= allowed ? 0 : allowed - used;
}

std::uint64_t affordable(std::uint64_t budget_bytes) {
  return std::min(budget_bytes, free_memory());
}

void trim_memory() {
  malloc_trim(0);
}

}  // namespace ilot
