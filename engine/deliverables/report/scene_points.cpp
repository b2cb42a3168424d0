// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/scene_points.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include "engine/deliverables/report/packed.h"
#include "engine/error.h"
#include "engine/formats/reader.h"
#include "engine/formats/row_buffer.h"
#include "kernels/core/parallel.h"
#include "kernels/core/rng.h"

namespace ilot {
namespace {

constexpr std::size_t kBytesAtATime = 1u << 20;

// Where the values of a point are in its record.
struct PointFieldsAt {
  std::optional<std::size_t> plane, unit, object, facade, element, label, residual, rgb;
};

std::optional<std::size_t> offset_of(const RecordLayout& layout, const char* name, FieldType type) {
  for (const ExtraField& field : layout.extra)
    if (field.name == name && field.type == type) return field.offset;
  return std::nullopt;
}

PointFieldsAt fields_at(const RecordLayout& layout) {
  return {offset_of(layout, "plane_id", FieldType::u32),   offset_of(layout, "unit_id", FieldType::u32),
          offset_of(layout, "object_id", FieldType::u32),  offset_of(layout, "facade_id", FieldType::u16),
          offset_of(layout, "element_id", FieldType::u32), offset_of(layout, "label", FieldType::u8),
          offset_of(layout, "residual", FieldType::f32),   rgb_offset(layout.point_format)};
}

template <class T>
T value_at(const std::byte* record, const std::optional<std::size_t>& offset) {
  return offset ? load<T>(record + *offset) : T{};
}

ScenePoint point_of(std::span<const std::byte> row, const RecordLayout& layout, const PointFieldsAt& at) {
  const std::byte* record = row.data();
  const PointFields fields = decode_fields(row, layout.point_format);
  ScenePoint p;
  p.at = {fields.x * layout.scale[0] + layout.offset[0], fields.y * layout.scale[1] + layout.offset[1],
          fields.z * layout.scale[2] + layout.offset[2]};
  p.plane = value_at<std::uint32_t>(record, at.plane);
  p.unit = value_at<std::uint32_t>(record, at.unit);
  p.object = value_at<std::uint32_t>(record, at.object);
  p.element = value_at<std::uint32_t>(record, at.element);
  p.facade = value_at<std::uint16_t>(record, at.facade);
  p.label = value_at<std::uint8_t>(record, at.label);
  p.classification = fields.classification;
  p.residual_m = value_at<float>(record, at.residual);
  p.colour = {fields.intensity, fields.intensity, fields.intensity};
  if (at.rgb)
    for (std::size_t c = 0; c < 3; ++c) p.colour[c] = load<std::uint16_t>(record + *at.rgb + 2 * c);
  return p;
}

// A number that depends on the place of the point in the file's steps alone.
std::uint64_t rank_of(const std::byte* record) {
  return mix64(mix64(load<std::uint32_t>(record) | static_cast<std::uint64_t>(load<std::uint32_t>(record + 4)) << 32) ^
               load<std::uint32_t>(record + 8));
}

struct Taken {
  std::vector<ScenePoint> points;
  std::map<std::uint32_t, std::vector<std::pair<std::uint64_t, Vec3>>> of_unit;  // with their ranks
};

// Keeps the points of least rank. Twice as many are gathered before the rest is dropped.
void keep_least(std::vector<std::pair<std::uint64_t, Vec3>>& points, std::size_t most, std::size_t now_above) {
  if (points.size() <= now_above) return;
  std::sort(points.begin(), points.end(), [](const auto& a, const auto& b) {
    return std::tuple(a.first, a.second.x, a.second.y, a.second.z) <
           std::tuple(b.first, b.second.x, b.second.y, b.second.z);
  });
  points.resize(std::min(points.size(), most));
}

class CloudSample {
 public:
  CloudSample(PointReader& reader, std::uint64_t below, const SampleParams& params)
      : reader_(reader), layout_(reader.info().layout), at_(fields_at(layout_)), below_(below), params_(params) {}

