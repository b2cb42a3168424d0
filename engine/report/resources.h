// SPDX-License-Identifier: Apache-2.0
// What the process has used and what the disk has left, asked of the operating system. 0 when it does not
// say.
#pragma once
#include <cstdint>
#include <filesystem>

namespace ilot {

std::uint64_t resident_bytes();       // now
std::uint64_t peak_resident_bytes();  // highest since the process began
double cpu_seconds();                 // user and system, all threads

// For an unprivileged writer, on the file system of the nearest existing parent of `path`.
std::uint64_t free_disk_bytes(const std::filesystem::path& path);

}  // namespace ilot
