// SPDX-License-Identifier: Apache-2.0
// Reads lines of a file of any size in bounded memory, and splits a line into fields.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/formats/file.h"

namespace ilot {

// Gives lines without their end (LF or CR LF). Of a line longer than 64 KiB only the beginning is given. The file must
// outlive the reader; for one thread.
class LineReader {
 public:
  LineReader(const InputFile& file, std::uint64_t offset) : file_(&file), next_(offset) {}

  // False at the end of the file. The line is valid until the next call.
  bool next(std::string_view& line);

  // Returns the place where the next line begins.
  std::uint64_t offset() const { return next_ - (end_ - begin_); }

  // Frees the buffer of 1 MiB; the next line allocates a new one.
  void release();

 private:
  bool fill();

  const InputFile* file_;
  std::uint64_t next_;  // place in the file behind the buffer
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
};

// True for the characters between fields of a line, except commas and semicolons.
inline bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\v' || c == '\f';
}

// Splits at blanks, tabs, commas and semicolons. Two consecutive commas (or semicolons) enclose an empty field. Quotes
// around a field are removed. Stops after `most` fields.
void split_fields(std::string_view line, std::size_t most, std::vector<std::string_view>& fields);

// True when the whole text is a number in C syntax (a leading plus, nan and inf included).
bool parse_number(std::string_view text, double& value);

}  // namespace ilot
