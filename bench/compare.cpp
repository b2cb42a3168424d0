// SPDX-License-Identifier: Apache-2.0
#include "bench/compare.h"

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <ctime>
#include <nlohmann/json.hpp>

#include "bench/ceiling/score_loop.h"
#include "kernels/core/parallel.h"
#include "kernels/simd/variants.h"

namespace ilot::bench {
namespace {

using Seconds = std::vector<double>;

double now() {
  const char* clock = std::getenv("ILOT_BENCH_CLOCK");
  if (clock != nullptr && std::string(clock) == "cpu") return static_cast<double>(std::clock()) / CLOCKS_PER_SEC;
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

double seconds_of(const std::function<void()>& run) {
  const double start = now();
  run();
  return now() - start;
}

double budget() {
  const char* seconds = std::getenv("ILOT_BENCH_SECONDS");
  return seconds != nullptr ? std::atof(seconds) : 5;
}

double median(Seconds v) {
  std::sort(v.begin(), v.end());
  return v.size() % 2 == 1 ? v[v.size() / 2] : (v[v.size() / 2 - 1] + v[v.size() / 2]) / 2;
}

double median_ratio(const Seconds& a, const Seconds& b) {
  Seconds ratios;
  for (std::size_t i = 0; i < a.size(); ++i) ratios.push_back(a[i] / b[i]);
  return median(ratios);
}

// Returns times[way][round]. The first round warms up and is not counted, unless there is only one round.
std::vector<Seconds> rounds_of(const std::vector<Way>& ways, int fewest) {
  constexpr int kMost = 25;
  std::vector<Seconds> times(ways.size());
  double spent = 0;
  for (int round = fewest == 1 ? 1 : 0; round <= fewest || (fewest > 1 && spent < budget() && round <= kMost);
       ++round) {
    for (std::size_t w = 0; w < ways.size(); ++w) {
      const double t = seconds_of(ways[w].run);
      spent += t;
      if (round > 0) times[w].push_back(t);
    }
  }
  return times;
}

nlohmann::ordered_json head(const Subject& s) {
  return {
      {"kernel", s.kernel}, {"variant", s.variant}, {"threads", s.threads}, {"isa", simd::name_of(simd::chosen_isa())}};
}

void print(const nlohmann::ordered_json& line) {
  std::printf("%s\n", line.dump().c_str());
  std::fflush(stdout);
}

}  // namespace

void compare(const Subject& subject, const std::vector<Way>& ways) {
  std::vector<Seconds> times;
  with_threads(subject.threads, [&] { times = rounds_of(ways, subject.rounds); });
  nlohmann::ordered_json line = head(subject), rows = nlohmann::json::array();
  for (std::size_t w = 0; w < ways.size(); ++w) {
    const double seconds = median(times[w]);
    rows.push_back({{"name", ways[w].name},
                    {"seconds", seconds},
                    {"rate", subject.items / seconds},
                    {"ratio", median_ratio(times[w], times[0])}});
  }
  line["unit"] = subject.unit + "/s";
  line["rounds"] = times[0].size();
  line["rows"] = rows;
  print(line);
}

void scaling(const Subject& subject, const std::function<void()>& run) {
  const auto in_arena = [](int threads, const std::function<void()>& body) {
    return [threads, body] { with_threads(threads, body); };
  };
  const auto loop = [] { score_loop(1e9); };
  const auto times = rounds_of(
      {{"loop 1", in_arena(1, loop)}, {"1", in_arena(1, run)}, {"2", in_arena(2, run)}, {"loop 2", in_arena(2, loop)}},
      subject.rounds);
  Seconds shares;
  for (std::size_t i = 0; i < times[0].size(); ++i)
    shares.push_back((times[1][i] / times[2][i]) / (times[0][i] / times[3][i]));
  nlohmann::ordered_json line = head(subject);
  line["threads"] = 2;
  line["scaling"] = median_ratio(times[1], times[2]);
  line["loop_scaling"] = median_ratio(times[0], times[3]);
  line["share"] = median(shares);
  line["rounds"] = shares.size();
  print(line);
}

void report(const Subject& subject, const std::vector<std::pair<std::string, double>>& figures) {
  nlohmann::ordered_json line = head(subject), values;
  for (const auto& [name, value] : figures) values[name] = value;
  line["figures"] = values;
  print(line);
}

void require(bool condition, const std::string& what) {
  if (condition) return;
  std::fprintf(stderr, "bench: %s\n", what.c_str());
  std::exit(1);
}

std::vector<double> numbers(int argc, char** argv, std::vector<double> otherwise) {
  if (argc < 2) return otherwise;
  std::vector<double> sizes;
  for (int i = 1; i < argc; ++i) {
    sizes.push_back(std::atof(argv[i]));
    require(sizes.back() > 0, std::string("'") + argv[i] + "' is not a positive number");
  }
  return sizes;
}

std::string in_millions(double n) {
  std::string digits = std::to_string(n);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits + " M points";
}

}  // namespace ilot::bench