  Taken read(std::uint64_t first, std::uint64_t last) const {
    Taken taken;
    const std::size_t length = layout_.record_length;
    std::vector<std::byte> rows(rows_at_a_time(length, 1u << 14, kBytesAtATime) * length);
    std::vector<std::uint8_t> valid(rows.size() / length);
    while (first < last) {
      const std::size_t wanted = std::min<std::uint64_t>(valid.size(), last - first);
      const std::size_t got =
          reader_.read(first, std::span(rows).first(wanted * length), std::span(valid).first(wanted));
      for (std::size_t i = 0; i < got; ++i)
        if (valid[i] != 0) take(std::span(rows).subspan(i * length, length), taken);
      if (got < wanted) break;
      first += got;
    }
    return taken;
  }

 private:
  void take(std::span<const std::byte> row, Taken& taken) const {
    const std::uint64_t rank = rank_of(row.data());
    const auto unit = value_at<std::uint32_t>(row.data(), at_.unit);
    const bool drawn = unit > 0 && params_.units.contains(unit);
    if (rank >= below_ && !drawn) return;
    const ScenePoint p = point_of(row, layout_, at_);
    if (rank < below_) taken.points.push_back(p);
    if (!drawn) return;
    auto& points = taken.of_unit[unit];
    points.emplace_back(rank, p.at);
    keep_least(points, params_.most_of_units, 2 * params_.most_of_units);
  }

