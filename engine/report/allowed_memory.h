// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>

namespace ilot {

// Memory that this process may have: the machine's, or less where a control group (v1 or v2) that it is in, or a parent
// of that, has a limit. UINT64_MAX when nothing says. The folders are those of the running system but for tests.
std::uint64_t allowed_memory_bytes(const std::filesystem::path& proc = "/proc",
                                   const std::filesystem::path& groups = "/sys/fs/cgroup");

}  // namespace ilot
