// SPDX-License-Identifier: Apache-2.0
// Converts formats that are tables of numbers (PLY, PCD, text) to LAS rows. Columns are assigned to fields by name; the
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

constexpr std::size_t kMostColumns = 1000;  // a file with more is refused

// A column as it is in the file. Values are passed as double, so integers above 2^53 lose their last bits.
struct TableColumn {
  std::string name;
  FieldType type = FieldType::f64;  // f64 also for text, where the values determine the range of colours
};

// Returns which columns are x, y and z; columns.size() for a missing one.
std::array<std::size_t, 3> coordinate_columns(std::span<const TableColumn> columns);

// True when the names contain x, y and z (or easting, northing, elevation) in any case.
bool has_coordinates(std::span<const TableColumn> columns);

// The conversion of values to rows: point format 6, 7 with colours, 8 with colours and near infrared; scale and offset
// as LatticeSurvey chooses them. Colours of 8 bits are multiplied by 257. Colours and intensities that are fractions up
// to 1 are multiplied by 65535.
class TablePlan {
 public:
  // `sample` has the first rows, columns.size() values each. `spread` has rows from the whole file, which the lattice
  // must fit too. `lattice` is that of all rows, if all rows were read; otherwise the lattice of the two samples is
  // used. Throws Error that names the file when x, y or z is missing or the record would exceed 65,535 bytes.
  TablePlan(const std::filesystem::path& path, std::span<const TableColumn> columns, std::span<const double> sample,
            std::span<const double> spread = {}, const std::optional<TableLattice>& lattice = std::nullopt);

  const RecordLayout& layout() const { return layout_; }
  const TableLattice& lattice() const { return lattice_; }
  std::size_t columns() const { return targets_.size(); }

  // Fills one row. False (and the row is zeroed) when a coordinate is not finite or does not fit 32 bits. Thread-safe.
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

// Sets info.points (and declared_points when nothing was declared). Adds a warning when there are fewer points than
// declared.
void set_points(CloudInfo& info, std::uint64_t points);

// Adds warnings when the lattice leaves out rows or rounds more than people expect.
void note_lattice(CloudInfo& info, const TableLattice& lattice);

// Rows of fixed size in a file or in memory. Random access.
struct BinaryBody {
  std::uint64_t offset = 0;  // of the first row
  std::uint64_t rows = 0;    // number of complete rows
  std::size_t stride = 0;
  std::vector<std::size_t> places;  // of each column in a row
  bool big_endian = false;
  std::function<std::size_t(std::uint64_t offset, std::span<std::byte> out)> read_at;  // thread-safe
};
std::unique_ptr<PointReader> open_binary_table(CloudInfo info, std::vector<TableColumn> columns, BinaryBody body);

// Lines of numbers. Opening reads the file once, for the lattice and for warnings; then rows are read front to back by
// one thread. A line is a rejected row unless it has as many numbers of the dialect as there are columns. One warning
// counts these lines and names the first. Places beyond the range of the lattice are rejected rows too.
struct TextBody {
  std::uint64_t offset = 0;              // of the first line of data
  std::uint64_t first_line = 1;          // its number in the file, for warnings
  std::uint64_t most_rows = UINT64_MAX;  // lines behind these are not points
  bool counts_between = false;           // a line with a single count begins another block and adds to declared_points
  std::function<void(std::span<double>)> convert;  // applied to the values of each row; may be empty
  std::optional<TextDialect> dialect;              // none: any separators, as PLY and PCD have them
  bool degrees = false;                            // x and y are degrees
};
std::unique_ptr<PointReader> open_text_table(std::unique_ptr<InputFile> file, CloudInfo info,
                                             std::vector<TableColumn> columns, TextBody body);

}  // namespace ilot
