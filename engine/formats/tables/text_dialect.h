// SPDX-License-Identifier: Apache-2.0
// How a text file writes its numbers: what separates them, what separates whole digits from decimals, and what groups
// thousands. Text, PTS and PTX share this; PLY and PCD fix their own form.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "ilot/cloud_info.h"

namespace ilot {

// For people: "separated by semicolons, decimal comma".
std::string description_of(const TextDialect& dialect);

// For --text-dialect; back: dialect_of_words (ilot/cloud_info.h).
std::string words_of(const TextDialect& dialect);

// Splits a line; quotes around a field are removed, and a separator at the end of the line begins no field. With commas
// both as separators and as decimal points every second comma of a line without quotes separates. Stops at `most`.
void split_row(std::string_view line, const TextDialect& dialect, std::size_t most,
               std::vector<std::string_view>& fields);

// True when the whole field is a number of the dialect.
bool parse_number(std::string_view field, const TextDialect& dialect, double& value);

// Splits and parses; false unless there are exactly values.size() numbers.
bool parse_row(std::string_view line, const TextDialect& dialect, std::vector<std::string_view>& fields,
               std::span<double> values);

// Digits behind the decimal point that are not trailing zeros, an exponent taken into account; 0 for nan and inf.
int decimals_of(std::string_view field, const TextDialect& dialect);

// True when the line could be a row of numbers in some dialect.
bool looks_like_numbers(std::string_view line);

struct FoundDialect {
  TextDialect dialect;
  std::size_t columns = 0;  // of most rows; 0: no row is numbers
};

// How many numbers most rows have in this dialect, at least three; 0 when none has.
std::size_t columns_of_most(std::span<const std::string> rows, const TextDialect& dialect);

// The dialect in which the most of these rows are the same number (at least three) of numbers. `names`: how many
// columns a header names, 0 = there is none; a dialect with as many wins. `counts`: the numbers of columns that may
// come mixed (PTX); empty: all rows have the same. A decimal point is never taken for one between thousands, unless a
// number has two of them or a comma behind it. Throws Error of ExitCode::usage, which begins with `place`, when two
// dialects give different numbers or the rows are written in two ways: it shows both readings and how to choose.
FoundDialect find_dialect(std::span<const std::string> rows, std::size_t names, std::span<const std::size_t> counts,
                          const std::string& place);

}  // namespace ilot
