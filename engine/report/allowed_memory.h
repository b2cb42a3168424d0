// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>

namespace ilot {

// Returns the memory that this process may use: that of the machine, or less when its control group (v1 or v2) or a
// parent of it has a limit. UINT64_MAX when nothing is known. Only tests give other folders than those of the running
// system.
std::uint64_t allowed_memory_bytes(const std::filesystem::path& proc = "/proc",
                                   const std::filesystem::path& groups = "/sys/fs/cgroup");

}  // namespace ilot
