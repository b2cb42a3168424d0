// SPDX-License-Identifier: Apache-2.0
// How a text file writes its numbers: the separator of numbers, the decimal mark, and the mark that groups thousands.
// Text, PTS and PTX use this; PLY and PCD have a fixed form.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ilot/cloud_info.h"

namespace ilot {

constexpr std::size_t kMostShownColumns = 1001;  // of a row that is looked at to find the dialect

// Returns a text for people: "separated by semicolons, decimal comma".
std::string description_of(const TextDialect& dialect);

// Returns the words for --text-dialect; dialect_of_words (ilot/cloud_info.h) is the reverse.
std::string words_of(const TextDialect& dialect);

// Splits a line. Quotes around a field are removed, and a separator at the end of the line begins no field. When commas
// are both separators and decimal marks, every second comma of a line without quotes separates. Stops after `most`
// fields.
void split_row(std::string_view line, const TextDialect& dialect, std::size_t most,
               std::vector<std::string_view>& fields);

// True when the whole field is a number of the dialect.
bool parse_number(std::string_view field, const TextDialect& dialect, double& value);

// Splits and parses a line; false unless it has exactly values.size() numbers.
bool parse_row(std::string_view line, const TextDialect& dialect, std::vector<std::string_view>& fields,
               std::span<double> values);

// Returns the number of digits behind the decimal mark without trailing zeros, with the exponent taken into account; 0
// for nan and inf.
int decimals_of(std::string_view field, const TextDialect& dialect);

// True when the line could be a row of numbers in some dialect.
bool looks_like_numbers(std::string_view line);

struct FoundDialect {
  TextDialect dialect;
  std::size_t columns = 0;  // of most rows; 0: no row consists of numbers
};

// Returns how many numbers most rows have in this dialect, at least three; 0 when no row has.
std::size_t columns_of_most(std::span<const std::string> rows, const TextDialect& dialect);

// Finds the dialect in which most of these rows have the same count (at least three) of numbers. `names` is the number
// of columns that a header names, 0 = no header; a dialect with this count is preferred. `counts` are the numbers of
// columns that may be mixed (PTX); empty: all rows have the same. A decimal point is never taken as a mark of
// thousands, unless a number has two of them or a comma behind it. Throws Error with ExitCode::usage, whose text begins
// with `place`, when two dialects give different numbers or the rows are written in two ways. The text shows both
// readings and how to choose.
FoundDialect find_dialect(std::span<const std::string> rows, std::size_t names, std::span<const std::size_t> counts,
                          const std::string& place);

}  // namespace ilot