  PointReader& reader_;
  const RecordLayout& layout_;
  PointFieldsAt at_;
  std::uint64_t below_;
  const SampleParams& params_;
};

void note_fields(const RecordLayout& layout, std::set<std::string>& fields) {
  const PointFieldsAt at = fields_at(layout);
  if (at.plane) fields.insert("plane_id");
  if (at.unit) fields.insert("unit_id");
  if (at.object) fields.insert("object_id");
  if (at.facade) fields.insert("facade_id");
  if (at.element) fields.insert("element_id");
  if (at.label) fields.insert("label");
  if (at.residual) fields.insert("residual");
  if (at.rgb) fields.insert("colour");
}

void read_cloud(const std::filesystem::path& path, std::uint64_t below, const SampleParams& params,
                std::map<std::uint32_t, std::vector<std::pair<std::uint64_t, Vec3>>>& of_unit, SampledPoints& sample) {
  const auto reader = open_cloud(path);
  note_fields(reader->info().layout, sample.fields);
  sample.read += reader->info().points;
  const std::vector<std::uint64_t> ends = reader->boundaries();
  const CloudSample cloud(*reader, below, params);
  const std::size_t at_once = reader->random_access() ? params.tasks : 1;
  for (std::size_t from = 0; from + 1 < ends.size(); from += at_once) {
    std::vector<Taken> taken(std::min(at_once, ends.size() - 1 - from));
    parallel_for(taken.size(), [&](std::size_t i) { taken[i] = cloud.read(ends[from + i], ends[from + i + 1]); });
    for (Taken& part : taken) {
      sample.points.insert(sample.points.end(), part.points.begin(), part.points.end());
      for (auto& [unit, points] : part.of_unit) {
        auto& all = of_unit[unit];
        all.insert(all.end(), points.begin(), points.end());
        keep_least(all, params.most_of_units, 2 * params.most_of_units);
      }
    }
  }
}

// The colours as bytes: divided by the value that 99 of 100 do not exceed, where that is above 255.
std::array<std::string, 3> colour_bytes(const std::vector<ScenePoint>& points) {
  std::vector<std::uint16_t> values;
  for (const ScenePoint& p : points) values.push_back(*std::max_element(p.colour.begin(), p.colour.end()));
  double high = 255;
  if (!values.empty()) {
    const std::size_t at = values.size() * 99 / 100;
    std::nth_element(values.begin(), values.begin() + static_cast<std::ptrdiff_t>(at), values.end());
    high = std::max<double>(1, values[at]);
  }
  std::array<std::string, 3> bytes;
  for (const ScenePoint& p : points)
    for (std::size_t c = 0; c < 3; ++c)
      bytes[c] += static_cast<char>(std::clamp(std::lround(255 * p.colour[c] / high), 0l, 255l));
  return bytes;
}

}  // namespace

SampledPoints sample_points(const ResultFolder& result, const SampleParams& params) {
  SampledPoints sample;
  std::vector<std::string> clouds;
  for (const ResultRecord& file : result.files)
    if (file.path.starts_with("points/")) clouds.push_back(file.path);
  std::uint64_t total = 0;
  for (const std::string& cloud : clouds) total += open_cloud(result.path / cloud)->info().points;
  const double share = total == 0 ? 0 : static_cast<double>(params.most_points) / static_cast<double>(total);
  const std::uint64_t below = share >= 1 ? ~std::uint64_t{0} : static_cast<std::uint64_t>(share * 0x1p64);
  std::map<std::uint32_t, std::vector<std::pair<std::uint64_t, Vec3>>> of_unit;
  for (const std::string& cloud : clouds) read_cloud(result.path / cloud, below, params, of_unit, sample);
  for (auto& [unit, points] : of_unit) {
    keep_least(points, params.most_of_units, 0);
    for (const auto& [rank, place] : points) sample.of_unit[unit].push_back(place);
  }
  if (clouds.empty()) sample.problem = "the run wrote no labelled clouds (--no-clouds), so there are no points to show";
  return sample;
}

std::string packed_points(const SampledPoints& sample, const SceneFrame& frame, nlohmann::ordered_json& about) {
  const std::vector<ScenePoint>& points = sample.points;
  Vec3 low{INFINITY, INFINITY, INFINITY}, high{-INFINITY, -INFINITY, -INFINITY};
  for (const ScenePoint& p : points) {
    const Vec3 at = frame.at(p.at);
    low = {std::min(low.x, at.x), std::min(low.y, at.y), std::min(low.z, at.z)};
    high = {std::max(high.x, at.x), std::max(high.y, at.y), std::max(high.z, at.z)};
  }
  if (points.empty()) low = high = {};
  constexpr double kMost = 65535;  // of the words that places are stored in
  const double step = std::max({high.x - low.x, high.y - low.y, high.z - low.z, 0.001 * kMost}) / kMost;
  constexpr double kResidualStep = 0.002;  // metres; a byte reaches to 25 cm
  std::vector<std::uint16_t> place[3], facade;
  std::vector<std::uint8_t> label, classification;
  std::vector<std::int8_t> residual;
  std::vector<std::uint32_t> plane, unit, object, element;
  for (const ScenePoint& p : points) {
    const Vec3 at = frame.at(p.at) - low;
    const double xyz[3] = {at.x, at.y, at.z};
    for (std::size_t i = 0; i < 3; ++i) place[i].push_back(static_cast<std::uint16_t>(std::lround(xyz[i] / step)));
    label.push_back(p.label), classification.push_back(p.classification);
    plane.push_back(p.plane), unit.push_back(p.unit), object.push_back(p.object), facade.push_back(p.facade);
    element.push_back(p.element);
    const double steps = std::isfinite(p.residual_m) ? p.residual_m / kResidualStep : 0.0;
    residual.push_back(static_cast<std::int8_t>(std::clamp(std::round(steps), -127.0, 127.0)));
  }
  std::string bytes;
  nlohmann::ordered_json columns = nlohmann::ordered_json::array();
  const auto put = [&](const char* name, const char* type, const auto& values) {
    columns.push_back({{"name", name}, {"type", type}, {"at", bytes.size()}});
    put_column(bytes, values);
    bytes.resize((bytes.size() + 3) / 4 * 4);  // words begin at multiples of their size
  };
  put("x", "u16", place[0]), put("y", "u16", place[1]), put("z", "u16", place[2]);
  if (sample.fields.contains("label")) put("label", "u8", label);
  put("class", "u8", classification);
  if (sample.fields.contains("residual")) put("residual", "i8", residual);
  if (sample.fields.contains("plane_id")) put("plane", "u32", plane);
  if (sample.fields.contains("unit_id")) put("unit", "u32", unit);
  if (sample.fields.contains("object_id")) put("object", "u32", object);
  if (sample.fields.contains("facade_id")) put("facade", "u16", facade);
  if (sample.fields.contains("element_id")) put("element", "u32", element);
  const auto colours = colour_bytes(points);
  const bool coloured = sample.fields.contains("colour");
  for (std::size_t c = 0; c < (coloured ? 3u : 1u); ++c)
    put(coloured ? std::array{"red", "green", "blue"}[c] : "intensity", "u8",
        std::vector<std::uint8_t>(colours[c].begin(), colours[c].end()));
  about = {{"count", points.size()},         {"of", sample.read}, {"low", {low.x, low.y, low.z}}, {"step", step},
           {"residual_step", kResidualStep}, {"columns", columns}};
  if (!sample.problem.empty()) about["problem"] = sample.problem;
  return bytes;
}

}  // namespace ilot
