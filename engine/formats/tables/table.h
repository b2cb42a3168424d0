// SPDX-License-Identifier: Apache-2.0
// Formats that are tables of numbers (PLY, PCD, text) become LAS rows here: columns find their field by name, the
// others become extra bytes.
#pragma once
#include <array>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"
#include "engine/formats/tables/table_lattice.h"
#include "engine/formats/tables/text_dialect.h"

namespace ilot {

// A column as the file has it. Values travel as double: integers above 2^53 lose their last bits.
struct TableColumn {
  std::string name;
  FieldType type = FieldType::f64;  // f64 also for text, where the values decide the range of colours
};

// Which columns are x, y and z; columns.size() for one that is missing.
std::array<std::size_t, 3> coordinate_columns(std::span<const TableColumn> columns);

// True when the names contain x, y and z (or easting, northing, elevation), whatever their case.
bool has_coordinates(std::span<const TableColumn> columns);

// How values become rows: point format 6, 7 with colours, 8 with colours and near infrared; scale and offset as
// LatticeSurvey chooses them. Colours of 8 bits are multiplied by 257, colours and intensities that are fractions up to
// 1 by 65535.
class TablePlan {
 public:
  // `sample`: leading rows, columns.size() values each; `spread`: others from all over the file, which the lattice must
  // suit too. Throws Error naming the file when x, y or z is missing or the record would exceed 65,535 bytes.
  // `lattice`: of all rows, where somebody looked at them; else that of the two samples.
  TablePlan(const std::filesystem::path& path, std::span<const TableColumn> columns, std::span<const double> sample,
            std::span<const double> spread = {}, const std::optional<TableLattice>& lattice = std::nullopt);

  const RecordLayout& layout() const { return layout_; }
  const TableLattice& lattice() const { return lattice_; }
  std::size_t columns() const { return targets_.size(); }

  // Fills one row; false (row zeroed) when a coordinate is not finite or does not fit 32 bits. Thread-safe.
  bool encode(std::span<const double> values, std::span<std::byte> row) const;

 private:
  struct Target {
    int role = 0;
    double factor = 1;
    std::size_t extra = 0;  // index in layout_.extra
  };
  void add_extra(const std::filesystem::path& path, const TableColumn& column, Target& target);
  void choose_format();
  void choose_factors(std::span<const TableColumn> columns, std::span<const double> sample);

  std::vector<Target> targets_;
  RecordLayout layout_;
  TableLattice lattice_;
};

// Sets info.points (and declared_points when nothing was declared), with a warning when they are fewer than declared.
void set_points(CloudInfo& info, std::uint64_t points);

// Adds warnings of what the lattice leaves out or rounds more than people expect.
void note_lattice(CloudInfo& info, const TableLattice& lattice);

// Fixed-size rows in a file or in memory. Random access.
struct BinaryBody {
  std::uint64_t offset = 0;  // of the first row
  std::uint64_t rows = 0;    // that are whole
  std::size_t stride = 0;
  std::vector<std::size_t> places;  // of each column in a row
  bool big_endian = false;
  std::function<std::size_t(std::uint64_t offset, std::span<std::byte> out)> read_at;  // thread-safe
};
std::unique_ptr<PointReader> open_binary_table(CloudInfo info, std::vector<TableColumn> columns, BinaryBody body);

// Lines of numbers. Opening reads the file once, for the lattice and for warnings; then rows are read front to back by
// one thread. Lines that are not as many numbers of the dialect as there are columns are rejected rows: one warning
// counts them and names the first. So are places beyond the range of the lattice.
struct TextBody {
  std::uint64_t offset = 0;              // of the first line of data
  std::uint64_t first_line = 1;          // its number, for warnings
  std::uint64_t most_rows = UINT64_MAX;  // lines behind these are not points
  bool counts_between = false;           // a line of one count begins another block, and adds to declared_points
  std::function<void(std::span<double>)> convert;  // applied to the values of each row; may be empty
  std::optional<TextDialect> dialect;              // none: any separators, as PLY and PCD have them
  bool degrees = false;                            // what x and y are
};
std::unique_ptr<PointReader> open_text_table(std::unique_ptr<InputFile> file, CloudInfo info,
                                             std::vector<TableColumn> columns, TextBody body);

}  // namespace ilot
