// SPDX-License-Identifier: Apache-2.0
// Clouds in and out, over clouds.h.
#include "ilot/clouds.h"

#include <nlohmann/json.hpp>

#include "c_api/guard.h"
#include "ilot/version.h"

struct ilot_cloud {
  ilot::CloudFile file;
};

struct ilot_writer {
  ilot::CloudWriter writer;
  bool open = true;  // neither finished nor after a fault
};

namespace ilot::c {

namespace {

constexpr std::int32_t kAbiVersion = 1;

nlohmann::json measure_json(const CloudFile& cloud, const CloudMeasure& m) {
  const CloudDescription& d = cloud.description();
  nlohmann::json json{{"path", d.path.string()},
                      {"format", d.format},
                      {"points", d.points},
                      {"declared_points", d.declared_points},
                      {"scale", json_of(d.scale)},
                      {"has_colour", d.has_colour},
                      {"extra", d.extra},
                      {"metres_per_unit", d.crs.metres_per_unit},
                      {"valid_points", m.points},
                      {"rejected", m.rejected},
                      {"strays", m.strays},
                      {"min", json_of(m.min)},
                      {"max", json_of(m.max)},
                      {"area_m2", m.occupied_area},
                      {"density", m.density},
                      {"sampling_step_m", m.sampling_step},
                      {"warnings", cloud.warnings(m)}};
  json["crs"] = nullptr;
  if (d.crs.epsg > 0) json["crs"] = "EPSG:" + std::to_string(d.crs.epsg);
  if (d.crs.epsg == 0 && !d.crs.wkt.empty()) json["crs"] = d.crs.wkt;
  json["classes"] = nlohmann::json::object();
  for (std::size_t c = 0; c < m.classes.size(); ++c)
    if (m.classes[c] > 0) json["classes"][std::to_string(c)] = m.classes[c];
  json["suits"] = nlohmann::json::object();
  for (const CloudSuitability& s : cloud.suitability(m))
    json["suits"][s.product] = {{"yes", s.yes}, {"reason", s.reason}};
  return json;
}

template <typename T>
std::span<T> span_of(T* values, std::size_t count) {
  return values == nullptr ? std::span<T>{} : std::span<T>{values, count};
}

void need_places(const ilot_columns* columns) {
  need(columns, "columns");
  need(columns->x, "x");
  need(columns->y, "y");
  need(columns->z, "z");
}

void need_open(const ilot_writer& writer) {
  if (!writer.open) throw Error("writer: it was finished, or a write failed: open another one", ExitCode::usage);
}

// A piece of the caller's array; none stays empty, which counts as zeros.
template <typename T>
void assign_piece(std::vector<T>& to, const T* from, std::size_t at, std::size_t count) {
  if (from != nullptr) to.assign(from + at, from + at + count);
}

// In pieces, so that the copies stay small.
void write_columns(CloudWriter& writer, std::size_t points, const ilot_columns& columns) {
  constexpr std::size_t kPiece = std::size_t{1} << 18;
  PointColumns piece;
  for (std::size_t at = 0; at < points; at += kPiece) {
    const std::size_t count = std::min(kPiece, points - at);
    assign_piece(piece.x, columns.x, at, count);
    assign_piece(piece.y, columns.y, at, count);
    assign_piece(piece.z, columns.z, at, count);
    assign_piece(piece.intensity, columns.intensity, at, count);
    assign_piece(piece.classification, columns.classification, at, count);
    assign_piece(piece.red, columns.red, at, count);
    assign_piece(piece.green, columns.green, at, count);
    assign_piece(piece.blue, columns.blue, at, count);
    writer.write(piece);
  }
}

}  // namespace

}  // namespace ilot::c

using namespace ilot;
using namespace ilot::c;

extern "C" {

int32_t ilot_abi_version(void) {
  return kAbiVersion;
}

const char* ilot_version(void) {
  static const std::string text = version();
  return text.c_str();
}

ilot_status ilot_cloud_open(const char* path, ilot_cloud** cloud) {
  return guarded([&] {
    clear(cloud);
    need(cloud, "cloud");
    need(path, "path");
    *cloud = new ilot_cloud{CloudFile(path)};
    return ILOT_OK;
  });
}

void ilot_cloud_close(ilot_cloud* cloud) {
  delete cloud;
}

uint64_t ilot_cloud_rows(const ilot_cloud* cloud) {
  return cloud == nullptr ? 0 : cloud->file.description().points;
}

ilot_status ilot_cloud_read(ilot_cloud* cloud, uint64_t first, size_t capacity, const ilot_columns* columns,
                            uint64_t* rows, size_t* points) {
  return guarded([&] {
    clear(rows, points);
    need(cloud, "cloud");
    need_places(columns);
    need(rows, "rows");
    need(points, "points");
    const PointSpans arrays{span_of(columns->x, capacity),
                            span_of(columns->y, capacity),
                            span_of(columns->z, capacity),
                            span_of(columns->intensity, capacity),
                            span_of(columns->classification, capacity),
                            span_of(columns->red, capacity),
                            span_of(columns->green, capacity),
                            span_of(columns->blue, capacity)};
    *rows = cloud->file.read(first, arrays, *points);
    return ILOT_OK;
  });
}

ilot_status ilot_cloud_measure(ilot_cloud* cloud, char** json) {
  return guarded([&] {
    clear(json);
    need(cloud, "cloud");
    need(json, "json");
    *json = text_of(measure_json(cloud->file, cloud->file.measure()));
    return ILOT_OK;
  });
}

ilot_status ilot_writer_open(const char* path, const char* crs, double scale, const double offset[3], int32_t colour,
                             ilot_writer** writer) {
  return guarded([&] {
    clear(writer);
    need(writer, "writer");
    need(path, "path");
    need(offset, "offset");
    CloudWriterOptions options;
    if (crs != nullptr) options.crs = crs;
    options.scale = scale;
    options.offset = {offset[0], offset[1], offset[2]};
    options.colour = colour != 0;
    *writer = new ilot_writer{CloudWriter(path, options)};
    return ILOT_OK;
  });
}

ilot_status ilot_writer_write(ilot_writer* writer, size_t points, const ilot_columns* columns) {
  return guarded([&] {
    need(writer, "writer");
    need_places(columns);
    need_open(*writer);
    writer->open = false;  // a fault leaves it so
    write_columns(writer->writer, points, *columns);
    writer->open = true;
    return ILOT_OK;
  });
}

ilot_status ilot_writer_finish(ilot_writer* writer) {
  return guarded([&] {
    need(writer, "writer");
    need_open(*writer);
    writer->open = false;
    writer->writer.finish();
    return ILOT_OK;
  });
}

void ilot_writer_close(ilot_writer* writer) {
  delete writer;
}

}  // extern "C"
