// SPDX-License-Identifier: Apache-2.0
// The one exception of the library. Its text is a sentence for people that says what is wrong, where, and what to do;
// its code says what a program should end with. No function of the library prints, exits or calls std::terminate.
//
// Every function in include/ilot/ may throw it, and std::bad_alloc. After an exception nothing is half written: files
// appear whole under their names or not at all.
//
//   try {
//     ilot::apply_assignment(settings, "planes.epsilon=-1");
//   } catch (const ilot::Error& fault) {
//     std::fprintf(stderr, "%s\n", fault.what());
//     return static_cast<int>(fault.code());
//   }
#pragma once
#include <stdexcept>
#include <string>

namespace ilot {

enum class ExitCode {
  ok = 0,
  failed = 1,         // a file is damaged, the disk is full, no point is left
  usage = 2,          // what was asked for cannot be: a wrong value, a missing file
  incomplete = 3,     // done, but something was skipped
  try_again = 75,     // a task of a plan: the machine was at fault, not what was asked for
  interrupted = 130,  // stopped on request; a run can be resumed
};

class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence, ExitCode code = ExitCode::failed)
      : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace ilot
