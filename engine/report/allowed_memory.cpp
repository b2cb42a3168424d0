// SPDX-License-Identifier: Apache-2.0
#include "engine/report/allowed_memory.h"

#include <algorithm>
#include <fstream>
#include <string>

namespace ilot {
namespace {

namespace fs = std::filesystem;

std::uint64_t machine_bytes(const fs::path& proc) {
  std::ifstream file(proc / "meminfo");
  std::string name;
  std::uint64_t kibibytes = 0;
  for (std::string line; file >> name && file >> kibibytes && std::getline(file, line);)
    if (name == "MemTotal:") return kibibytes * 1024;
  return UINT64_MAX;
}

// Returns the number in the file; v2 writes "max" for no limit, v1 a number near 2^63.
std::uint64_t limit_in(const fs::path& path) {
  std::ifstream file(path);
  std::uint64_t bytes = 0;
  return file >> bytes ? bytes : UINT64_MAX;
}

// Returns the least limit from a group up to the root. A container sees the paths of the machine, but only its own
// group, as the root. A group that does not exist has no limit.
std::uint64_t limit_of_group(const fs::path& root, const std::string& group, const char* file) {
  std::uint64_t least = limit_in(root / file);
  for (fs::path part = fs::path(group).relative_path(); !part.empty(); part = part.parent_path())
    least = std::min(least, limit_in(root / part / file));
  return least;
}

// Lines of /proc/self/cgroup have the form number:controllers:group; v2 has no controllers there.
std::uint64_t limit_of_line(const std::string& line, const fs::path& groups) {
  const std::size_t first = line.find(':'), second = line.find(':', first + 1);
  if (first == std::string::npos || second == std::string::npos) return UINT64_MAX;
  const std::string controllers = line.substr(first, second - first) + ",", group = line.substr(second + 1);
  if (controllers == ":,") return limit_of_group(groups, group, "memory.max");
  const bool memory =
      controllers.find(":memory,") != std::string::npos || controllers.find(",memory,") != std::string::npos;
  return memory ? limit_of_group(groups / "memory", group, "memory.limit_in_bytes") : UINT64_MAX;
}

}  // namespace

std::uint64_t allowed_memory_bytes(const fs::path& proc, const fs::path& groups) {
  std::uint64_t least = machine_bytes(proc);
  std::ifstream file(proc / "self" / "cgroup");
  for (std::string line; std::getline(file, line);) least = std::min(least, limit_of_line(line, groups));
  return least;
}

}  // namespace ilot
