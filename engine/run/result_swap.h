// SPDX-License-Identifier: Apache-2.0
// Replaces an older result by a new one when the new one is complete, and replaces nothing else.
//
// The new files are made in OUT/.new. The rename of this folder to OUT/.swap is decisive: before it the old result is
// valid, after it the new one. The following steps (old files are removed, new ones are moved in, run.json last) may be
// interrupted at any time; the next run finishes them.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ilot {

// Paths are relative to OUT. Throws a usage Error when a file or link that is not among `old_files` is at the place of
// a new one in OUT/.new. It belongs to the user, unless its content is the same.
void check_places(const std::filesystem::path& out, const std::vector<std::string>& old_files,
                  const std::vector<std::string>& new_files);

// Replaces the files of the old result by everything in OUT/.new, run.json included. Everything is flushed to the disk
// before it becomes valid.
void swap_result(const std::filesystem::path& out, const std::vector<std::string>& old_files);

// Finishes a swap that was interrupted; does nothing when there is none.
void finish_swap(const std::filesystem::path& out);

// True for paths that are inside OUT and not hidden. A run.json that was edited by hand must not name others.
bool is_inside(const std::filesystem::path& relative);

}  // namespace ilot
