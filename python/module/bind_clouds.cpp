// SPDX-License-Identifier: Apache-2.0
#include <pybind11/stl.h>
#include <pybind11/stl/filesystem.h>

#include <algorithm>
#include <cmath>

#include "ilot/clouds.h"
#include "python/module/arrays.h"
#include "python/module/bindings.h"

namespace ilot {

namespace {

py::object crs_text(const Crs& crs) {
  if (crs.epsg > 0) return py::str("EPSG:" + std::to_string(crs.epsg));
  if (!crs.wkt.empty()) return py::str(crs.wkt);
  return py::none();
}

void add_unless_empty(py::dict& out, const char* name, std::vector<std::uint16_t>&& values) {
  if (!values.empty()) out[name] = array_from(std::move(values));
}

py::dict dict_of(PointColumns&& points, const std::vector<std::string>& extra) {
  py::dict out;
  out["x"] = array_from(std::move(points.x));
  out["y"] = array_from(std::move(points.y));
  out["z"] = array_from(std::move(points.z));
  add_unless_empty(out, "intensity", std::move(points.intensity));
  if (!points.classification.empty()) out["classification"] = array_from(std::move(points.classification));
  add_unless_empty(out, "red", std::move(points.red));
  add_unless_empty(out, "green", std::move(points.green));
  add_unless_empty(out, "blue", std::move(points.blue));
  for (std::size_t i = 0; i < points.extra.size(); ++i) out[extra[i].c_str()] = array_from(std::move(points.extra[i]));
  return out;
}

py::dict read_cloud_python(const std::filesystem::path& path, std::uint64_t first, const py::object& most,
                           const std::vector<std::string>& extra) {
  PointColumns points;
  {
    const std::uint64_t rows = most.is_none() ? UINT64_MAX - first : most.cast<std::uint64_t>();
    const py::gil_scoped_release released;
    CloudFile cloud(path);
    cloud.read(first, std::min(rows, cloud.description().points), points, extra);
  }
  return dict_of(std::move(points), extra);
}

py::dict dict_of(const CloudDescription& d) {
  py::dict out;
  out["path"] = d.path;
  out["format"] = d.format;
  out["points"] = d.points;
  out["declared_points"] = d.declared_points;
  out["crs"] = crs_text(d.crs);
  out["metres_per_unit"] = d.crs.metres_per_unit;
  out["scale"] = tuple_of(d.scale);
  out["has_colour"] = d.has_colour;
  out["extra"] = d.extra;
  out["warnings"] = d.warnings;
  return out;
}

py::dict info_python(const std::filesystem::path& path) {
  std::optional<CloudFile> cloud;
  CloudMeasure measure;
  {
    const py::gil_scoped_release released;
    cloud.emplace(path);
    measure = cloud->measure();
  }
  py::dict out = dict_of(cloud->description());
  out["min"] = tuple_of(measure.min);
  out["max"] = tuple_of(measure.max);
  out["valid_points"] = measure.points;
  out["rejected"] = measure.rejected;
  out["strays"] = measure.strays;
  py::dict classes;
  for (std::size_t c = 0; c < measure.classes.size(); ++c)
    if (measure.classes[c] > 0) classes[py::int_(c)] = measure.classes[c];
  out["classes"] = classes;
  out["area_m2"] = measure.occupied_area;
  out["density"] = measure.density;
  out["sampling_step_m"] = measure.sampling_step;
  out["warnings"] = cloud->warnings(measure);
  py::dict suits;
  for (const CloudSuitability& s : cloud->suitability(measure))
    suits[s.product.c_str()] = py::make_tuple(s.yes, s.reason);
  out["suits"] = suits;
  return out;
}

template <typename T>
void append_piece(std::vector<T>& to, std::span<const T> from, std::size_t at, std::size_t count) {
  to.assign(from.begin() + static_cast<std::ptrdiff_t>(at), from.begin() + static_cast<std::ptrdiff_t>(at + count));
}

void check_lengths(const ArrayCloud& a) {
  const std::size_t points = a.x.size();
  for (const std::size_t other : {a.y.size(), a.z.size()})
    if (other != points) throw Error("x, y and z have different lengths", ExitCode::usage);
  for (const std::size_t other :
       {a.intensity.size(), a.classification.size(), a.red.size(), a.green.size(), a.blue.size()})
    if (other != 0 && other != points)
      throw Error("an attribute has " + std::to_string(other) + " values for " + std::to_string(points) + " points",
                  ExitCode::usage);
}

// In pieces, so that the copies stay small.
void write_arrays(CloudWriter& writer, const ArrayCloud& a) {
  constexpr std::size_t kPiece = std::size_t{1} << 18;
  PointColumns piece;
  for (std::size_t at = 0; at < a.x.size(); at += kPiece) {
    const std::size_t count = std::min(kPiece, a.x.size() - at);
    append_piece(piece.x, a.x, at, count);
    append_piece(piece.y, a.y, at, count);
    append_piece(piece.z, a.z, at, count);
    if (!a.intensity.empty()) append_piece(piece.intensity, a.intensity, at, count);
    if (!a.classification.empty()) append_piece(piece.classification, a.classification, at, count);
    if (!a.red.empty()) append_piece(piece.red, a.red, at, count);
    if (!a.green.empty()) append_piece(piece.green, a.green, at, count);
    if (!a.blue.empty()) append_piece(piece.blue, a.blue, at, count);
    writer.write(piece);
  }
}

void write_cloud_python(const std::filesystem::path& path, const py::object& x, const py::object& y,
                        const py::object& z, const py::dict& attributes, const std::string& crs, double scale) {
  const ArrayCloud a = cloud_of(x, y, z, attributes);
  check_lengths(a);
  CloudWriterOptions options;
  options.crs = crs;
  options.scale = scale;
  if (!a.x.empty()) options.offset = {std::floor(a.x[0]), std::floor(a.y[0]), std::floor(a.z[0])};
  options.colour = !a.red.empty() || !a.green.empty() || !a.blue.empty();
  const py::gil_scoped_release released;
  CloudWriter writer(path, options);
  write_arrays(writer, a);
  writer.finish();
}

}  // namespace

void bind_clouds(py::module_& m) {
  using py::arg;
  m.def("read_cloud", &read_cloud_python, arg("path"), arg("first"), arg("most"), arg("extra"));
  m.def("info", &info_python, arg("path"));
  m.def("write_cloud", &write_cloud_python, arg("path"), arg("x"), arg("y"), arg("z"), arg("attributes"), arg("crs"),
        arg("scale"));
}

}  // namespace ilot
