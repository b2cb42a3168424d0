// SPDX-License-Identifier: Apache-2.0
// Times several ways to the same answer in one process, in turn (A B C A B C ...), so that whatever else the machine
// does meets them alike. What counts is the median over the rounds of the ratios within a round.
// Each comparison prints one line of JSON; bench/run collects them.
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
  std::string kernel = {};   // the kernel's one name, e.g. "normals"
  std::string variant = {};  // e.g. "k=16, 1 M points"
  int threads = 1;
  double items = 0;       // done by one run of any way
  std::string unit = {};  // of items, e.g. "M points"; items are given in it
  int rounds = 3;         // at least; 1 = one, and no warming up: for what takes minutes
};

// Runs the ways in an arena of subject.threads threads. The first way is ours: ratios are how many times longer the
// others take. At least subject.rounds rounds, more while ILOT_BENCH_SECONDS [5] last. ILOT_BENCH_CLOCK=cpu counts
// processor time instead of time on the wall: for one thread on a machine that is not alone.
void compare(const Subject& subject, const std::vector<Way>& ways);

// How much faster two threads are than one, and as what share of the register loop's own scaling, measured in the same
// rounds. `run` is called inside arenas of one and of two threads.
void scaling(const Subject& subject, const std::function<void()>& run);

// Prints the same kind of line for figures that are no times: name and value pairs.
void report(const Subject& subject, const std::vector<std::pair<std::string, double>>& figures);

// Ends the program with a message on stderr unless the condition holds: answers are compared before any timing.
void require(bool condition, const std::string& what);

// The positive numbers on the command line; `otherwise` when there are none.
std::vector<double> numbers(int argc, char** argv, std::vector<double> otherwise);

std::string in_millions(double n);  // "1 M points", "0.2 M points"

}  // namespace ilot::bench
