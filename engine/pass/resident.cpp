// SPDX-License-Identifier: Apache-2.0
#include "engine/pass/resident.h"

#include <link.h>
#include <malloc.h>
#include <sys/mman.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <fstream>
#include <span>
#include <string>

#include "engine/pass/kept_columns.h"
#include "engine/report/resources.h"
#include "engine/store/column_cache.h"

namespace ilot {
namespace {

std::atomic<std::uint64_t> limit{0};

std::uint64_t unused_of(std::uint64_t allowed) {
  const std::uint64_t used = resident_bytes();
  return used >= allowed ? 0 : allowed - used;
}

// Choice: kept columns may take a third of the limit, and give way where less than a quarter is free.
constexpr std::uint64_t kKeptPart = 3, kReserve = 4;

// Releases code and constants of the program and of its libraries, most of which are needed only at the start. What is
// needed again is mapped again from the file.
int give_back_code(dl_phdr_info* object, std::size_t, void*) {
  const auto page = static_cast<std::uintptr_t>(sysconf(_SC_PAGESIZE));
  for (const ElfW(Phdr) & part : std::span(object->dlpi_phdr, object->dlpi_phnum)) {
    if (part.p_type != PT_LOAD || (part.p_flags & PF_W) != 0) continue;
    const std::uintptr_t start = object->dlpi_addr + part.p_vaddr;
    const std::uintptr_t first = start / page * page, end = (start + part.p_memsz) / page * page;
    // The address of a page, not of an object. NOLINTNEXTLINE(performance-no-int-to-ptr)
    if (end > first) madvise(reinterpret_cast<void*>(first), end - first, MADV_DONTNEED);
  }
  return 0;
}

// A debugger writes its breakpoints into pages of code; they would be lost.
bool is_debugged() {
  std::ifstream status("/proc/self/status");
  for (std::string line; std::getline(status, line);)
    if (line.starts_with("TracerPid:")) return line.find_first_of("123456789") != std::string::npos;
  return false;
}

}  // namespace

void set_memory_limit(std::uint64_t bytes) {
  limit = bytes;
}

std::uint64_t free_memory() {
  const std::uint64_t allowed = limit;
  if (allowed == 0) return UINT64_MAX;
  const std::uint64_t unused = unused_of(allowed), kept = column_cache_bytes();
  if (unused >= allowed / kReserve || kept == 0) return unused;
  give_up_columns(allowed / kReserve - unused);
  return unused_of(allowed);
}

ColumnRoom::ColumnRoom(std::uint64_t reserved) {
  // Choice: a process with less needs all of it for its tasks.
  constexpr std::uint64_t kLeastLimit = 480u << 20;
  const std::uint64_t allowed = limit;
  const std::uint64_t room = unused_of(allowed) + column_cache_bytes();
  set_column_cache(allowed < kLeastLimit ? 0 : std::min(allowed / kKeptPart, room - std::min(room, reserved)));
}

ColumnRoom::~ColumnRoom() {
  set_column_cache(column_cache_bytes());
}

void give_up_columns(std::uint64_t bytes) {
  const std::uint64_t kept = column_cache_bytes();
  if (kept != 0) set_column_cache(kept - std::min(kept, bytes));
}

KeptColumns::~KeptColumns() {
  set_column_cache(0);
}

std::uint64_t affordable(std::uint64_t budget_bytes) {
  return std::min(budget_bytes, free_memory());
}

void close_gaps() {
  constexpr std::uint64_t kTight = 4;  // memory is scarce when at most one part in this number is free
  if (limit != 0 && free_memory() < limit / kTight) malloc_trim(0);
}

int affordable_threads(std::uint64_t memory_bytes, int wanted) {
  constexpr std::uint64_t kMemoryOfThread = 24u << 20;
  const std::uint64_t most = std::max<std::uint64_t>(memory_bytes / kMemoryOfThread, 1);
  return static_cast<int>(std::min<std::uint64_t>(most, static_cast<std::uint64_t>(wanted)));
}

std::uint64_t allocator_pools(std::uint64_t memory_bytes, int threads) {
  constexpr std::uint64_t kMemoryOfPool = 128u << 20;
  return std::clamp<std::uint64_t>(memory_bytes / kMemoryOfPool, 1, static_cast<std::uint64_t>(threads) + 1);
}

void trim_memory() {
  // Choice: memory that is given back must be cleared again by the system, so it stays while it is little.
  constexpr std::uint64_t kAmple = 4;  // one part in this number of the limit may be in use without being trimmed
  const std::uint64_t allowed = limit;
  if (allowed != 0 && resident_bytes() < allowed / kAmple + column_cache_bytes()) return;
  malloc_trim(0);
  if (!is_debugged()) dl_iterate_phdr(give_back_code, nullptr);
}

}  // namespace ilot
