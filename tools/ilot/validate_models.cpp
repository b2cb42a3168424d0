// SPDX-License-Identifier: Apache-2.0
#include "tools/ilot/validate_models.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <set>

#include "engine/report/counted.h"
#include "tools/ilot/console.h"

namespace ilot {
namespace {

std::string described(const Fault& fault) {
  return fmt::format("{} {}{}{}", fault.code, validity_code_name(fault.code), fault.where.empty() ? "" : " ",
                     fault.where);
}

// Returns the codes, then the violation of the format, then the first fault of each code.
std::string object_line(const ObjectValidity& found) {
  std::string codes, text;
  for (const std::string& what : found.format) text += (text.empty() ? "" : "; ") + what;
  if (!found.format.empty()) codes = "format";
  std::set<int> seen;
  for (const Fault& fault : found.faults)
    if (seen.insert(fault.code).second) text += (text.empty() ? "" : "; ") + described(fault);
  for (const int code : seen) codes += fmt::format("{}{}", codes.empty() ? "" : " ", code);
  return fmt::format("{}: {}{}", codes, found.id.empty() ? "" : found.id + ": ", text);
}

std::string summary_line(const ModelsValidity& sum) {
  if (sum.valid()) return "valid: " + counted(sum.objects, "object");
  std::string codes;
  for (const auto& [code, objects] : sum.codes)
    codes += fmt::format("{}{}: {}", codes.empty() ? "" : ", ", code, objects);
  if (sum.format_faults) codes += fmt::format("{}format: {}", codes.empty() ? "" : ", ", sum.format_faults);
  return fmt::format("invalid: {} of {} objects ({})", sum.invalid, sum.objects, codes);
}

nlohmann::json object_json(const ObjectValidity& found) {
  nlohmann::json faults = nlohmann::json::array();
  for (const Fault& fault : found.faults)
    faults.push_back({{"code", fault.code}, {"name", validity_code_name(fault.code)}, {"where", fault.where}});
  return {{"id", found.id}, {"format", found.format}, {"faults", std::move(faults)}};
}

std::string file_json(const std::filesystem::path& file, const ModelsValidity& sum, nlohmann::json objects) {
  nlohmann::json codes = nlohmann::json::object();
  for (const auto& [code, count] : sum.codes) codes[std::to_string(code)] = count;
  const nlohmann::json entry{{"file", file.string()},         {"valid", sum.valid()},
                             {"objects", sum.objects},        {"invalid", sum.invalid},
                             {"codes", std::move(codes)},     {"format_faults", sum.format_faults},
                             {"findings", std::move(objects)}};
  return entry.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
}

}  // namespace

bool print_models_validity(const std::filesystem::path& file, const ValidityParams& params, std::string* json) {
  if (!json) {
    const auto show = [&](const ObjectValidity& found) {
      print(one_line(fmt::format("{}: invalid: {}", file.string(), object_line(found))));
    };
    const ModelsValidity sum = validate_models(file, show, params);
    print(one_line(fmt::format("{}: {}", file.string(), summary_line(sum))));
    return sum.valid();
  }
  nlohmann::json objects = nlohmann::json::array();
  const ModelsValidity sum = validate_models(
      file, [&](const ObjectValidity& found) { objects.push_back(object_json(found)); }, params);
  *json += (json->empty() ? "" : ",\n") + file_json(file, sum, std::move(objects));
  return sum.valid();
}

}  // namespace ilot
