// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>
#include <string>

namespace ilot {

// The engines for which a script can be written: make, slurm, snakemake, dask, k8s.
std::span<const char* const> script_kinds();

// Returns the script with which an engine runs all tasks of a plan and merges them. Throws Error with ExitCode::usage
// for another kind, and for a folder whose name such scripts cannot hold.
std::string plan_script(const std::filesystem::path& folder, const std::string& kind);

}  // namespace ilot
