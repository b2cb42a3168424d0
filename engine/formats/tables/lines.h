// SPDX-License-Identifier: Apache-2.0
// Lines of a file of any size in bounded memory, and the fields of a line.
#pragma once
#include <cstddef>
#include <cstdint>
#include <string_view>
#include <vector>

#include "engine/formats/file.h"

namespace ilot {

// Hands out lines without their end (LF or CR LF). Of a line longer than 64 KiB only the beginning is given. The file
// must outlive the reader; one thread.
class LineReader {
 public:
  LineReader(const InputFile& file, std::uint64_t offset) : file_(&file), next_(offset) {}

  // False at the end of the file. The line is valid until the next call.
  bool next(std::string_view& line);

  // Where the line after the last one begins.
  std::uint64_t offset() const { return next_ - (end_ - begin_); }

  // Gives the buffer back, 1 MiB; the next line takes a new one.
  void release();

 private:
  bool fill();

  const InputFile* file_;
  std::uint64_t next_;  // place in the file behind the buffer
  std::vector<char> buffer_;
  std::size_t begin_ = 0, end_ = 0;
};

// Splits at blanks, tabs, commas and semicolons. Two commas (or semicolons) in a row enclose an empty field. Quotes
// around a field are removed. Stops at `most` fields.
void split_fields(std::string_view line, std::size_t most, std::vector<std::string_view>& fields);

// True when the whole text is a number as C writes it (a leading plus, nan and inf included).
bool parse_number(std::string_view text, double& value);

}  // namespace ilot
