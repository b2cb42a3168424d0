// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/console.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <condition_variable>
#include <cstdlib>
#include <cstring>
#include <mutex>
#include <thread>

#include "engine/error.h"

namespace ilot {
namespace {

constexpr std::chrono::milliseconds kTick{200};

bool write_all(int descriptor, std::string_view text) {
  while (!text.empty()) {
    const ssize_t written = write(descriptor, text.data(), text.size());
    if (written < 0 && errno == EINTR) continue;
    if (written <= 0) return false;
    text.remove_prefix(static_cast<std::size_t>(written));
  }
  return true;
}

bool has_variable(const char* name) {
  const char* value = std::getenv(name);
  return value != nullptr && *value != '\0';
}

bool is_terminal() {
  const char* kind = std::getenv("TERM");
  return isatty(STDERR_FILENO) == 1 && kind != nullptr && std::strcmp(kind, "dumb") != 0;
}

// Opens a descriptor of our own for the log. Returns -1 for no log.
int open_log(const std::string& log) {
  if (log.empty()) return -1;
  int wanted = log == "-" ? STDERR_FILENO : -1;
  if (log.starts_with("fd:")) {
    const auto [end, code] = std::from_chars(log.data() + 3, log.data() + log.size(), wanted);
    if (code != std::errc() || end != log.data() + log.size() || wanted < 0) {
      throw Error("--log-json " + log + ": fd:N needs the number of an open descriptor", ExitCode::usage);
    }
  }
  const int opened = wanted >= 0 ? fcntl(wanted, F_DUPFD_CLOEXEC, 3)
                                 : open(log.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (opened < 0) throw Error("--log-json " + log + ": " + std::strerror(errno), ExitCode::usage);
  return opened;
}

ProgressOptions console_options(Verbosity verbosity, const std::string& log, int descriptor) {
  ProgressOptions options;
  options.verbosity = verbosity;
  options.live = is_terminal() && log != "-";
  options.colour = options.live && !has_variable("NO_COLOR");
  options.console = say;
  if (descriptor >= 0) {
    options.events = [descriptor](std::string_view text) { write_all(descriptor, text); };
  }
  return options;
}

}  // namespace

void say(std::string_view text) {
  write_all(STDERR_FILENO, text);
}

std::string one_line(std::string text) {
  for (char& c : text) {
    if (static_cast<unsigned char>(c) < 32 || c == 127) c = ' ';
  }
  return text + "\n";
}

void print(std::string_view text) {
  if (!write_all(STDOUT_FILENO, text)) throw Error(std::string("standard output: ") + std::strerror(errno));
}

class ConsoleProgress::Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() {
    if (number_ >= 0) close(number_);
  }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  int number() const { return number_; }

 private:
  int number_;
};

struct ConsoleProgress::Parts {
  Parts(Verbosity verbosity, const std::string& log_name)
      : log(open_log(log_name)), progress(console_options(verbosity, log_name, log.number())) {
    timer = std::thread([this] {
      std::unique_lock lock(mutex);
      while (!wake.wait_for(lock, kTick, [this] { return finished; })) progress.tick();
    });
  }
  ~Parts() {
    {
      const std::lock_guard lock(mutex);
      finished = true;
    }
    wake.notify_all();
    timer.join();
    progress.clear_line();
  }

  Descriptor log;
  Progress progress;
  std::mutex mutex;
  std::condition_variable wake;
  bool finished = false;
  std::thread timer;
};

ConsoleProgress::ConsoleProgress(Verbosity verbosity, const std::string& log)
    : parts_(std::make_unique<Parts>(verbosity, log)) {}
ConsoleProgress::~ConsoleProgress() = default;
Progress& ConsoleProgress::get() {
  return parts_->progress;
}

}  // namespace ilot
