// SPDX-License-Identifier: Apache-2.0
// Values of options that need more than a number parser. Faults are Errors with ExitCode::usage that name the
// option.
#pragma once
#include <CLI/CLI.hpp>
#include <cstdint>
#include <string>

#include "engine/formats/reader.h"

namespace ilot {

// "2G", "1.5 GiB", "268435456", "512MB": K, M, G and T are powers of 1024, whatever stands behind them.
std::uint64_t parse_bytes(const std::string& option, const std::string& text);

// "EPSG:2154" in that spelling, from any case; empty for empty.
std::string parse_crs(const std::string& option, const std::string& text);

// --text-dialect, and what it asks of readers; empty: found from the rows.
void add_dialect_option(CLI::App& command, std::string& dialect);
OpenOptions open_options(const std::string& dialect);

}  // namespace ilot
