// SPDX-License-Identifier: Apache-2.0
#include "engine/run/result_swap.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cstring>
#include <fstream>
#include <set>
#include <sstream>

#include "engine/error.h"
#include "engine/report/product_files.h"
#include "engine/whole_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

constexpr const char* kNew = ".new";
constexpr const char* kSwap = ".swap";
constexpr const char* kRunJson = "run.json";
constexpr std::streamsize kPiece = 1 << 16;
constexpr const char* kGoing =
    ".going";  // in the folder of the new result: files of the old one that have no replacement

// Flushes a file or folder: its content is on the disk when this returns.
void flush(const fs::path& path) {
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  const bool good = file >= 0 && (fsync(file) == 0 || errno == EINVAL);  // some file systems cannot fsync folders
  const int reason = errno;
  if (file >= 0) close(file);
  if (!good) throw Error(path.string() + ": cannot be written to the disk: " + std::strerror(reason));
}

void flush_all(const fs::path& folder) {
  for (const auto& entry : fs::recursive_directory_iterator(folder))
    if (entry.is_regular_file() || entry.is_directory()) flush(entry.path());
  flush(folder);
}

// Names may contain any byte except zero, so a zero byte ends each name.
std::string list_text(const std::vector<std::string>& names) {
  std::string text;
  for (const std::string& name : names) text.append(name).push_back('\0');
  return text;
}

std::vector<std::string> read_list(const fs::path& path) {
  std::ifstream file(path, std::ios::binary);
  std::vector<std::string> names;
  for (std::string name; std::getline(file, name, '\0');) names.push_back(name);
  return names;
}

// Tells whether a path of OUT contains only folders; a link leads to files that do not belong to the run.
bool is_reached_by_folders(const fs::path& out, const fs::path& relative) {
  fs::path folder = out;
  for (const fs::path& part : relative.parent_path())
    if (!fs::is_directory(fs::symlink_status(folder /= part))) return false;
  return true;
}

// Removes the file and the folders that become empty.
void remove_file(const fs::path& out, const fs::path& relative) {
  if (!is_reached_by_folders(out, relative)) return;
  fs::remove(out / relative);
  for (fs::path folder = relative.parent_path(); !folder.empty(); folder = folder.parent_path())
    if (rmdir((out / folder).c_str()) != 0) return;
}

void move_in(const fs::path& swap, const fs::path& out) {
  fs::remove(out / kRunJson);  // without run.json there is no result, so no one can use a mixture of both
  for (const std::string& name : read_list(swap / kGoing)) remove_file(out, name);
  std::set<fs::path> folders{out};
  for (const fs::path name : product_files(swap)) {
    for (fs::path folder = name.parent_path(); !folder.empty(); folder = folder.parent_path())
      folders.insert(out / folder);
    fs::create_directories((out / name).parent_path());
    fs::rename(swap / name, out / name);
  }
  for (const fs::path& folder : folders) flush(folder);
  fs::rename(swap / kRunJson, out / kRunJson);
  flush(out);
}

bool have_same_content(const fs::path& a, const fs::path& b) {
  std::error_code problem;
  if (!fs::is_regular_file(fs::symlink_status(a, problem)) || fs::file_size(a) != fs::file_size(b, problem))
    return false;
  std::ifstream left(a, std::ios::binary), right(b, std::ios::binary);
  std::vector<char> pieces[2]{std::vector<char>(kPiece), std::vector<char>(kPiece)};
  while (left && right) {
    left.read(pieces[0].data(), kPiece);
    right.read(pieces[1].data(), kPiece);
    if (left.gcount() != right.gcount() ||
        !std::equal(pieces[0].begin(), pieces[0].begin() + left.gcount(), pieces[1].begin()))
      return false;
  }
  return left.eof() && right.eof();
}

}  // namespace

bool is_inside(const fs::path& relative) {
  if (relative.empty() || relative.is_absolute() || relative.begin()->string().starts_with(".")) return false;
  return std::none_of(relative.begin(), relative.end(), [](const fs::path& part) { return part == ".."; });
}

void check_places(const fs::path& out, const std::vector<std::string>& old_files,
                  const std::vector<std::string>& new_files) {
  const std::set<std::string> ours(old_files.begin(), old_files.end());
  const auto refuse = [&](const fs::path& path) {
    throw Error(
        (out / path).string() + ": is not of a run, and the result needs its place; move it away, then --resume",
        ExitCode::usage);
  };
  for (const std::string& name : new_files) {
    const fs::path file = name;
    fs::path folder;
    for (const fs::path& part : file.parent_path()) {
      folder /= part;
      const fs::file_status status = fs::symlink_status(out / folder);
      if (fs::exists(status) && !fs::is_directory(status) && !ours.contains(folder.generic_string())) refuse(folder);
    }
    const fs::file_status status = fs::symlink_status(out / file);
    const bool taken = fs::exists(status) && !ours.contains(name) && !have_same_content(out / file, out / kNew / file);
    if (fs::is_directory(status) || taken) refuse(file);
  }
}

void swap_result(const fs::path& out, const std::vector<std::string>& old_files) {
  const fs::path made = out / kNew;
  const std::vector<std::string> new_files = product_files(made);
  const std::set<std::string> staying(new_files.begin(), new_files.end());
  std::vector<std::string> going;
  for (const std::string& name : old_files)
    if (!staying.contains(name)) going.push_back(name);
  write_whole_file(made / kGoing, list_text(going));
  flush_all(made);
  fs::rename(made, out / kSwap);
  flush(out);
  finish_swap(out);
}

void finish_swap(const fs::path& out) {
  const fs::path swap = out / kSwap;
  if (!fs::exists(swap)) return;
  try {
    if (fs::exists(swap / kRunJson)) move_in(swap, out);
    fs::remove_all(swap);
  } catch (const fs::filesystem_error& fault) {
    throw Error(out.string() + ": the result is whole in " + swap.string() + " but cannot be moved into its place: " +
                fault.code().message() + " (" + fault.path1().string() + "); mend this, then --resume");
  }
}

}  // namespace ilot
