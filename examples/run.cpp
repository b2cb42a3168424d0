// SPDX-License-Identifier: Apache-2.0
// A whole run: planes, roofs and streets of a cloud, with its progress.
// Usage: run CLOUD FOLDER [PRODUCT...]
#include <ilot/run.h>

#include <cstdio>

int main(int argc, char** argv) try {
  if (argc < 3) return 2;
  ilot::RunOptions options;
  options.inputs = {argv[1]};
  options.output = argv[2];
  options.products = {"planes", "roofs", "streets"};
  if (argc > 3) options.products.assign(argv + 3, argv + argc);
  options.settings.planes.epsilon = 0.03;
  options.memory_bytes = std::uint64_t{512} << 20;
  options.existing = ilot::Existing::overwrite;
  ilot::RunCallbacks callbacks;
  callbacks.progress = [](const ilot::RunProgress& at) {
    std::printf("%6.1f s  %s: %llu of %llu\n", at.seconds, at.stage.c_str(),
                static_cast<unsigned long long>(at.points_done), static_cast<unsigned long long>(at.points_total));
  };
  const ilot::RunReport report = ilot::run(options, callbacks);
  std::printf("%llu points, %llu labelled, %zu files, %.1f s\n", static_cast<unsigned long long>(report.points_read),
              static_cast<unsigned long long>(report.points_labelled), report.files.size(), report.seconds);
  for (const ilot::SkippedRecord& s : report.skipped)
    std::printf("skipped: %s: %s\n", s.where.c_str(), s.reason.c_str());
  return report.exit == ilot::ExitCode::ok && report.points_labelled > 0 ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
