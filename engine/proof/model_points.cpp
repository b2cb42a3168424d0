// SPDX-License-Identifier: Apache-2.0
#include "engine/proof/model_points.h"

#include <charconv>
#include <map>
#include <set>
#include <string_view>

#include "engine/error.h"
#include "engine/proof/point_stream.h"

namespace ilot {
namespace {

struct CloudPoints {
  std::vector<Vec3> positions;
  std::vector<std::int64_t> values;  // values of the field, where there is one
};

CloudPoints read_points(PointReader& reader, const ModelPointsParams& params, const std::optional<ExtraField>& field) {
  const RecordLayout& layout = reader.info().layout;
  CloudPoints points;
  for_each_record(reader, [&](const std::byte* record) {
    if (params.classification) {
      const PointFields fields = decode_fields({record, layout.record_length}, layout.point_format);
      if (fields.classification != *params.classification) return;
    }
    points.positions.push_back(position_of(record, layout));
    if (field) points.values.push_back(integer_of(record, *field));
  });
  return points;
}

// The models by the integer that is their name or that follows "building-" in it.
std::map<std::int64_t, std::uint32_t> models_by_number(std::span<const PolygonModel> models) {
  std::map<std::int64_t, std::uint32_t> numbers;
  for (std::uint32_t m = 0; m < models.size(); ++m) {
    std::string_view name = models[m].name;
    if (name.starts_with("building-")) name.remove_prefix(9);
    std::int64_t number = 0;
    const auto [end, code] = std::from_chars(name.data(), name.data() + name.size(), number);
    if (code == std::errc() && end == name.data() + name.size()) numbers.try_emplace(number, m);
  }
  return numbers;
}

PointOwner choose_owner(const ModelPointsParams& params, const CloudPoints& points,
                        const std::map<std::int64_t, std::uint32_t>& numbers, std::size_t models) {
  if (params.owner != PointOwner::automatic) return params.owner;
  const std::set<std::int64_t> values(points.values.begin(), points.values.end());
  std::size_t known = 0;
  for (const std::int64_t value : values) known += numbers.contains(value);
  if (known > 0 && 2 * known > values.size()) return PointOwner::field;
  return models == 1 ? PointOwner::everything : PointOwner::plan;
}

void assign_by_field(const CloudPoints& points, const std::map<std::int64_t, std::uint32_t>& numbers,
                     ModelPoints& result) {
  std::map<std::int64_t, std::vector<Vec3>> strangers;
  for (std::size_t i = 0; i < points.positions.size(); ++i) {
    const auto found = numbers.find(points.values[i]);
    (found == numbers.end() ? strangers[points.values[i]] : result.buildings[found->second].points)
        .push_back(points.positions[i]);
  }
  for (auto& [value, positions] : strangers)
    result.buildings.push_back({std::to_string(value), kNoModel, std::move(positions)});
}

void assign_to_models(std::span<const PolygonModel> models, const CloudPoints& points, double margin,
                      ModelPoints& result) {
  const std::vector<std::uint32_t> owners = assign_by_plan(models, points.positions, margin);
  for (std::size_t i = 0; i < owners.size(); ++i) {
    if (owners[i] == kNoModel)
      ++result.unassigned;
    else
      result.buildings[owners[i]].points.push_back(points.positions[i]);
  }
}

}  // namespace

ModelPoints read_model_points(const std::filesystem::path& cloud, std::span<const PolygonModel> models,
                              const ModelPointsParams& params) {
  const std::unique_ptr<PointReader> reader = open_cloud(cloud);
  const auto field = find_integer_field(reader->info().layout, params.field);
  if (params.owner == PointOwner::field && !field)
    throw Error(cloud.string() + ": no extra bytes '" + params.field +
                "' with whole numbers; --points-of plan needs none");
  CloudPoints points = read_points(*reader, params, field);
  const auto numbers = models_by_number(models);
  ModelPoints result;
  result.metres_per_unit = reader->info().crs.metres_per_unit;
  result.read = points.positions.size();
  result.owner = choose_owner(params, points, numbers, models.size());
  for (std::uint32_t m = 0; m < models.size(); ++m) result.buildings.push_back({models[m].name, m, {}});
  if (result.owner == PointOwner::field)
    assign_by_field(points, numbers, result);
  else if (result.owner == PointOwner::everything && !models.empty())
    result.buildings[0].points = std::move(points.positions);
  else
    assign_to_models(models, points, params.margin_m / result.metres_per_unit, result);
  for (const BuildingPoints& b : result.buildings) result.models_without_points += b.points.empty();
  return result;
}

}  // namespace ilot
