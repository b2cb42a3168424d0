// SPDX-License-Identifier: Apache-2.0
#include "engine/report/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "engine/report/resources.h"

namespace ilot {
namespace {

constexpr double kLineSeconds = 10;
constexpr double kDrawSeconds = 0.1;

using Fields = std::vector<std::pair<std::string, std::string>>;

std::string duration(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::max(0.0, seconds) + 0.5);
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

}  // namespace

std::string grouped(std::uint64_t number) {
  std::string text = std::to_string(number);
  for (std::size_t at = text.size(); at > 3; at -= 3) text.insert(at - 3, 1, ',');
  return text;
}

std::string json_quote(std::string_view text) {
  return nlohmann::json(std::string(text)).dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

Progress::Progress(ProgressOptions options) : options_(std::move(options)) {
  if (!options_.clock) {
    options_.clock = [] {
      return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
    };
  }
  start_ = last_line_ = options_.clock();
}

double Progress::now() const {
  return options_.clock() - start_;
}

Progress::Rate Progress::rate() const {
  const double seconds = options_.clock() - stage_start_;
  const std::uint64_t done = done_.load(std::memory_order_relaxed);
  Rate rate;
  if (seconds > 0) rate.points_per_second = static_cast<double>(done) / seconds;
  if (rate.points_per_second > 0 && total_ >= done && total_ > 0) {
    rate.eta_seconds = static_cast<double>(total_ - done) / rate.points_per_second;
  }
  return rate;
}

// A live line is removed before other text, so that a line never starts in the middle of another.
void Progress::line(std::string_view text, Verbosity least) {
  if (!options_.console || options_.verbosity < least) return;
  options_.console(fmt::format("{}{}\n", live_shown_ ? "\r\x1b[K" : "", text));
  live_shown_ = false;
}

std::string Progress::stage_text() const {
  const std::uint64_t done = done_.load(std::memory_order_relaxed);
  const Rate r = rate();
  std::string text = options_.colour ? fmt::format("\x1b[1m{}\x1b[0m", stage_) : stage_;
  if (total_ > 0) text += fmt::format(" {:5.1f} %", 100.0 * static_cast<double>(std::min(done, total_)) / total_);
  text +=
      fmt::format(", {} points, {} points/s", grouped(done), grouped(static_cast<std::uint64_t>(r.points_per_second)));
  if (r.eta_seconds >= 0) text += ", " + duration(r.eta_seconds) + " left";
  return text;
}

void Progress::event(std::string_view name, const Fields& fields) {
  if (!options_.events) return;
  std::string text = fmt::format("{{\"t\": {:.3f}, \"event\": \"{}\"", now(), name);
  for (const auto& [key, value] : fields) text += fmt::format(", \"{}\": {}", key, value);
  options_.events(fmt::format("{}, \"rss_bytes\": {}}}\n", text, resident_bytes()));
}

Fields Progress::stage_fields() const {
  const Rate r = rate();
  Fields fields{{"stage", json_quote(stage_)},
                {"done", std::to_string(done_.load(std::memory_order_relaxed))},
                {"total", std::to_string(total_)},
                {"points_per_s", fmt::format("{:.0f}", r.points_per_second)},
                {"eta_s", r.eta_seconds < 0 ? "null" : fmt::format("{:.1f}", r.eta_seconds)}};
  if (!unit_.empty()) fields.insert(fields.begin() + 1, {"unit", json_quote(unit_)});
  return fields;
}

void Progress::run_start(std::string_view message) {
  const std::lock_guard lock(mutex_);
  event("run_start", {{"msg", json_quote(message)}});
  line(message, Verbosity::verbose);
}

void Progress::input_ok(std::string_view path, std::uint64_t points) {
  const std::lock_guard lock(mutex_);
  event("input_ok", {{"unit", json_quote(path)}, {"points", std::to_string(points)}});
  line(fmt::format("{}: {} points", path, grouped(points)), Verbosity::verbose);
}

void Progress::input_skipped(std::string_view path, std::string_view reason) {
  const std::lock_guard lock(mutex_);
  event("input_skipped", {{"unit", json_quote(path)}, {"msg", json_quote(reason)}});
  line(fmt::format("ilot: {}: skipped: {}", path, reason), Verbosity::quiet);
}

void Progress::begin_stage(std::string_view name, std::uint64_t total_points) {
  const std::lock_guard lock(mutex_);
  end_stage_locked();
  stage_ = name;
  unit_.clear();
  total_ = total_points;
  done_.store(0, std::memory_order_relaxed);
  stage_start_ = last_line_ = options_.clock();
  last_draw_ = 0;
  stage_cpu_ = cpu_seconds();
  event("stage_start", {{"stage", json_quote(stage_)}, {"total", std::to_string(total_)}});
}

void Progress::end_stage() {
  const std::lock_guard lock(mutex_);
  end_stage_locked();
}

void Progress::end_stage_locked() {
  if (stage_.empty()) return;
  StageRecord record{stage_, options_.clock() - stage_start_, cpu_seconds() - stage_cpu_,
                     done_.load(std::memory_order_relaxed)};
  event("stage_done", {{"stage", json_quote(stage_)},
                       {"points", std::to_string(record.points)},
                       {"points_per_s", fmt::format("{:.0f}", rate().points_per_second)}});
  line(fmt::format("{}: {} points in {:.1f} s, {} points/s", stage_, grouped(record.points), record.seconds,
                   grouped(static_cast<std::uint64_t>(rate().points_per_second))),
       Verbosity::normal);
  stages_.push_back(std::move(record));
  stage_.clear();
}

void Progress::unit_done(std::string_view unit, std::uint64_t points, std::uint64_t done, std::uint64_t total) {
  const std::lock_guard lock(mutex_);
  unit_ = unit;
  event("unit_done", {{"stage", json_quote(stage_)},
                      {"unit", json_quote(unit)},
                      {"points", std::to_string(points)},
                      {"done", std::to_string(done)},
                      {"total", std::to_string(total)}});
}

void Progress::unit_skipped(std::string_view unit, std::string_view reason) {
  const std::lock_guard lock(mutex_);
  event("unit_skipped", {{"stage", json_quote(stage_)}, {"unit", json_quote(unit)}, {"msg", json_quote(reason)}});
  line(fmt::format("ilot: {}: skipped: {}", unit, reason), Verbosity::quiet);
}

void Progress::run_done(std::string_view message) {
  const std::lock_guard lock(mutex_);
  end_stage_locked();
  event("run_done", {{"msg", json_quote(message)}});
  line(message, Verbosity::normal);
}

void Progress::note(std::string_view sentence) {
  const std::lock_guard lock(mutex_);
  line(fmt::format("ilot: {}", sentence), Verbosity::normal);
}

void Progress::warn(std::string_view sentence) {
  const std::lock_guard lock(mutex_);
  line(fmt::format("ilot: {}", sentence), Verbosity::quiet);
}

void Progress::tick() {
  const std::lock_guard lock(mutex_);
  if (stage_.empty()) return;
  const double time = options_.clock();
  const bool due = time - last_line_ >= kLineSeconds;
  if (due) {
    last_line_ = time;
    event("heartbeat", stage_fields());
    if (!options_.live) line(stage_text(), Verbosity::normal);
  }
  if (!options_.live || !options_.console || options_.verbosity < Verbosity::normal) return;
  if (time - last_draw_ < kDrawSeconds) return;
  last_draw_ = time;
  live_shown_ = true;
  options_.console("\r\x1b[K" + stage_text());
}

void Progress::clear_line() {
  const std::lock_guard lock(mutex_);
  if (live_shown_) options_.console("\r\x1b[K");
  live_shown_ = false;
}

std::vector<StageRecord> Progress::stages() const {
  const std::lock_guard lock(mutex_);
  return stages_;
}

}  // namespace ilot
