// SPDX-License-Identifier: Apache-2.0
#include "engine/report/progress.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <nlohmann/json.hpp>

#include "engine/report/counted.h"
#include "engine/report/resources.h"

namespace ilot {
namespace {

constexpr double kLineSeconds = 10;
constexpr double kDrawSeconds = 0.1;
constexpr std::size_t kBarWidth = 20;  // Choice: letters; the line fits into 80 with the longest count.
// Choice: the expected end follows a new estimate within five seconds, so that the time left does not jump.
constexpr double kSettleSeconds = 5;
// Choice: before a fiftieth is done, the time left says nothing.
constexpr double kLeastShare = 0.02;
// Choice: what took less time gives no rate that says anything.
constexpr double kLeastRateSeconds = 0.1;

using Fields = std::vector<std::pair<std::string, std::string>>;

std::string duration(double seconds) {
  const auto whole = static_cast<std::uint64_t>(std::max(0.0, seconds) + 0.5);
  if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
  return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

// Empty where there is nothing to divide, or no time to divide it by.
std::string rate_text(std::uint64_t points, double seconds) {
  if (points == 0 || seconds < kLeastRateSeconds) return {};
  return ", " + grouped(static_cast<std::uint64_t>(static_cast<double>(points) / seconds)) + " points/s";
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

double Progress::stage_share() const {
  const std::uint64_t done = done_.load(std::memory_order_relaxed);
  return total_ == 0 ? 0 : static_cast<double>(std::min(done, total_)) / static_cast<double>(total_);
}

double Progress::overall_share() const {
  double before = 0, all = 0;
  for (std::size_t i = 0; i < plan_.size(); ++i) {
    all += plan_[i].seconds;
    if (i < planned_) before += plan_[i].seconds;
  }
  if (in_plan_) before += plan_[planned_].seconds * stage_share();
  return all > 0 ? before / all : 0;
}

// Returns the seconds until all stages are done; negative as long as they cannot be estimated.
double Progress::seconds_left() {
  const double share = overall_share(), time = options_.clock();
  if (share < kLeastShare) return -1;
  const double end = plan_start_ + (time - plan_start_) / share;
  const double weight = end_time_ < 0 ? 1 : std::min(1.0, (time - end_time_) / kSettleSeconds);
  end_ += weight * (end - end_);
  end_time_ = time;
  return std::max(0.0, end_ - time);
}

// Returns "5 of 13 buildings" or "1,000 of 4,000 points".
std::string Progress::count_text(std::uint64_t done) const {
  if (shown_.count == 0) return grouped(done) + (total_ > 0 ? " of " + grouped(total_) : "") + " " + shown_.noun;
  const auto seen = static_cast<std::uint64_t>(stage_share() * static_cast<double>(shown_.count));
  return grouped(seen) + " of " + grouped(shown_.count) + " " + shown_.noun;
}

std::string Progress::overall_text() {
  const double share = overall_share(), left = seconds_left();
  const auto full = static_cast<std::size_t>(share * kBarWidth);
  std::string text = "[" + std::string(full, '#') + std::string(kBarWidth - full, '-') + "]";
  text += fmt::format(" {:3.0f} %  ", 100 * share) + (options_.colour ? "\x1b[1m" + stage_ + "\x1b[0m" : stage_);
  text += ": " + count_text(done_.load(std::memory_order_relaxed));
  return left < 0 ? text : text + ", " + duration(left) + " left";
}

std::string Progress::stage_text() {
  if (!plan_.empty()) return overall_text();
  const std::uint64_t done = done_.load(std::memory_order_relaxed);
  const Rate r = rate();
  std::string text = options_.colour ? fmt::format("\x1b[1m{}\x1b[0m", stage_) : stage_;
  if (total_ > 0) text += fmt::format(" {:5.1f} %", 100 * stage_share());
  text += fmt::format(", {} points{}", grouped(done), rate_text(done, options_.clock() - stage_start_));
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

void Progress::plan(std::vector<PlannedStage> stages) {
  const std::lock_guard lock(mutex_);
  plan_ = std::move(stages);
  planned_ = 0;
  plan_start_ = options_.clock();
  end_time_ = -1;
}

void Progress::begin_stage(std::string_view name, std::uint64_t total_points, const ShownCount& shown) {
  const std::lock_guard lock(mutex_);
  end_stage_locked();
  shown_ = shown;
  const auto from = plan_.begin() + static_cast<std::ptrdiff_t>(planned_);
  const auto found = std::find_if(from, plan_.end(), [&](const PlannedStage& s) { return s.name == name; });
  in_plan_ = found != plan_.end();
  if (in_plan_) planned_ = static_cast<std::size_t>(found - plan_.begin());
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
  const bool points = shown_.count == 0;  // else their rate says nothing to people
  line(fmt::format("{}: {} {} in {:.1f} s{}", stage_, grouped(points ? record.points : shown_.count), shown_.noun,
                   record.seconds, points ? rate_text(record.points, record.seconds) : ""),
       options_.live && !plan_.empty() ? Verbosity::verbose : Verbosity::normal);
  if (in_plan_) ++planned_;
  in_plan_ = false;
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

void Progress::units_skipped(std::span<const std::string> units, std::string_view noun, std::string_view reason) {
  const std::lock_guard lock(mutex_);
  for (const std::string& unit : units)
    event("unit_skipped", {{"stage", json_quote(stage_)}, {"unit", json_quote(unit)}, {"msg", json_quote(reason)}});
  line(fmt::format("ilot: {} {} skipped: {}: {}", grouped(units.size()), noun, reason, first_names(units)),
       Verbosity::quiet);
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
