// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/property_table.h"

#include <span>

namespace ilot {
namespace {

using Json = nlohmann::ordered_json;

Json property_schema(const Property& p) {
  Json json{{"description", p.unit.empty() ? p.meaning : p.meaning + " (" + p.unit + ")"}};
  switch (p.type) {
    case PropertyType::text:
      json.update({{"type", "STRING"}, {"noData", ""}});
      break;
    case PropertyType::real:
      json.update({{"type", "SCALAR"}, {"componentType", "FLOAT64"}, {"noData", kNoReal}});
      break;
    case PropertyType::whole:
      json.update({{"type", "SCALAR"}, {"componentType", "INT64"}, {"noData", kNoWhole}});
      break;
    case PropertyType::surface:
      json.update({{"type", "ENUM"}, {"enumType", "surface"}, {"required", true}});
  }
  return json;
}

template <class T>
std::size_t numbers_view(Glb& glb, const std::vector<T>& values) {
  return glb.add_view(std::as_bytes(std::span(values)), GlbTarget::none);
}

template <class From, class To>
std::vector<To> column(const std::vector<PropertyRow>& rows, std::size_t number) {
  std::vector<To> values;
  for (const PropertyRow& row : rows) values.push_back(static_cast<To>(std::get<From>(row[number])));
  return values;
}

Json text_column(Glb& glb, const std::vector<PropertyRow>& rows, std::size_t number) {
  std::string all;
  std::vector<std::uint32_t> offsets{0};
  for (const PropertyRow& row : rows) {
    all += std::get<std::string>(row[number]);
    offsets.push_back(static_cast<std::uint32_t>(all.size()));
  }
  if (all.empty()) all.push_back('\0');  // a view has at least one byte
  const std::size_t values = glb.add_view(std::as_bytes(std::span(all)), GlbTarget::none);
  return {{"values", values}, {"stringOffsets", numbers_view(glb, offsets)}};
}

}  // namespace

Json metadata_start(const std::vector<PropertyClass>& classes) {
  Json described = Json::object();
  for (const PropertyClass& c : classes) {
    Json properties = Json::object();
    for (const Property& p : c.properties) properties[p.name] = property_schema(p);
    described[c.name] = {{"properties", properties}};
  }
  Json values = Json::array();
  for (const auto& [name, value] : {std::pair("roof", 0), std::pair("wall", 1), std::pair("ground", 2)})
    values.push_back({{"name", name}, {"value", value}});
  return {{"schema",
           {{"id", "ilot"},
            {"classes", described},
            {"enums", {{"surface", {{"valueType", "UINT8"}, {"values", values}}}}}}},
          {"propertyTables", Json::array()}};
}

Json property_table(Glb& glb, const PropertyClass& of, const std::vector<PropertyRow>& rows) {
  Json properties = Json::object();
  for (std::size_t i = 0; i < of.properties.size(); ++i) {
    Json& described = properties[of.properties[i].name];
    switch (of.properties[i].type) {
      case PropertyType::text:
        described = text_column(glb, rows, i);
        break;
      case PropertyType::real:
        described["values"] = numbers_view(glb, column<double, double>(rows, i));
        break;
      case PropertyType::whole:
        described["values"] = numbers_view(glb, column<std::int64_t, std::int64_t>(rows, i));
        break;
      case PropertyType::surface:
        described["values"] = numbers_view(glb, column<std::int64_t, std::uint8_t>(rows, i));
    }
  }
  return {{"name", of.name}, {"class", of.name}, {"count", rows.size()}, {"properties", properties}};
}

}  // namespace ilot
