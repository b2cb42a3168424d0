// SPDX-License-Identifier: Apache-2.0
// Resources that the process has used and free disk space, as the operating system reports them. 0 when it reports
// nothing.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ilot {

std::uint64_t resident_bytes();       // now
std::uint64_t peak_resident_bytes();  // highest since the process began
double cpu_seconds();                 // user and system, all threads

// Free space for an unprivileged writer, on the file system of the nearest existing parent of `path`.
std::uint64_t free_disk_bytes(const std::filesystem::path& path);

}  // namespace ilot
