// SPDX-License-Identifier: Apache-2.0
// The output of the program: messages for people go to standard error, results to standard output, and events to a log.
#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "engine/report/progress.h"

namespace ilot {

// Writes the text to standard error without a change. A closed or full standard error is ignored.
void say(std::string_view text);

// Writes to standard output. Throws Error when this is not possible.
void print(std::string_view text);

// Returns the text as one line: control characters become blanks, and a line end is added.
std::string one_line(std::string text);

// Shows progress on the console and, if requested, writes it as JSON lines to `log`: a file (which is replaced), `-`
// for standard error, or `fd:N` for an open descriptor. A timer keeps the line up to date. On a terminal there is one
// live line. NO_COLOR is respected.
class ConsoleProgress {
 public:
  ConsoleProgress(Verbosity verbosity, const std::string& log);
  ~ConsoleProgress();
  Progress& get();

 private:
  class Descriptor;
  struct Parts;
  std::unique_ptr<Parts> parts_;
};

}  // namespace ilot
