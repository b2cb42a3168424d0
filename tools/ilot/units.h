// SPDX-License-Identifier: Apache-2.0
// Option values that need more than a number parser. Faults are thrown as Error with ExitCode::usage, and the message
// names the option.
#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "engine/formats/reader.h"

namespace ilot {

// Parses "2G", "1.5 GiB", "268435456" or "512MB". K, M, G and T are powers of 1024, whatever letters follow them.
std::uint64_t parse_bytes(const std::string& option, const std::string& text);

// Returns a code such as "EPSG:2154" in this spelling, from upper or lower case. Returns an empty string for an empty
// one.
std::string parse_crs(const std::string& option, const std::string& text);

// Adds --text-dialect, the format that readers assume. If it is empty, readers find the format from the rows.
void add_dialect_option(CLI::App& command, std::string& dialect);
OpenOptions open_options(const std::string& dialect);

}  // namespace ilot
