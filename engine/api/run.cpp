// SPDX-License-Identifier: Apache-2.0
#include "ilot/run.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <mutex>
#include <nlohmann/json.hpp>
#include <thread>

#include "engine/error.h"
#include "engine/pass/stop.h"
#include "engine/report/progress.h"
#include "engine/run/inputs/inputs.h"
#include "engine/run/products.h"
#include "engine/run/run.h"

namespace ilot {
namespace {

constexpr std::chrono::milliseconds kTick{200};
constexpr double kSecondsBetween = 1;
constexpr std::uint64_t kLeastMemory = std::uint64_t{96} << 20;

double seconds_now() {
  return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}

bool stop_asked(const RunCallbacks& callbacks) {
  return callbacks.stop != nullptr && callbacks.stop->load(std::memory_order_relaxed);
}

// Waits until no other run is at work.
std::unique_lock<std::timed_mutex> wait_for_turn(const RunCallbacks& callbacks) {
  static std::timed_mutex one_at_a_time;
  std::unique_lock lock(one_at_a_time, std::defer_lock);
  while (!lock.try_lock_for(kTick))
    if (stop_asked(callbacks) || stop_requested())
      throw Error("interrupted while it waited for another run; nothing was begun", ExitCode::interrupted);
  return lock;
}

// What the engine tells, as calls of the user's functions: one at a time.
class Teller {
 public:
  explicit Teller(const RunCallbacks& callbacks) : callbacks_(callbacks), start_(seconds_now()) {}

  ProgressOptions options() {
    ProgressOptions options;
    if (callbacks_.message)
      options.console = [this](std::string_view text) {
        const std::lock_guard lock(mutex_);
        callbacks_.message(text);
        obey();
      };
    if (callbacks_.progress) options.events = [this](std::string_view text) { event(text); };
    return options;
  }

  // Where the current stage is, when a second has gone by.
  void tick(const Progress& progress) {
    const std::lock_guard lock(mutex_);
    obey();
    if (!callbacks_.progress || state_.stage.empty() || seconds_now() - last_ < kSecondsBetween) return;
    state_.points_done = progress.done();
    tell();
  }

 private:
  void event(std::string_view text) {
    const nlohmann::json event = nlohmann::json::parse(text, nullptr, false);
    const std::string name = event.value("event", "");
    const std::lock_guard lock(mutex_);
    if (name == "stage_start") {
      state_.stage = event.value("stage", "");
      state_.points_done = 0;
      state_.points_total = event.value("total", std::uint64_t{0});
      tell();
    } else if (name == "stage_done") {
      state_.points_done = event.value("points", std::uint64_t{0});
      tell();
      state_.stage.clear();
    }
  }

  void tell() {
    last_ = seconds_now();
    state_.seconds = last_ - start_;
    callbacks_.progress(state_);
    obey();
  }

  // Hands the caller's request to stop this run on to its passes.
  void obey() const {
    if (stop_asked(callbacks_)) stop_this_run();
  }

  const RunCallbacks& callbacks_;
  double start_, last_ = 0;
  RunProgress state_;
  std::mutex mutex_;
};

// Calls tick() until it goes.
class Timer {
 public:
  explicit Timer(std::function<void()> tick)
      : thread_([this, tick = std::move(tick)] {
          std::unique_lock lock(mutex_);
          while (!wake_.wait_for(lock, kTick, [this] { return finished_; })) tick();
        }) {}
  ~Timer() {
    {
      const std::lock_guard lock(mutex_);
      finished_ = true;
    }
    wake_.notify_all();
    thread_.join();
  }
  Timer(const Timer&) = delete;
  Timer& operator=(const Timer&) = delete;

 private:
  std::mutex mutex_;
  std::condition_variable wake_;
  bool finished_ = false;
  std::thread thread_;
};

std::string known_products() {
  std::string text;
  for (const Product* product : all_products()) text += (text.empty() ? "" : ", ") + std::string(product->name);
  return text;
}

// As the command line hands them to the engine: files for inputs, products once and in order.
RunOptions checked(RunOptions options) {
  if (options.inputs.empty() && options.arrays.empty()) throw Error("run: no inputs are given", ExitCode::usage);
  if (options.output.empty()) throw Error("run: no output folder is given", ExitCode::usage);
  if (options.memory_bytes < kLeastMemory) throw Error("run: memory_bytes: at least 96 MiB", ExitCode::usage);
  if (options.threads < 0 || options.threads > 1024) throw Error("run: threads: 0 to 1024", ExitCode::usage);
  if (options.area)
    for (const double v : {options.area->min_x, options.area->min_y, options.area->max_x, options.area->max_y})
      if (!std::isfinite(v)) throw Error("run: area: a coordinate is not finite", ExitCode::usage);
  for (const std::string& name : options.products) {
    const auto list = all_products();
    if (std::none_of(list.begin(), list.end(), [&](const Product* p) { return name == p->name; }))
      throw Error("run: there is no product " + name + "; there is: " + known_products(), ExitCode::usage);
  }
  std::sort(options.products.begin(), options.products.end());
  options.products.erase(std::unique(options.products.begin(), options.products.end()), options.products.end());
  std::vector<std::string> inputs;
  for (const std::filesystem::path& input : options.inputs) inputs.push_back(input.string());
  if (!inputs.empty()) options.inputs = expand_inputs(inputs);
  return options;
}

}  // namespace

RunReport run(const RunOptions& options, const RunCallbacks& callbacks) {
  const std::unique_lock lock = wait_for_turn(callbacks);
  const RunAtWork at_work;
  const RunOptions given = checked(options);
  Teller teller(callbacks);
  Progress progress(teller.options());
  int code = 0;
  {
    const Timer timer([&] {
      progress.tick();
      teller.tick(progress);
    });
    code = run(given, progress);
  }
  if (!given.dry_run) return read_run(given.output);
  RunReport report;
  report.folder = given.output;
  report.exit = static_cast<ExitCode>(code);
  return report;
}

}  // namespace ilot
