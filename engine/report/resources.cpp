// SPDX-License-Identifier: Apache-2.0
#include "engine/report/resources.h"

#include <sys/resource.h>
#include <unistd.h>
#include <fstream>
#include <string>

namespace ilot {

std::uint64_t resident_bytes() {
  std::ifstream file("/proc/self/statm");
  std::uint64_t total = 0, resident = 0;
  if (!(file >> total >> resident)) return 0;
  return resident * static_cast<std::uint64_t>(sysconf(_SC_PAGESIZE));
}

// getrusage() is not used: its largest size is that of the process that started this one, if that was larger.
std::uint64_t peak_resident_bytes() {
  std::ifstream file("/proc/self/status");
  for (std::string line; std::getline(file, line);)
    if (line.starts_with("VmHWM:")) return std::stoull(line.substr(6)) * 1024;
  return resident_bytes();
}

double cpu_seconds() {
  rusage usage{};
  if (getrusage(RUSAGE_SELF, &usage) != 0) return 0;
  const auto seconds = [](const timeval& t) {
    return static_cast<double>(t.tv_sec) + 1e-6 * static_cast<double>(t.tv_usec);
  };
  return seconds(usage.ru_utime) + seconds(usage.ru_stime);
}

std::uint64_t free_disk_bytes(const std::filesystem::path& path) {
  std::error_code code;
  std::filesystem::path folder = std::filesystem::absolute(path, code);
  while (!std::filesystem::exists(folder, code) && folder.has_relative_path()) folder = folder.parent_path();
  const auto space = std::filesystem::space(folder, code);
  return code ? 0 : space.available;
}

}  // namespace ilot
