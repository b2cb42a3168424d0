// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/exports/roofs_meshes.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/deliverables/exports/building_mesh.h"
#include "engine/error.h"
#include "engine/model/building_geometry.h"

namespace ilot {
namespace {

constexpr std::size_t kStlHeader = 80;
constexpr double kFarthest = 16384;        // units from the origin. Derived: there float32 rounds by at most 0.49 mm
constexpr std::uint32_t kMost = 1u << 31;  // triangles or vertices: readers take the counts as signed
constexpr std::array<std::array<std::uint8_t, 3>, 3> kColours{{{184, 77, 56}, {209, 204, 194}, {115, 115, 115}}};

template <class T>
void put(std::string& text, T value) {
  text.append(reinterpret_cast<const char*>(&value), sizeof value);
}

std::span<const std::byte> bytes_of(const std::string& text) {
  return std::as_bytes(std::span(text));
}

using Corner = std::array<float, 3>;

Corner near_origin(Vec3 p, const ExportFrame& frame, const std::string& file) {
  const Vec3 d = p - frame.origin;
  if (std::max({std::abs(d.x), std::abs(d.y), std::abs(d.z)}) > kFarthest)
    throw Error(file + ": the models reach farther than " + std::to_string(static_cast<int>(kFarthest)) +
                " units from their first one, where STL cannot keep a millimetre; export ply, glb or 3dtiles");
  return {static_cast<float>(d.x), static_cast<float>(d.y), static_cast<float>(d.z)};
}

Vec3 vec(const Corner& c) {
  return {c[0], c[1], c[2]};
}

void check_count(std::uint64_t count, const std::string& file) {
  if (count > kMost) throw Error(file + ": more triangles than the format can count; export 3dtiles");
}

}  // namespace

RoofsStl::RoofsStl(const std::filesystem::path& path, const ExportFrame& frame) : file_(path), frame_(frame) {
  std::string header = fmt::format("ilot {}; add {:.0f} {:.0f} {:.0f}", frame.crs_name.substr(0, 24), frame.origin.x,
                                   frame.origin.y, frame.origin.z);
  header.resize(kStlHeader + 4, '\0');
  file_.append(bytes_of(header));
}

void RoofsStl::add(const BuildingModel& model) {
  const Building* building = finest_solid(model.levels);
  if (!building) return;
  const BuildingMesh mesh = building_mesh(*building);
  std::vector<Corner> corners;
  for (const Vec3& v : mesh.vertices) corners.push_back(near_origin(v, frame_, file_.path().string()));
  std::string text;
  for (const TriangleCorners& t : mesh.triangles) {
    const Corner &a = corners[t[0]], &b = corners[t[1]], &c = corners[t[2]];
    if (a == b || b == c || c == a) continue;  // two vertices became one float32: its neighbours meet in their edge
    const Vec3 n = cross(vec(b) - vec(a), vec(c) - vec(a));
    const double length = norm(n);
    for (const double x : {n.x, n.y, n.z}) put(text, static_cast<float>(length > 0 ? x / length : 0));
    for (const Corner& corner : {a, b, c})
      for (const float x : corner) put(text, x);
    put(text, std::uint16_t{0});
    ++triangles_;
  }
  check_count(triangles_, file_.path().string());
  file_.append(bytes_of(text));
}

void RoofsStl::finish() {
  file_.write_at(kStlHeader, std::as_bytes(std::span(&triangles_, 1)));
  file_.commit();
}

RoofsPly::RoofsPly(const std::filesystem::path& path, const ExportFrame& frame) : file_(path), frame_(frame) {
  file_.append(bytes_of(header()));
}

// The counts have room for all their digits, so that the header keeps its length.
std::string RoofsPly::header() const {
  return fmt::format(
      "ply\nformat binary_little_endian 1.0\ncomment ilot, models of buildings\ncomment crs {}\n"
      "element vertex {:010}\nproperty double x\nproperty double y\nproperty double z\n"
      "element face {:010}\nproperty list uchar uint vertex_indices\nproperty uchar red\nproperty uchar green\n"
      "property uchar blue\nproperty uchar kind\nproperty uint building\nend_header\n",
      frame_.crs_name.empty() ? "unknown" : frame_.crs_name, vertices_, triangles_);
}

void RoofsPly::add(const BuildingModel& model) {
  ++building_;
  const Building* building = finest_solid(model.levels);
  if (!building) return;
  const BuildingMesh mesh = building_mesh(*building);
  check_count(std::uint64_t{vertices_} + mesh.vertices.size(), file_.path().string());
  check_count(std::uint64_t{triangles_} + mesh.triangles.size(), file_.path().string());
  std::string text;
  for (const Vec3& v : mesh.vertices)
    for (const double x : {v.x, v.y, v.z}) put(text, x);
  file_.append(bytes_of(text));
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto kind = static_cast<std::uint8_t>(building->surfaces[mesh.surface[i]].kind);
    put(faces_, std::uint8_t{3});
    for (const std::uint32_t corner : mesh.triangles[i]) put(faces_, vertices_ + corner);
    for (const std::uint8_t c : kColours[kind]) put(faces_, c);
    put(faces_, kind);
    put(faces_, building_);
  }
  vertices_ += static_cast<std::uint32_t>(mesh.vertices.size());
  triangles_ += static_cast<std::uint32_t>(mesh.triangles.size());
}

void RoofsPly::finish() {
  file_.append(bytes_of(faces_));
  file_.write_at(0, bytes_of(header()));
  file_.commit();
}

}  // namespace ilot
