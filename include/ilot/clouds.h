// SPDX-License-Identifier: Apache-2.0
// Point clouds in and out: LAS, LAZ, COPC, E57, PTX, PTS, PLY, PCD and text in; LAS, LAZ, COPC and PLY out.
//
//   ilot::CloudFile cloud("district.laz");
//   ilot::PointColumns points;
//   for (std::uint64_t at = 0; cloud.read(at, 1u << 20, points) > 0; at += 1u << 20) {
//     // points.x[i], points.y[i], points.z[i], points.classification[i] ...
//   }
//
// Memory is that of the piece that is read and a few MiB. Files are taken to be hostile: an unreadable one is an Error
// at open, a damaged one gives the points that are whole and a warning.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "ilot/cloud_info.h"
#include "ilot/geometry.h"

namespace ilot {

// What a file says of itself. Declared values come from the header and are not trusted: measure() looks.
struct CloudDescription {
  std::filesystem::path path;
  std::string format;   // "las", "laz", "copc", "ply", "text", "pcd", "e57", "ptx"
  std::string dialect;  // of text, for people; else empty
  Crs crs;
  std::uint64_t points = 0, declared_points = 0;  // that can be read; that the header claims
  Vec3 declared_min, declared_max;                // CRS units
  Vec3 scale;                                     // coordinates are whole multiples of it, but for an offset; CRS units
  bool has_colour = false, has_gps_time = false;
  std::vector<std::string> extra;  // names of further attributes (LAS extra bytes)
  std::vector<Station> stations;
  std::vector<ScanPart> scans;
  std::vector<std::string> warnings;
};

// Points as arrays of one length. Those of what a cloud does not have are empty.
struct PointColumns {
  std::vector<double> x, y, z;                  // CRS units
  std::vector<std::uint16_t> intensity;         // as in the file
  std::vector<std::uint8_t> classification;     // ASPRS codes: 2 ground, 6 building
  std::vector<std::uint16_t> red, green, blue;  // 0 to 65535
  std::vector<std::vector<double>> extra;       // one a name that was asked for, in that order
  std::size_t size() const { return x.size(); }
  PointArrays places() const { return {x, y, z}; }  // for the functions over points in memory
};

// The caller's own arrays, of one length each or empty: attributes that are not wanted.
struct PointSpans {
  std::span<double> x, y, z;
  std::span<std::uint16_t> intensity = {};
  std::span<std::uint8_t> classification = {};
  std::span<std::uint16_t> red = {}, green = {}, blue = {};
};

// An open cloud. May be moved, not copied; one thread at a time. Opening O(header); of text the file is looked through.
class CloudFile {
 public:
  // By content first, extension second. `dialect`: of text; none: found from the rows.
  explicit CloudFile(const std::filesystem::path& path, const std::optional<TextDialect>& dialect = {});
  ~CloudFile();
  CloudFile(CloudFile&&) noexcept;
  CloudFile& operator=(CloudFile&&) noexcept;

  const CloudDescription& description() const;

  // Reads the points of the rows `first` to first + most - 1, as far as there are any. Returns how many rows there
  // were; 0 = the end. Points whose coordinates are unusable are left out, so there may be fewer points than rows. Rows
  // are best read front to back, and text and ASCII PLY have to be. Decodes what is asked for alone.
  std::uint64_t read(std::uint64_t first, std::uint64_t most, PointColumns& points,
                     std::span<const std::string> extra = {});

  // The same into the caller's arrays, as many rows as x has room for; returns the rows and sets `points` to how many
  // of the entries are points. Arrays of what the cloud does not have are set to 0.
  std::uint64_t read(std::uint64_t first, const PointSpans& arrays, std::size_t& points);

  // What the points really are, as `ilot info` tells: bounds, classes, density, sampling step, strays. Reads the cloud
  // two or three times, in less than 64 MiB.
  CloudMeasure measure();

  // What is odd about the cloud, and which products it suits, given its measure.
  std::vector<std::string> warnings(const CloudMeasure& measure) const;
  std::vector<CloudSuitability> suitability(const CloudMeasure& measure) const;

 private:
  struct State;
  std::unique_ptr<State> state_;
};

struct CloudWriterOptions {
  std::string crs;            // "EPSG:2154", or empty: not said
  double scale = 0.001;       // coordinates are rounded to multiples of it, CRS units
  Vec3 offset;                // near the points: 2^31 scales from it at most
  bool colour = false;        // red, green and blue are written
  std::string software = {};  // "generating software" of LAS; empty = ilot and its version
};

// A cloud in the making; the extension names the format: .las, .laz, .copc.laz, .ply. The file appears whole under its
// name at finish(), or not at all. LAS 1.4, point format 6, or 7 with colour. One thread at a time; compression below
// runs on all threads. Error (usage) for other extensions, for arrays of different lengths, and for coordinates beyond
// the reach of the scale.
class CloudWriter {
 public:
  explicit CloudWriter(const std::filesystem::path& path, const CloudWriterOptions& options = {});
  ~CloudWriter();
  CloudWriter(CloudWriter&&) noexcept;
  CloudWriter& operator=(CloudWriter&&) noexcept;

  // Appends points; empty arrays of attributes count as zeros, `extra` is not written.
  void write(const PointColumns& points);
  void finish();

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace ilot
