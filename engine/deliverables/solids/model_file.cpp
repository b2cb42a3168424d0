// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/solids/model_file.h"

#include "engine/deliverables/solids/solid_file.h"
#include "engine/error.h"

namespace ilot {
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
