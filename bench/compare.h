// SPDX-License-Identifier: Apache-2.0
// Times several implementations that give the same answer in one process, in turn (A B C A B C ...), so that other load
// on the machine affects all of them alike. The result is the median over the rounds of the ratios within a round.
// Each comparison prints one line of JSON. bench/run collects these lines.
#pragma once
#include <functional>
#include <string>
#include <utility>
#include <vector>

namespace ilot::bench {

struct Way {
  std::string name;
  std::function<void()> run;
};

struct Subject {
  std::string kernel = {};   // the only name of the kernel, e.g. "normals"
  std::string variant = {};  // e.g. "k=16, 1 M points"
  int threads = 1;
  double items = 0;       // items that one run of any implementation processes
  std::string unit = {};  // unit of items, e.g. "M points"
  int rounds = 3;         // at least; 1 = one round without warming up, for runs of minutes
};

// Runs the implementations in an arena of subject.threads threads. The first one is ours. A ratio states how many times
// longer another one takes. There are at least subject.rounds rounds, and more until ILOT_BENCH_SECONDS [5] have
// passed. ILOT_BENCH_CLOCK=cpu counts processor time instead of wall-clock time. Use it for one thread on a machine
// with other load.
void compare(const Subject& subject, const std::vector<Way>& ways);

// Prints how much faster two threads are than one, and the share of the register loop's own scaling that this is,
// measured in the same rounds. `run` is called inside arenas of one and of two threads.
void scaling(const Subject& subject, const std::function<void()>& run);

// Prints the same kind of line for figures that are not times, as pairs of name and value.
void report(const Subject& subject, const std::vector<std::pair<std::string, double>>& figures);

// Ends the program with a message on stderr unless the condition is true. Answers are compared before any timing.
void require(bool condition, const std::string& what);

// Returns the positive numbers on the command line, or `otherwise` when there are none.
std::vector<double> numbers(int argc, char** argv, std::vector<double> otherwise);

std::string in_millions(double n);  // "1 M points", "0.2 M points"

}  // namespace ilot::bench
