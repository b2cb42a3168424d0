// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <array>
#include <cctype>
#include <cstring>
#include <string>

#include "engine/error.h"
#include "engine/formats/copc/copc.h"
#include "engine/formats/e57/e57.h"
#include "engine/formats/las/las.h"
#include "engine/formats/laz/laz.h"
#include "engine/formats/tables/pcd.h"
#include "engine/formats/tables/ply.h"
#include "engine/formats/tables/ptx.h"
#include "engine/formats/tables/text.h"

namespace ilot {
namespace {

constexpr std::size_t kSniffed = 4096;

std::string lower_extension(const std::filesystem::path& path) {
  std::string extension = path.extension().string();
  for (char& c : extension)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return extension;
}

bool is_one_of(const std::string& extension, std::initializer_list<const char*> list) {
  return std::find(list.begin(), list.end(), extension) != list.end();
}

bool starts_with(std::span<const std::byte> bytes, std::string_view text) {
  return bytes.size() >= text.size() && std::memcmp(bytes.data(), text.data(), text.size()) == 0;
}

bool looks_like_ply(std::span<const std::byte> bytes) {
  return starts_with(bytes, "ply") && bytes.size() > 3 && std::isspace(std::to_integer<unsigned char>(bytes[3]));
}

// Returns what has packed the bytes, by their magic numbers; empty: nothing that is known.
std::string_view packed_by(std::span<const std::byte> bytes) {
  if (starts_with(bytes, "\x1f\x8b")) return "gzip";
  if (starts_with(bytes, "PK\x03\x04")) return "zip";
  if (starts_with(bytes, "7z\xbc\xaf\x27\x1c")) return "7-Zip";
  return {};
}

std::unique_ptr<PointReader> open_las_family(std::unique_ptr<InputFile> file) {
  LasContainer container = parse_las(*file);
  if (container.compressed) return open_laz(std::move(file), std::move(container));
  return open_las(std::move(file), std::move(container));
}

}  // namespace

bool is_cloud_extension(const std::filesystem::path& path) {
  return is_one_of(lower_extension(path), {".las", ".laz", ".e57", ".ply", ".pcd", ".ptx", ".xyz", ".pts", ".asc"});
}

std::unique_ptr<PointReader> open_cloud(const std::filesystem::path& path, const OpenOptions& options) {
  auto file = std::make_unique<InputFile>(path);
  if (file->size() == 0) throw Error(path.string() + ": is empty; fetch or export it again");
  std::array<std::byte, kSniffed> buffer;
  const auto beginning = std::span(buffer).first(file->read_at(0, buffer));
  if (const std::string_view packer = packed_by(beginning); !packer.empty())
    throw Error(path.string() + ": is compressed (" + std::string(packer) + "); unpack it first");
  const std::string extension = lower_extension(path);
  if (looks_like_las(beginning) || is_one_of(extension, {".las", ".laz"})) return open_las_family(std::move(file));
  if (looks_like_e57(beginning) || extension == ".e57") return open_e57(std::move(file));
  if (looks_like_ply(beginning)) return open_ply(std::move(file));
  if (looks_like_pcd(beginning) || extension == ".pcd") return open_pcd(std::move(file));
  if (extension == ".ply") throw Error(path.string() + ": is not a PLY file (no ply at byte 0)");
  if (extension == ".ptx") return open_ptx(std::move(file), options);
  if (is_one_of(extension, {".xyz", ".txt", ".csv", ".pts", ".asc"})) return open_text(std::move(file), options);
  throw Error(
      path.string() +
      ": is not a point cloud that can be read (LAS, LAZ, E57, PLY, PCD, PTX, or text as .xyz .txt .csv .pts .asc)");
}

std::unique_ptr<PointWriter> create_cloud(const std::filesystem::path& path, const CloudSpec& spec) {
  const std::string extension = lower_extension(path);
  if (extension == ".las") return create_las(path, spec);
  if (is_copc_name(path)) return create_copc(path, spec);
  if (extension == ".laz") return create_laz(path, spec);
  if (extension == ".ply") return create_ply(path, spec);
  if (is_one_of(extension, {".csv", ".xyz", ".txt"})) return create_csv(path, spec);
  throw Error(path.string() + ": format \"" + extension +
                  "\" is not written; choose .las, .laz, .copc.laz, .ply, .csv, .xyz or .txt",
              ExitCode::usage);
}

std::string cloud_stem(const std::filesystem::path& path) {
  std::filesystem::path stem = path.stem();
  while (lower_extension(stem) == ".copc") stem = stem.stem();
  return stem.string();
}

std::vector<std::string> fields_lost(const std::filesystem::path& path, const RecordLayout& layout) {
  std::vector<std::string> lost;
  const bool waveforms = layout.point_format == 4 || layout.point_format == 5 || layout.point_format >= 9;
  if (is_copc_name(path) && waveforms) return {"waveforms"};
  if (is_one_of(lower_extension(path), {".las", ".laz"})) return lost;
  std::size_t described = standard_size(layout.point_format);
  for (const ExtraField& field : layout.extra) {
    described += field.size;
    if (field.type == FieldType::opaque) lost.push_back(field.name.empty() ? "unnamed extra bytes" : field.name);
  }
  if (described < layout.record_length) lost.push_back("undocumented extra bytes");
  if (waveforms) lost.push_back("waveforms");
  return lost;
}

}  // namespace ilot
