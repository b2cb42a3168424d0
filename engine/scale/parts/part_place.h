// SPDX-License-Identifier: Apache-2.0
// Where parts are: in PLAN/parts, or in an object store.
#pragma once
#include <cstdint>
#include <filesystem>

#include "engine/scale/plan.h"

namespace ilot {

// The folder or the prefix of names of the parts of a plan.
std::filesystem::path parts_of(const Plan& plan, const std::filesystem::path& plan_folder);

// Throws Error where an object store does not say so.
bool part_exists(const std::filesystem::path& part);

// Brings a finished file of this machine to its place, whole or not at all. Into a folder it is renamed.
void publish_part(const std::filesystem::path& made, const std::filesystem::path& part);

// Gives a part a second place: as a second name of the same file where this is possible. `spare` is a name for a copy
// on the way between stores.
void copy_part(const std::filesystem::path& from, const std::filesystem::path& to, const std::filesystem::path& spare);

}  // namespace ilot
