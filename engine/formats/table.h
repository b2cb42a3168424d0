// SPDX-License-Identifier: Apache-2.0
// Formats that are tables of numbers (PLY, PCD, text) become LAS rows here: columns find their field by name, the
// others become extra bytes.
#pragma once
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"

namespace ilot {

// A column as the file has it. Values travel as double: integers above 2^53 lose their last bits.
struct Column {
  std::string name;
  FieldType type = FieldType::f64;  // f64 also for text, where the values decide the range of colours
};

// True when the names contain x, y and z (or easting, northing, elevation), whatever their case.
bool has_coordinates(std::span<const Column> columns);

// How values become rows: point format 6, 7 with colours, 8 with colours and near infrared; scale 1e-4 (1e-3
// or 1e-2 when the sample spans more than 200 or 2,000 km); offset the multiple of 1000 at or below its first finite
// point. Points more than 10 km from the sample's median decide neither, where they are at most a tenth of its places.
// Colours of 8 bits are multiplied by 257, colours and intensities that are fractions up to 1 by 65535.
class TablePlan {
 public:
  // `sample`: leading rows, columns.size() values each; `spread`: others from all over the file, which the lattice must
  // suit too. Throws Error naming the file when x, y or z is missing or the
  // record would exceed 65,535 bytes.
  TablePlan(const std::filesystem::path& path, std::span<const Column> columns, std::span<const double> sample,
            std::span<const double> spread = {});

  const RecordLayout& layout() const { return layout_; }
  std::size_t columns() const { return targets_.size(); }

  // Fills one row; false (row zeroed) when a coordinate is not finite or does not fit 32 bits. Thread-safe.
  bool encode(std::span<const double> values, std::span<std::byte> row) const;

 private:
  struct Target {
    int role = 0;
    double factor = 1;
    std::size_t extra = 0;  // index in layout_.extra
  };
  void add_extra(const std::filesystem::path& path, const Column& column, Target& target);
  void choose_format();
  void choose_factors(std::span<const Column> columns, std::span<const double> sample);
  std::vector<Vec3> points_of(std::span<const double> sample) const;
  void choose_lattice(std::span<const double> sample, std::span<const double> spread);

  std::vector<Target> targets_;
  RecordLayout layout_;
};

// Sets info.points (and declared_points when nothing was declared), with a warning when they are fewer than declared.
void set_points(CloudInfo& info, std::uint64_t points);

// Fixed-size rows in a file or in memory. Random access.
struct BinaryBody {
  std::uint64_t offset = 0;  // of the first row
  std::uint64_t rows = 0;    // that are whole
  std::size_t stride = 0;
  std::vector<std::size_t> places;  // of each column in a row
  bool big_endian = false;
  std::function<std::size_t(std::uint64_t offset, std::span<std::byte> out)> read_at;  // thread-safe
};
std::unique_ptr<PointReader> open_binary_table(CloudInfo info, std::vector<Column> columns, BinaryBody body);

// Lines of numbers, separated by blanks, tabs, commas or semicolons. Read front to back by one thread. Lines that are
// not numbers are rejected rows; when the last row is read, one warning counts them and names the first.
struct TextBody {
  std::uint64_t offset = 0;              // of the first line of data
  std::uint64_t first_line = 1;          // its number, for warnings
  std::uint64_t most_rows = UINT64_MAX;  // lines behind these are not points
  bool counts_between = false;           // a line of one count begins another block, and adds to declared_points
  std::function<void(std::span<double>)> convert;  // applied to the values of each row; may be empty
};
std::unique_ptr<PointReader> open_text_table(std::unique_ptr<InputFile> file, CloudInfo info,
                                             std::vector<Column> columns, TextBody body);

}  // namespace ilot
