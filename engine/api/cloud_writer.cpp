// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <cmath>

#include "engine/error.h"
#include "engine/formats/crs.h"
#include "engine/formats/row_buffer.h"
#include "engine/formats/writer.h"
#include "engine/version.h"
#include "ilot/clouds.h"

namespace ilot {
namespace {

constexpr std::uint8_t kPlainFormat = 6, kColourFormat = 7;  // ASPRS LAS 1.4

CloudSpec spec_of(const CloudWriterOptions& options) {
  if (!(options.scale > 0)) throw Error("scale: must be above 0", ExitCode::usage);
  CloudSpec spec;
  if (!options.crs.empty()) spec.like.crs = crs_from_text(options.crs);
  RecordLayout& layout = spec.like.layout;
  layout.point_format = options.colour ? kColourFormat : kPlainFormat;
  layout.record_length = static_cast<std::uint16_t>(standard_size(layout.point_format));
  layout.scale = {options.scale, options.scale, options.scale};
  layout.offset = {options.offset.x, options.offset.y, options.offset.z};
  spec.software = options.software.empty() ? "ilot " + version() : options.software;
  return spec;
}

void check_lengths(const PointColumns& p) {
  const std::size_t size = p.x.size();
  bool good = p.y.size() == size && p.z.size() == size;
  for (const auto* v : {&p.intensity, &p.red, &p.green, &p.blue}) good = good && (v->empty() || v->size() == size);
  if (!good || (!p.classification.empty() && p.classification.size() != size))
    throw Error("PointColumns: arrays have different lengths", ExitCode::usage);
}

std::int32_t raw_of(double value, double scale, double offset) {
  const double raw = std::round((value - offset) / scale);
  if (!(std::abs(raw) <= 2147483647.0))
    throw Error("a coordinate lies beyond 2^31 scales of the offset, or is not finite: " + std::to_string(value),
                ExitCode::usage);
  return static_cast<std::int32_t>(raw);
}

}  // namespace

struct CloudWriter::State {
  RecordLayout layout;
  std::unique_ptr<PointWriter> writer;

  void put(const PointColumns& points, std::size_t i, std::span<std::byte> record) const {
    const auto value = [&](const auto& list) { return list.empty() ? 0 : list[i]; };
    PointFields fields;
    fields.x = raw_of(points.x[i], layout.scale[0], layout.offset[0]);
    fields.y = raw_of(points.y[i], layout.scale[1], layout.offset[1]);
    fields.z = raw_of(points.z[i], layout.scale[2], layout.offset[2]);
    fields.intensity = static_cast<std::uint16_t>(value(points.intensity));
    fields.classification = static_cast<std::uint8_t>(value(points.classification));
    fields.return_number = fields.return_count = 1;
    encode_fields(fields, record, layout.point_format);
    const auto rgb = rgb_offset(layout.point_format);
    if (!rgb) return;
    store(&record[*rgb], static_cast<std::uint16_t>(value(points.red)));
    store(&record[*rgb + 2], static_cast<std::uint16_t>(value(points.green)));
    store(&record[*rgb + 4], static_cast<std::uint16_t>(value(points.blue)));
  }
};

CloudWriter::CloudWriter(const std::filesystem::path& path, const CloudWriterOptions& options)
    : state_(std::make_unique<State>()) {
  const CloudSpec spec = spec_of(options);
  state_->layout = spec.like.layout;
  state_->writer = create_cloud(path, spec);
}

CloudWriter::~CloudWriter() = default;
CloudWriter::CloudWriter(CloudWriter&&) noexcept = default;
CloudWriter& CloudWriter::operator=(CloudWriter&&) noexcept = default;

void CloudWriter::write(const PointColumns& points) {
  check_lengths(points);
  const std::size_t length = state_->layout.record_length, batch = rows_at_a_time(length);
  std::vector<std::byte> rows;
  for (std::size_t first = 0; first < points.size(); first += batch) {
    const std::size_t count = std::min(batch, points.size() - first);
    rows.assign(count * length, std::byte{0});
    for (std::size_t i = 0; i < count; ++i) state_->put(points, first + i, std::span(rows).subspan(i * length, length));
    state_->writer->write(rows);
  }
}

void CloudWriter::finish() {
  state_->writer->finish();
}

}  // namespace ilot
