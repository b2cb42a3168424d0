// SPDX-License-Identifier: Apache-2.0
// One way into every point cloud format: open, then read rows. Each format is one file beside this one.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <memory>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "engine/cloud/cloud_info.h"
#include "engine/formats/fields.h"
#include "engine/formats/tables/text_dialect.h"

namespace ilot {

// Readers treat their input as hostile: an unreadable file is an Error at open (path, place, what to do), a damaged one
// gives the points that are whole (info().points < info().declared_points, with a warning).
class PointReader {
 public:
  virtual ~PointReader() = default;

  virtual const CloudInfo& info() const = 0;

  // Random-access formats may be read from several threads at once, in any order. The others (text, PLY ascii) must be
  // read front to back by one thread.
  virtual bool random_access() const = 0;

  // Points at which a read should start and end: units of decoding (LAZ chunks). Strictly increasing, first 0, last
  // info().points. A read across a boundary is correct but decodes both sides.
  virtual std::vector<std::uint64_t> boundaries() const = 0;

  // From now on only these attributes (of Fields) are looked at; the others may hold anything. Readers that decode
  // attribute by attribute skip the rest. Not while another thread reads.
  virtual void limit_to(std::uint32_t fields) { static_cast<void>(fields); }

  // Fills `records` (a multiple of layout.record_length) with the rows from `first` on; returns how many were whole.
  // Fewer than asked = the rest of the file is damaged (never the case for rows below info().points of binary
  // formats, unless the file changes underneath). Rows with coordinates that are not finite or do not fit are
  // marked in `valid` (same number of entries as rows): 0 = reject, content of the row undefined but for its length.
  virtual std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) = 0;
};

// What the user knows better than the file.
struct OpenOptions {
  std::optional<TextDialect> dialect;  // of text; none: found from the rows
  bool degrees = false;                // x and y of formats without a CRS are degrees, whose digits count more
};

// Opens by content first, extension second. Throws Error.
std::unique_ptr<PointReader> open_cloud(const std::filesystem::path& path, const OpenOptions& options = {});

// Extensions that folders are searched for: not .txt and .csv, which are mostly something else; name those.
bool is_cloud_extension(const std::filesystem::path& path);

}  // namespace ilot
