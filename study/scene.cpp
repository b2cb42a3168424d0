// SPDX-License-Identifier: Apache-2.0
#include "study/scene.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstring>
#include <fstream>
#include <functional>
#include <nlohmann/json.hpp>
#include <numeric>
#include <stdexcept>

#include "engine/formats/reader.h"
#include "engine/products/planes/cells/auto_params.h"
#include "kernels/core/radix_sort.h"
#include "kernels/neighbours/knn.h"
#include "kernels/neighbours/morton.h"
#include "kernels/neighbours/normals.h"
#include "kernels/planes/cleaning.h"

namespace ilot::bench {
namespace {

using Json = nlohmann::json;

struct Row {
  std::int32_t xyz[3];
  std::uint16_t rgb[3], intensity;
  std::uint32_t true_class, true_plane, station;
};

std::uint32_t extra(const RecordLayout& layout, const char* name, const std::byte* record) {
  for (const ExtraField& f : layout.extra) {
    if (f.name != name) continue;
    std::uint32_t v = 0;
    std::memcpy(&v, record + f.offset, std::min<std::size_t>(f.size, sizeof v));
    return v;
  }
  return 0;
}

std::vector<Row> read_rows(PointReader& reader) {
  const RecordLayout& l = reader.info().layout;
  const auto n = static_cast<std::size_t>(reader.info().points);
  std::vector<std::byte> records(n * l.record_length);
  std::vector<std::uint8_t> valid(n);
  if (reader.read(0, records, valid) != n) throw std::runtime_error("the file is damaged");
  const auto rgb = rgb_offset(l.point_format);
  std::vector<Row> rows(n);
  for (std::size_t i = 0; i < n; ++i) {
    const std::byte* record = records.data() + i * l.record_length;
    const PointFields f = decode_fields(std::span(record, l.record_length), l.point_format);
    rows[i] = {{f.x, f.y, f.z}, {}, f.intensity, extra(l, "true_class", record), extra(l, "true_plane", record),
               f.source_id};
    if (rgb) std::memcpy(rows[i].rgb, record + *rgb, sizeof rows[i].rgb);
  }
  return rows;
}

Vec3 vector_of(const Json& j) {
  return {j[0].get<double>(), j[1].get<double>(), j[2].get<double>()};
}

TrueShape true_shape(const Json& j, Vec3 origin, double unit) {
  const std::string kind = j.at("kind");
  TrueShape t;
  t.id = j.at("id");
  t.points = j.at("points");
  t.length = j.value("length_m", 0.0) / unit;
  t.shape.origin = (1 / unit) * (vector_of(j.at("point")) - origin);
  t.shape.axis = vector_of(j.at("axis"));
  t.shape.radius = j.value("radius_m", 0.0) / unit;
  t.shape.kind = kind == "sphere" ? ShapeKind::kSphere : kind == "cone" ? ShapeKind::kCone : ShapeKind::kCylinder;
  const double angle = j.value("half_angle_deg", 0.0) * 0.017453292519943295;
  t.shape.sine = std::sin(angle);
  t.shape.cosine = std::cos(angle);
  return t;
}

double seconds_of(const std::function<void()>& body) {
  const auto start = std::chrono::steady_clock::now();
  body();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void estimate(Scene& s, int k) {
  const NeighbourIndex index = build_neighbour_index(s.points());
  std::vector<std::uint32_t> all(s.size());
  std::iota(all.begin(), all.end(), 0u);
  std::vector<std::int64_t> reach2(s.size());
  s.normals.resize(s.size());
  s.normal_seconds = seconds_of([&] { normals(index, all, {k, kMaxSquaredReach}, s.normals, reach2); });
  s.near.resize(s.size() * Scene::kNear);
  s.neighbour_seconds = seconds_of([&] { knn(index, all, {Scene::kNear, kMaxSquaredReach}, s.near, reach2); });
  const Sampling sampling = measure_sampling(index);
  s.step = sampling.step;
  s.noise = sampling.noise;
  for (auto* v : {&s.nx, &s.ny, &s.nz}) v->assign(s.x.size(), 0.0f);
  for (std::size_t i = 0; i < s.size(); ++i) {
    const PackedNormal& n = s.normals[i];
    s.nx[i] = static_cast<float>(n.x) / 32767;
    s.ny[i] = static_cast<float>(n.y) / 32767;
    s.nz[i] = static_cast<float>(n.z) / 32767;
  }
}

// Removes mixed pixels from the rows, station by station.
void clean(Scene& s, std::vector<Row>& rows, const Json& truth, const RecordLayout& layout) {
  if (!truth.contains("stations")) return;
  std::vector<std::uint8_t> kept(rows.size(), 1);
  for (const Json& station : truth.at("stations")) {
    std::vector<std::uint32_t> index;
    for (std::uint32_t i = 0; i < rows.size(); ++i)
      if (rows[i].station == station.at("id").get<std::uint32_t>()) index.push_back(i);
    if (index.empty()) continue;
    const Row& first = rows[index[0]];
    std::vector<float> v[3];
    Vec3 place;
    double* p[3]{&place.x, &place.y, &place.z};
    for (std::size_t a = 0; a < 3; ++a) {
      for (const std::uint32_t i : index) v[a].push_back(static_cast<float>(rows[i].xyz[a] - first.xyz[a]));
      v[a].resize(index.size() + 16, 0.0f);
      *p[a] = (station.at("position")[a].get<double>() - layout.offset[a]) / layout.scale[a] - first.xyz[a];
    }
    MixedPixelParams params;
    params.jump = 8 * truth.at("noise").at("range_m").get<double>() / layout.scale[0];
    params.max_angle = 2 * station.at("step_horizontal_deg").get<double>() * 0.017453292519943295;
    const Kept stays = mixed_pixel_filter({v[0].data(), v[1].data(), v[2].data(), index.size()}, place, params);
    for (std::size_t i = 0; i < index.size(); ++i) kept[index[i]] = stays[i];
  }
  std::size_t to = 0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (kept[i] == 0)
      s.dropped_class.push_back(rows[i].true_class);
    else
      rows[to++] = rows[i];
  }
  rows.resize(to);
}

}  // namespace

Scene load_scene(const std::filesystem::path& file, int k, Cleaning cleaning) {
  const auto reader = open_cloud(file);
  const RecordLayout& layout = reader->info().layout;
  std::vector<Row> rows = read_rows(*reader);
  std::filesystem::path beside = file;
  beside.replace_extension(".truth.json");
  std::ifstream in(beside);
  if (!in) throw std::runtime_error("no truth beside it: " + beside.string());
  const Json truth = Json::parse(in);
  Scene s;
  if (cleaning == Cleaning::kMixedPixels) clean(s, rows, truth, layout);
  std::int32_t low[3]{INT32_MAX, INT32_MAX, INT32_MAX};
  for (const Row& r : rows)
    for (int a = 0; a < 3; ++a) low[a] = std::min(low[a], r.xyz[a]);
  std::vector<std::uint64_t> codes;
  for (const Row& r : rows)
    codes.push_back(
        morton_code({static_cast<std::uint32_t>(r.xyz[0] - low[0]), static_cast<std::uint32_t>(r.xyz[1] - low[1]),
                     static_cast<std::uint32_t>(r.xyz[2] - low[2])}));
  s.unit_metres = layout.scale[0];
  const bool coloured = rgb_offset(layout.point_format).has_value();
  for (const std::uint32_t i : sorted_order(codes)) {
    const Row& r = rows[i];
    s.x.push_back(static_cast<float>(r.xyz[0] - low[0]));
    s.y.push_back(static_cast<float>(r.xyz[1] - low[1]));
    s.z.push_back(static_cast<float>(r.xyz[2] - low[2]));
    s.true_class.push_back(r.true_class);
    s.true_plane.push_back(r.true_plane);
    s.intensity.push_back(r.intensity);
    if (!coloured) continue;
    s.red.push_back(static_cast<std::uint8_t>(r.rgb[0] >> 8));
    s.green.push_back(static_cast<std::uint8_t>(r.rgb[1] >> 8));
    s.blue.push_back(static_cast<std::uint8_t>(r.rgb[2] >> 8));
  }
  for (auto* v : {&s.x, &s.y, &s.z}) v->resize(s.size() + 16, 0.0f);
  for (const auto& [number, name] : truth.at("classes").items())
    if (number != "0") s.classes[static_cast<std::uint32_t>(std::stoul(number))] = name;
  Vec3 origin;
  double* o[3]{&origin.x, &origin.y, &origin.z};
  for (std::size_t a = 0; a < 3; ++a) *o[a] = low[a] * layout.scale[a] + layout.offset[a];
  if (truth.contains("shapes"))
    for (const Json& j : truth.at("shapes")) s.shapes.push_back(true_shape(j, origin, s.unit_metres));
  estimate(s, k);
  return s;
}

}  // namespace ilot::bench
