// SPDX-License-Identifier: Apache-2.0
// A new result takes the place of an older one when it is whole, and of nothing else.
//
// The new files are made in OUT/.new. The one rename of this folder to OUT/.swap decides: before it the old result is
// the result, after it the new one. What follows (old files go, new ones move in, run.json last) may be cut short at
// any instant and is finished by whoever comes next.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace ilot {

// Paths are relative to OUT. Throws a usage Error when a file or link that is not among `old_files` has the place of a
// new one in OUT/.new: it is somebody's own, unless its content is the same.
void check_places(const std::filesystem::path& out, const std::vector<std::string>& old_files,
                  const std::vector<std::string>& new_files);

// Replaces the files of the old result by all that is in OUT/.new, run.json included. Everything is on the disk itself
// before it counts.
void swap_result(const std::filesystem::path& out, const std::vector<std::string>& old_files);

// Finishes a swap that was cut short; does nothing when there is none.
void finish_swap(const std::filesystem::path& out);

// The paths that are inside of OUT and not hidden; a run.json that was changed by hand must not name others.
bool is_inside(const std::filesystem::path& relative);

}  // namespace ilot
