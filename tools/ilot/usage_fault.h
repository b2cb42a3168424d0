// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <CLI/CLI.hpp>
#include <string>

namespace ilot {

// Returns the message for a command line that cannot be read: what is wrong with it, what was probably meant, and which
// help to ask for.
std::string usage_fault(const CLI::App& app, const CLI::ParseError& fault);

// Returns the names of the visible commands, in their order.
std::vector<std::string> command_names(const CLI::App& app);

// Returns the options of a command that have a name with two dashes, in their order.
std::vector<std::string> option_names(const CLI::App& command);

}  // namespace ilot
