// SPDX-License-Identifier: Apache-2.0
// The one interface for reading every point cloud format: open, then read rows. Each format is one file beside this
// one.
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

// Readers do not trust their input. An unreadable file is an Error at open (path, place, what to do). A damaged file
// gives its complete points (info().points < info().declared_points, with a warning).
class PointReader {
 public:
  virtual ~PointReader() = default;

  virtual const CloudInfo& info() const = 0;

  // Formats with random access may be read from several threads at once, in any order. The others (text, PLY ascii)
  // must be read front to back by one thread.
  virtual bool random_access() const = 0;

  // Returns the points at which a read should start and end: the units of decoding (LAZ chunks). They are strictly
  // increasing, the first is 0, the last is info().points. A read across a boundary is correct but decodes both sides.
  virtual std::vector<std::uint64_t> boundaries() const = 0;

  // After this call only these attributes (of Fields) are read; the others are undefined. Readers that decode attribute
  // by attribute skip the rest. It must not be called while another thread reads.
  virtual void limit_to(std::uint32_t fields) { static_cast<void>(fields); }

  // Fills `records` (a multiple of layout.record_length) with the rows from `first` on and returns the number of
  // complete rows. Fewer than asked for means that the rest of the file is damaged. This never happens for rows below
  // info().points of binary formats, unless the file changes at the same time. Rows with coordinates that are not
  // finite or do not fit are marked in `valid` (one entry for each row): 0 = rejected; then the content of the row is
  // undefined.
  virtual std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) = 0;
};

// Information from the user that replaces that of the file.
struct OpenOptions {
  std::optional<TextDialect> dialect;  // for text; none: found from the rows
  bool degrees = false;                // x and y of formats without a CRS are degrees, which need more decimals
};

// Detects the format by content first, by extension second. Throws Error.
std::unique_ptr<PointReader> open_cloud(const std::filesystem::path& path, const OpenOptions& options = {});

// True for the extensions that are searched in folders. .txt and .csv are not among them, because they mostly have
// other content; such files must be named.
bool is_cloud_extension(const std::filesystem::path& path);

}  // namespace ilot
