// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/error.h"
#include "engine/formats/export.h"
#include "engine/formats/reader.h"
#include "engine/formats/row_buffer.h"
#include "engine/pass/measure.h"
#include "engine/run/suitability.h"
#include "ilot/clouds.h"

namespace ilot {
namespace {

constexpr std::uint32_t kPlainFields = kFieldZ | kFieldClass | kFieldIntensity | kFieldRgb;

CloudDescription description_of(const CloudInfo& info) {
  CloudDescription d;
  d.path = info.path;
  d.format = info.format;
  d.dialect = info.dialect;
  d.crs = info.crs;
  d.points = info.points;
  d.declared_points = info.declared_points;
  d.declared_min = info.declared_min;
  d.declared_max = info.declared_max;
  d.scale = {info.layout.scale[0], info.layout.scale[1], info.layout.scale[2]};
  d.has_colour = rgb_offset(info.layout.point_format).has_value();
  d.has_gps_time = gps_time_offset(info.layout.point_format).has_value();
  for (const ExtraField& field : info.layout.extra)
    if (field.type != FieldType::opaque) d.extra.push_back(field.name);
  d.stations = info.stations;
  d.scans = info.scans;
  d.warnings = info.warnings;
  return d;
}

// The columns of these names, in this order. Extra bytes may have the name of a standard field: theirs come last.
std::vector<ExportColumn> columns_named(const CloudInfo& info, std::span<const std::string> names, bool extra) {
  const std::vector<ExportColumn> all = export_columns(info.layout);
  std::vector<ExportColumn> chosen;
  for (const std::string& name : names) {
    const auto found = std::find_if(all.begin(), all.end(), [&](const ExportColumn& c) {
      return c.name == name && (c.raw != FieldType::opaque) == extra;
    });
    if (found == all.end()) throw Error(info.path.string() + ": has no attribute '" + name + "'", ExitCode::usage);
    chosen.push_back(*found);
  }
  return chosen;
}

}  // namespace

struct CloudFile::State {
  std::unique_ptr<PointReader> reader;
  CloudDescription description;
  std::uint32_t fields = kAllFields;
  std::vector<std::byte> rows;
  std::vector<std::uint8_t> valid;
  std::vector<double> values;

  void limit_to(std::uint32_t wanted) {
    if (fields != wanted) reader->limit_to(wanted);
    fields = wanted;
  }

  // Calls use(values of the columns) for each valid row; returns the rows.
  template <class Use>
  std::uint64_t for_each(std::uint64_t first, std::uint64_t most, std::span<const ExportColumn> columns,
                         const Use& use) {
    const CloudInfo& info = reader->info();
    const std::uint64_t end = first + std::min(most, info.points - std::min(first, info.points));
    const std::size_t length = info.layout.record_length, batch = rows_at_a_time(length);
    values.resize(columns.size());
    std::uint64_t at = first;
    while (at < end) {
      const auto asked = static_cast<std::size_t>(std::min<std::uint64_t>(batch, end - at));
      rows.resize(asked * length);
      valid.resize(asked);
      const std::size_t got = reader->read(at, rows, valid);
      for (std::size_t i = 0; i < got; ++i) {
        if (valid[i] == 0) continue;
        export_row(std::span(rows).subspan(i * length, length), info.layout, columns, values);
        use(std::span<const double>(values));
      }
      at += got;
      if (got < asked) break;
    }
    return at - first;
  }

  std::vector<ExportColumn> columns(std::span<const std::string> extra) {
    std::vector<std::string> names{"x", "y", "z", "intensity", "classification"};
    if (description.has_colour) names.insert(names.end(), {"red", "green", "blue"});
    std::vector<ExportColumn> list = columns_named(reader->info(), names, false);
    for (ExportColumn& column : columns_named(reader->info(), extra, true)) list.push_back(std::move(column));
    return list;
  }
};

CloudFile::CloudFile(const std::filesystem::path& path, const std::optional<TextDialect>& dialect)
    : state_(std::make_unique<State>()) {
  state_->reader = open_cloud(path, {dialect, false});
  state_->description = description_of(state_->reader->info());
}

CloudFile::~CloudFile() = default;
CloudFile::CloudFile(CloudFile&&) noexcept = default;
CloudFile& CloudFile::operator=(CloudFile&&) noexcept = default;

const CloudDescription& CloudFile::description() const {
  return state_->description;
}

std::uint64_t CloudFile::read(std::uint64_t first, std::uint64_t most, PointColumns& points,
                              std::span<const std::string> extra) {
  const std::vector<ExportColumn> columns = state_->columns(extra);
  state_->limit_to(extra.empty() ? kPlainFields : kPlainFields | kFieldExtra);
  for (auto* v : {&points.x, &points.y, &points.z}) v->clear();
  for (auto* v : {&points.intensity, &points.red, &points.green, &points.blue}) v->clear();
  points.classification.clear();
  points.extra.assign(extra.size(), {});
  const bool colour = state_->description.has_colour;
  const std::size_t extra_from = colour ? 8 : 5;
  return state_->for_each(first, most, columns, [&](std::span<const double> v) {
    points.x.push_back(v[0]);
    points.y.push_back(v[1]);
    points.z.push_back(v[2]);
    points.intensity.push_back(static_cast<std::uint16_t>(v[3]));
    points.classification.push_back(static_cast<std::uint8_t>(v[4]));
    if (colour) {
      points.red.push_back(static_cast<std::uint16_t>(v[5]));
      points.green.push_back(static_cast<std::uint16_t>(v[6]));
      points.blue.push_back(static_cast<std::uint16_t>(v[7]));
    }
    for (std::size_t i = 0; i < extra.size(); ++i) points.extra[i].push_back(v[extra_from + i]);
  });
}

std::uint64_t CloudFile::read(std::uint64_t first, const PointSpans& arrays, std::size_t& points) {
  const std::size_t size = arrays.x.size();
  const auto check = [&](std::size_t length, bool needed) {
    if (length != size && (needed || length != 0))
      throw Error("PointSpans: arrays have different lengths", ExitCode::usage);
  };
  check(arrays.y.size(), true);
  check(arrays.z.size(), true);
  for (const auto& span : {arrays.intensity, arrays.red, arrays.green, arrays.blue}) check(span.size(), false);
  check(arrays.classification.size(), false);
  const std::vector<ExportColumn> columns = state_->columns({});
  state_->limit_to(kPlainFields);
  const bool colour = state_->description.has_colour;
  points = 0;
  return state_->for_each(first, size, columns, [&](std::span<const double> v) {
    const auto put = [&](auto span, double value) {
      if (!span.empty()) span[points] = static_cast<typename decltype(span)::value_type>(value);
    };
    put(arrays.x, v[0]);
    put(arrays.y, v[1]);
    put(arrays.z, v[2]);
    put(arrays.intensity, v[3]);
    put(arrays.classification, v[4]);
    put(arrays.red, colour ? v[5] : 0);
    put(arrays.green, colour ? v[6] : 0);
    put(arrays.blue, colour ? v[7] : 0);
    ++points;
  });
}

CloudMeasure CloudFile::measure() {
  state_->limit_to(kAllFields);
  return measure_cloud(*state_->reader);
}

std::vector<std::string> CloudFile::warnings(const CloudMeasure& measure) const {
  return cloud_warnings(state_->reader->info(), measure);
}

std::vector<CloudSuitability> CloudFile::suitability(const CloudMeasure& measure) const {
  return ilot::suitability(state_->reader->info(), measure);
}

}  // namespace ilot
