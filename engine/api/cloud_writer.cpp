// SPDX-License-Identifier: Apache-2.0
#include <algorithm>

#include "engine/formats/arrays/array_rows.h"
#include "engine/formats/crs.h"
#include "engine/formats/row_buffer.h"
#include "engine/formats/writer.h"
#include "engine/version.h"
#include "ilot/clouds.h"

namespace ilot {
namespace {

CloudSpec spec_of(const CloudWriterOptions& options) {
  CloudSpec spec;
  if (!options.crs.empty()) spec.like.crs = crs_from_text(options.crs);
  spec.like.layout = array_layout(options.colour, options.scale, options.offset);
  spec.software = options.software.empty() ? "ilot " + version() : options.software;
  return spec;
}

}  // namespace

struct CloudWriter::State {
  RecordLayout layout;
  std::unique_ptr<PointWriter> writer;
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
  ArrayCloud arrays{"PointColumns", points.x, points.y, points.z, points.intensity, points.classification};
  arrays.red = points.red;
  arrays.green = points.green;
  arrays.blue = points.blue;
  check_array_lengths(arrays);
  const std::size_t length = state_->layout.record_length, batch = rows_at_a_time(length);
  std::vector<std::byte> rows;
  for (std::size_t first = 0; first < points.size(); first += batch) {
    rows.resize(std::min(batch, points.size() - first) * length);
    fill_rows(arrays, state_->layout, first, rows);
    state_->writer->write(rows);
  }
}

void CloudWriter::finish() {
  state_->writer->finish();
}

}  // namespace ilot
