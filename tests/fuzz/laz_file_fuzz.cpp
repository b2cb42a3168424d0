// SPDX-License-Identifier: Apache-2.0
// Opens any bytes as a file of the LAS family and reads its first points.
#include <unistd.h>

#include <cstdio>
#include <string>

#include "engine/error.h"
#include "engine/formats/file.h"
#include "engine/formats/laz/laz.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  using namespace ilot;
  static const std::string path = "/dev/shm/ilot_laz_fuzz_" + std::to_string(getpid()) + ".laz";
  std::FILE* file = std::fopen(path.c_str(), "wb");
  if (!file) return 0;
  std::fwrite(data, 1, size, file);
  std::fclose(file);
  try {
    auto input = std::make_unique<InputFile>(path);
    LasContainer container = parse_las(*input);
    // Few bytes may hold any number of equal points: bounded here, where a run counts and reports.
    if (!container.compressed || container.info.declared_points > 20000) return 0;
    const auto reader = open_laz(std::move(input), std::move(container));
    std::vector<std::byte> records(100 * std::size_t{reader->info().layout.record_length});
    std::vector<std::uint8_t> valid(100);
    for (std::uint64_t first = 0; first < reader->info().points; first += 90) reader->read(first, records, valid);
  } catch (const Error&) {
  }
  return 0;
}
