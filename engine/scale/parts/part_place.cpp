// SPDX-License-Identifier: Apache-2.0
#include "engine/scale/parts/part_place.h"

#include <span>
#include <vector>

#include "engine/error.h"
#include "engine/formats/file.h"
#include "engine/formats/remote_file.h"

namespace ilot {
namespace {

namespace fs = std::filesystem;

void fetch(const fs::path& from, const fs::path& to) {
  const InputFile file(from);
  OutputFile copy(to);
  std::vector<std::byte> bytes(std::size_t{1} << 20);
  while (copy.position() < file.size()) {
    const std::size_t got = file.read_at(copy.position(), bytes);
    if (got == 0) throw Error(from.string() + ": ended while it was read");
    copy.append(std::span(bytes).first(got));
  }
  copy.commit();
}

}  // namespace

fs::path parts_of(const Plan& plan, const fs::path& plan_folder) {
  return plan.parts.empty() ? plan_folder / kPartsFolder : fs::path(plan.parts);
}

bool part_exists(const fs::path& part) {
  return is_remote(part) ? remote_exists(part) : fs::exists(part);
}

void publish_part(const fs::path& made, const fs::path& part) {
  if (!is_remote(part)) return fs::rename(made, part);
  put_remote(made, part);
  fs::remove(made);
}

void copy_part(const fs::path& from, const fs::path& to, const fs::path& spare) {
  std::error_code no_link;
  if (!is_remote(from) && !is_remote(to)) {
    fs::remove(to);  // of a plan that was not finished
    fs::create_hard_link(from, to, no_link);
    if (no_link) fs::copy_file(from, to);  // on another disk
    return;
  }
  fetch(from, spare);
  publish_part(spare, to);
}

}  // namespace ilot
