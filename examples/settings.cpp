// SPDX-License-Identifier: Apache-2.0
// Lists the settings of planes, changes one, and shows what a wrong value says.
#include <ilot/error.h>
#include <ilot/parameters.h>
#include <ilot/settings.h>
#include <ilot/version.h>

#include <cstdio>

int main() try {
  std::printf("ilot %s\n", ilot::version().c_str());
  ilot::Settings settings;
  ilot::apply_assignment(settings, "planes.epsilon=0.02");
  for (const ilot::Parameter& p : ilot::parameters()) {
    if (!p.key.starts_with("planes.")) continue;
    std::printf("%s = %s (%s): %s\n", p.key.c_str(), ilot::to_text(p.get(settings)).c_str(),
                ilot::range_text(p).c_str(), p.help.c_str());
  }
  bool refused = false;
  try {
    ilot::apply_assignment(settings, "planes.epsilon=-1");
  } catch (const ilot::Error& fault) {
    std::printf("refused: %s\n", fault.what());
    refused = fault.code() == ilot::ExitCode::usage;
  }
  return refused && settings.planes.epsilon == 0.02 ? 0 : 1;
} catch (const ilot::Error& fault) {
  std::fprintf(stderr, "%s\n", fault.what());
  return static_cast<int>(fault.code());
}
