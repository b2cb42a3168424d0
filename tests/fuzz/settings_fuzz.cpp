// SPDX-License-Identifier: Apache-2.0
// Reads any bytes as a file of settings, and their first line as an argument of --set. The settings are printed, and
// the printed text must give the same settings.
#include <cstdint>

#include "engine/error.h"
#include "engine/settings/config.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  Settings settings;
  try {
    apply_assignment(settings, text.substr(0, text.find('\n')));
  } catch (const Error&) {
  }
  try {
    load_config_text(settings, text, "fuzz.toml");
  } catch (const Error&) {
  }
  Settings again;
  load_config_text(again, print_config(settings), "printed.toml");
  if (settings_hash(again) != settings_hash(settings)) __builtin_trap();
  return 0;
}
