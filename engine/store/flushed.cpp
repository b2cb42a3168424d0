// SPDX-License-Identifier: Apache-2.0
#include "engine/store/flushed.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>
#include <vector>

#include "engine/error.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

// The file "flushed": the boot during which the folder was last opened, then the names of the passes.
struct Flushed {
  std::string boot;
  std::set<std::string> passes;
};

fs::path path_in(const fs::path& folder) {
  return folder / "flushed";
}

Flushed read_flushed(const fs::path& folder) {
  Flushed f;
  std::ifstream file(path_in(folder));
  std::getline(file, f.boot);
  for (std::string pass; std::getline(file, pass);) f.passes.insert(pass);
  return f;
}

void write_flushed(const fs::path& folder, const Flushed& f) {
  std::string text = f.boot + "\n";
  for (const std::string& pass : f.passes) text += pass + "\n";
  write_whole_file(path_in(folder), text);
}

void remove_columns(const fs::path& folder, const std::set<std::string>& names) {
  if (!fs::exists(folder / "blocks")) return;
  std::vector<fs::path> found;
  for (const auto& entry : fs::directory_iterator(folder / "blocks"))
    if (const std::string end = entry.path().extension().string(); !end.empty() && names.count(end.substr(1)) != 0)
      found.push_back(entry.path());
  for (const fs::path& path : found) fs::remove(path);
}

// Removes all files of the passes that were not flushed. If the index was not flushed, all blocks are removed.
void remove_unflushed(const fs::path& folder, const std::set<std::string>& flushed) {
  if (flushed.count(info_of(Pass::index).name) == 0)
    for (const char* name : {"index", "rejected", "blocks"}) fs::remove_all(folder / name);
  std::set<std::string> names;
  for (const ColumnInfo* c : all_columns())
    if (flushed.count(info_of(c->writer).name) == 0) names.insert(c->name);
  remove_columns(folder, names);
  for (int p = 0; p < kPasses; ++p) {
    const PassInfo& pass = info_of(static_cast<Pass>(p));
    if (flushed.count(pass.name) != 0) continue;
    std::istringstream folders(pass.folders);
    for (std::string name; folders >> name;) fs::remove_all(folder / name);
  }
}

void flush_file_system(const fs::path& folder) {
  const int file = ::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC);
  const bool good = file >= 0 && ::syncfs(file) == 0;
  const int code = errno;
  if (file >= 0) ::close(file);
  if (!good)
    throw Error(folder.string() + ": cannot be written to the disk: " + std::strerror(code) +
                "; give --store DIR on another disk");
}

}  // namespace

std::string this_boot() {
  std::ifstream file("/proc/sys/kernel/random/boot_id");
  std::string id;
  std::getline(file, id);
  return id;
}

void open_flushed(const fs::path& folder, const std::string& boot) {
  const bool known = fs::exists(path_in(folder));
  Flushed f = read_flushed(folder);
  if (known && f.boot == boot && !boot.empty()) return;
  if (known || fs::exists(folder / "blocks")) remove_unflushed(folder, f.passes);
  f.boot = boot;
  write_flushed(folder, f);
}

void flush_folder(const fs::path& folder, Pass pass, const std::string& boot) {
  Flushed f = read_flushed(folder);
  f.boot = boot;
  f.passes.insert(info_of(pass).name);
  flush_file_system(folder);
  write_flushed(folder, f);
}

}  // namespace ilot
