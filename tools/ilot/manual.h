// SPDX-License-Identifier: Apache-2.0
// The manual page and the completion of shells, from the same tables as --help.
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace ilot {

// Returns the manual page of the whole program in the language of man (groff's man macros).
std::string manual_page(const CLI::App& app);

std::string bash_completion(const CLI::App& app);
std::string zsh_completion(const CLI::App& app);
std::string fish_completion(const CLI::App& app);

}  // namespace ilot
