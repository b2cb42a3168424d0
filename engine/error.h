// SPDX-License-Identifier: Apache-2.0
// What ends a run: thrown with a sentence that says what, where and what to do. Only main catches it.
#pragma once
#include <stdexcept>
#include <string>

namespace ilot {

enum class ExitCode { ok = 0, failed = 1, usage = 2, incomplete = 3, interrupted = 130 };

class Error : public std::runtime_error {
 public:
  explicit Error(const std::string& sentence, ExitCode code = ExitCode::failed)
      : std::runtime_error(sentence), code_(code) {}
  ExitCode code() const { return code_; }

 private:
  ExitCode code_;
};

}  // namespace ilot
