// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <string>

#include "engine/error.h"
#include "engine/formats/las.h"

namespace ilot {
namespace {

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  std::transform(extension.begin(), extension.end(), extension.begin(),
                 [](unsigned char c) { return c < 128 ? static_cast<char>(std::tolower(c)) : static_cast<char>(c); });
  return extension;
}

std::unique_ptr<PointReader> open_las_family(std::unique_ptr<InputFile> file) {
  LasContainer container = parse_las(*file);
  if (container.compressed) throw Error(file->path().string() + ": LAZ is not supported yet; decompress it to LAS");
  return open_las(std::move(file), std::move(container));
}

}  // namespace

bool is_cloud_extension(const std::filesystem::path& path) {
  constexpr std::array<const char*, 2> kExtensions{".las", ".laz"};
  return std::find(kExtensions.begin(), kExtensions.end(), lower_extension(path)) != kExtensions.end();
}

std::unique_ptr<PointReader> open_cloud(const std::filesystem::path& path) {
  auto file = std::make_unique<InputFile>(path);
  return open_las_family(std::move(file));
}

std::unique_ptr<PointWriter> create_cloud(const std::filesystem::path& path, const CloudSpec& spec) {
  const std::string extension = lower_extension(path);
  if (extension == ".las") return create_las(path, spec);
  throw Error(path.string() + ": format " + extension + " is not written; choose .las", ExitCode::usage);
}

}  // namespace ilot
