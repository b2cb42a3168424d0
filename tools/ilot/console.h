// SPDX-License-Identifier: Apache-2.0
// Where words leave the program: lines for people on standard error, results on standard output, events on a
// log.
#pragma once
#include <memory>
#include <string>
#include <string_view>

#include "engine/report/progress.h"

namespace ilot {

// Standard error, as it is; a closed or full one is ignored.
void say(std::string_view text);

// Standard output. Error when it cannot be written.
void print(std::string_view text);

// The text as one line: control characters are blanks, and the line ends.
std::string one_line(std::string text);

// Progress on the console and, if asked for, as JSON lines on `log`: a file (replaced), `-` for standard
// error or `fd:N` for an open descriptor. A timer keeps the line alive. One live line on a terminal; NO_COLOR
// is respected.
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
