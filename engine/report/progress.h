// SPDX-License-Identifier: Apache-2.0
// What a run reports while it works: lines for people and events for programs. Both go to sinks that the caller owns,
// because library code prints nothing. Stages follow one another. advance() may be called from any thread.
#pragma once
#include <atomic>
#include <cstdint>
#include <functional>
#include <mutex>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ilot {

enum class Verbosity { quiet, normal, verbose };

struct ProgressOptions {
  Verbosity verbosity = Verbosity::normal;
  bool live = false;    // for a terminal: one line is rewritten in place; else one line every 10 s
  bool colour = false;  // the name of the stage is bold
  std::function<void(std::string_view)> console;  // text for people, newlines included; empty = silent
  std::function<void(std::string_view)> events;   // one JSON object and a newline; empty = none
  std::function<double()> clock;                  // monotonic seconds; empty = the steady clock
};

struct StageRecord {
  std::string name;
  double seconds = 0, cpu_seconds = 0;
  std::uint64_t points = 0;
};

// A stage that a run will have, with the seconds that it takes relative to the others.
struct PlannedStage {
  std::string name;
  double seconds = 0;
};

// What the work of a stage is counted in when it is shown: 13 buildings, whatever the number of points that are read
// for them.
struct ShownCount {
  std::uint64_t count = 0;
  std::string noun = "points";
};

class Progress {
 public:
  Progress() : Progress(ProgressOptions{}) {}  // silent, but still keeps the stage records
  explicit Progress(ProgressOptions options);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;

  void run_start(std::string_view message);
  void input_ok(std::string_view path, std::uint64_t points);
  void input_skipped(std::string_view path, std::string_view reason);  // writes a line too, even when quiet

  // The stages that will follow, in their order. From then on the share and the time that is left are those of all
  // stages. A planned stage that does not come is passed over.
  void plan(std::vector<PlannedStage> stages);

  // Names are those of run.json. A stage that is still open is ended first. total = 0: unknown, no percentage is shown.
  // advance() counts towards `total_points`; `shown` is what people see of it, the points themselves if there is none.
  void begin_stage(std::string_view name, std::uint64_t total_points, const ShownCount& shown = {});
  void advance(std::uint64_t points) { done_.fetch_add(points, std::memory_order_relaxed); }
  void end_stage();
  std::uint64_t done() const { return done_.load(std::memory_order_relaxed); }  // points of the stage

  // `done` of `total` units of the current stage are finished. The files of the unit have their final names when this
  // is called.
  void unit_done(std::string_view unit, std::uint64_t points, std::uint64_t done, std::uint64_t total);
  void unit_skipped(std::string_view unit, std::string_view reason);
  // Units with the same reason: an event for each, and one line that names the first three. `noun` is for example
  // "footprints are".
  void units_skipped(std::span<const std::string> units, std::string_view noun, std::string_view reason);

  // Writes the last line: points, wall seconds, peak memory, skipped inputs.
  void run_done(std::string_view message);

  void note(std::string_view sentence);  // one line, not when quiet
  void warn(std::string_view sentence);  // one line, always

  // Redraws the live line, or writes the line and the heartbeat event that are due every 10 s. A timer of the caller
  // calls it, so that a stall is visible too; it is cheap when nothing is due.
  void tick();

  // Removes the live line, if there is one. Called before other code writes to the console.
  void clear_line();

  std::vector<StageRecord> stages() const;

 private:
  struct Rate {
    double points_per_second = 0, eta_seconds = -1;
  };
  double now() const;
  Rate rate() const;
  double stage_share() const;
  double overall_share() const;
  double seconds_left();
  std::string count_text(std::uint64_t done) const;
  std::string overall_text();
  void end_stage_locked();
  void line(std::string_view text, Verbosity least);
  std::string stage_text();
  void event(std::string_view name, const std::vector<std::pair<std::string, std::string>>& fields);
  std::vector<std::pair<std::string, std::string>> stage_fields() const;

  ProgressOptions options_;
  mutable std::mutex mutex_;
  std::atomic<std::uint64_t> done_{0};
  std::uint64_t total_ = 0;
  std::string stage_, unit_;
  double start_ = 0, stage_start_ = 0, stage_cpu_ = 0, last_line_ = 0, last_draw_ = 0;
  bool live_shown_ = false;
  std::vector<StageRecord> stages_;
  ShownCount shown_;
  std::vector<PlannedStage> plan_;
  std::size_t planned_ = 0;                          // stages of the plan before the current one
  bool in_plan_ = false;                             // the current stage is plan_[planned_]
  double plan_start_ = 0, end_ = 0, end_time_ = -1;  // end_: when all is expected to be done, as of end_time_
};

// Returns for example 1,234,567.
std::string grouped(std::uint64_t number);

// Returns a JSON string literal of the text; bytes that are not UTF-8 become U+FFFD.
std::string json_quote(std::string_view text);

}  // namespace ilot
