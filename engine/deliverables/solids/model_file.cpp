// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/model_file.h"

#include <algorithm>
#include <cctype>
#include <fstream>
#include <iterator>

#include "engine/error.h"

namespace ilot {
namespace {

std::string read_text(const std::filesystem::path& path) {
  if (!std::filesystem::is_regular_file(path)) throw Error(path.string() + ": no such file", ExitCode::usage);
  std::ifstream file(path, std::ios::binary);
  std::string text{std::istreambuf_iterator<char>(file), {}};
  if (file.bad() || !file.is_open()) throw Error(path.string() + ": cannot be read");
  return text;
}

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return extension;
}

}  // namespace

bool is_model_file(const std::filesystem::path& path) {
  const std::string extension = lower_extension(path);
  return extension == ".obj" || extension == ".jsonl" ||
         (extension == ".json" && lower_extension(path.stem()) == ".city");
}

ModelFile read_models(const std::filesystem::path& path, const ModelReading& wanted) {
  const std::string extension = lower_extension(path);
  if (extension == ".obj") return parse_obj(read_text(path), path.string(), path.stem().string());
  if (extension == ".json" || extension == ".jsonl") return parse_city_json(read_text(path), path.string(), wanted);
  throw Error(path.string() + ": not a model that can be read: .obj, .json or .jsonl (CityJSON)", ExitCode::usage);
}

}  // namespace ilot
