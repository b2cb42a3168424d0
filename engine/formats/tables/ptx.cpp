// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/ptx.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string>

#include "engine/error.h"
#include "engine/formats/scan_steps.h"
#include "engine/formats/tables/lines.h"
#include "engine/formats/tables/table.h"

namespace ilot {
namespace {

constexpr std::size_t kHeadLines = 10, kMostNumbers = 8, kMostBlocks = 10000;
constexpr std::uint64_t kMostCells = std::uint64_t{1} << 44;
constexpr std::uint64_t kProbes = 8;          // places of a scan where its angular steps are measured
constexpr std::uint64_t kProbeCells = 40000;  // greatest number at each of them

// One scan of the file.
struct Block {
  std::uint64_t offset = 0;  // of its first point
  std::uint64_t line = 0;    // number of that line
  std::uint64_t declared = 0, points = 0;
  std::uint64_t rows = 0;             // points of a column; the points of a column are consecutive
  std::vector<std::uint64_t> probes;  // offsets of lines where a column begins, distributed evenly over the scan
  std::uint64_t probe_columns = 1;    // between them
  Vec3 position;
  std::array<Vec3, 4> matrix{};  // rows: images of the axes, translation
};

using Numbers = std::array<double, kMostNumbers>;

// Returns the number of values of a line of numbers; 0 when there are none, too many, or other content.
std::size_t parse_line(std::string_view line, const TextDialect& dialect, std::vector<std::string_view>& fields,
                       Numbers& values) {
  split_row(line, dialect, kMostNumbers, fields);
  for (std::size_t i = 0; i < fields.size(); ++i)
    if (!parse_number(fields[i], dialect, values[i])) return 0;
  return fields.size();
}

bool is_empty_line(std::string_view line) {
  return line.find_first_not_of(" \t") == std::string_view::npos;
}

bool is_count(double v) {
  return v >= 0 && v <= 1e9 && v == std::floor(v);
}

// Uses the header and the first rows of the file, without the numbers of columns and rows in front of them.
TextDialect dialect_of(const InputFile& file, const OpenOptions& options) {
  if (options.dialect) return *options.dialect;
  constexpr std::size_t kCounts[] = {3, 4, 6, 7};
  LineReader lines(file, 0);
  std::vector<std::string> rows;
  for (std::string_view line; rows.size() < kSample && lines.next(line);)
    if (line.find_first_not_of("0123456789 \t") != std::string_view::npos) rows.emplace_back(line);
  return find_dialect(rows, 0, kCounts, file.path().string()).dialect;
}

enum class Head { found, end_of_file, malformed };

// Reads the ten lines before the points, and blank lines before them; `number` counts lines.
Head read_head(LineReader& lines, const TextDialect& dialect, std::uint64_t& number, Block& block) {
  constexpr std::size_t kExpected[kHeadLines] = {1, 1, 3, 3, 3, 3, 4, 4, 4, 4};
  std::array<Numbers, kHeadLines> n{};
  std::vector<std::string_view> fields;
  std::string_view line;
  do {
    if (!lines.next(line)) return Head::end_of_file;
    ++number;
  } while (is_empty_line(line));
  for (std::size_t i = 0; i < kHeadLines; ++i) {
    if (i > 0 && !lines.next(line)) return Head::malformed;
    if (parse_line(line, dialect, fields, n[i]) != kExpected[i]) return Head::malformed;
    if (!std::all_of(n[i].begin(), n[i].end(), [](double v) { return std::isfinite(v); })) return Head::malformed;
  }
  number += kHeadLines - 1;
  if (!is_count(n[0][0]) || !is_count(n[1][0]) || n[9][3] != 1) return Head::malformed;
  const auto columns = static_cast<std::uint64_t>(n[0][0]);
  block.rows = static_cast<std::uint64_t>(n[1][0]);
  block.declared = columns * block.rows;
  block.probe_columns = std::max<std::uint64_t>(1, columns / kProbes);
  block.position = {n[2][0], n[2][1], n[2][2]};
  for (std::size_t i = 0; i < 4; ++i) block.matrix[i] = {n[6 + i][0], n[6 + i][1], n[6 + i][2]};
  block.offset = lines.offset();
  return block.declared <= kMostCells ? Head::found : Head::malformed;
}

struct Walk {
  std::vector<Block> blocks;
  std::string problem;  // the reason for an end before the end of the file
};

// Counts the lines of every block. Blank lines are not counted.
Walk walk_blocks(const InputFile& file, const TextDialect& dialect) {
  LineReader lines(file, 0);
  Walk walk;
  std::string_view line;
  std::uint64_t number = 0;
  for (;;) {
    Block block;
    const Head head = read_head(lines, dialect, number, block);
    if (head == Head::end_of_file) return walk;
    if (head == Head::malformed || walk.blocks.size() == kMostBlocks) {
      walk.problem = head == Head::malformed ? "the head of a scan at line " + std::to_string(number) + " is malformed"
                                             : "it contains more than " + std::to_string(kMostBlocks) + " scans";
      return walk;
    }
    block.line = number + 1;
    for (std::uint64_t offset = lines.offset(); block.points < block.declared && lines.next(line);
         offset = lines.offset()) {
      ++number;
      if (is_empty_line(line)) continue;
      if (block.points % (block.rows * block.probe_columns) == 0) block.probes.push_back(offset);
      ++block.points;
    }
    walk.blocks.push_back(block);
  }
}

// Returns directions in the frame of the scanner, at some of the columns and the columns beside them.
std::vector<GridPoint> probe_grid(const InputFile& file, const TextDialect& dialect, const Block& block) {
  std::vector<GridPoint> points;
  std::vector<std::string_view> fields;
  std::string_view line;
  Numbers n{};
  for (std::uint64_t probe = 0; probe < block.probes.size(); ++probe) {
    LineReader lines(file, block.probes[probe]);
    const std::uint64_t first = probe * block.rows * block.probe_columns;
    for (std::uint64_t i = first; i < std::min(first + kProbeCells, block.points) && lines.next(line);) {
      if (is_empty_line(line)) continue;
      const auto row = static_cast<std::int64_t>(i % block.rows), column = static_cast<std::int64_t>(i / block.rows);
      ++i;
      if (parse_line(line, dialect, fields, n) < 3 || (n[0] == 0 && n[1] == 0 && n[2] == 0)) continue;
      points.push_back({row, column, {n[0], n[1], n[2]}});
    }
  }
  return points;
}

// Returns the place of the scanner and its rotation. The rows of the matrix are the images of the axes.
Station station_of(const InputFile& file, const TextDialect& dialect, const Block& block, const std::string& name) {
  const AngularSteps steps = steps_of_grid(probe_grid(file, dialect, block));
  Station station{name, block.position, steps.azimuth, steps.elevation};
  const double length = norm(block.matrix[2]);
  if (length > 0) station.axis = (1 / length) * block.matrix[2];
  return station;
}

struct Content {
  bool intensity = false, colour = false;
};

// Returns the meaning of the numbers on the line of a point: x y z, then intensity, red green blue, or both.
std::optional<Content> content_of(std::size_t numbers) {
  if (numbers == 3) return Content{};
  if (numbers == 4) return Content{true, false};
  if (numbers == 6) return Content{false, true};
  if (numbers == 7) return Content{true, true};
  return std::nullopt;
}

class PtxReader final : public PointReader {
 public:
  PtxReader(std::unique_ptr<InputFile> file, const TextDialect& dialect, Walk walk)
      : file_(std::move(file)), dialect_(dialect), blocks_(std::move(walk.blocks)), lines_(*file_, 0) {
    info_.path = file_->path();
    info_.format = "ptx";
    info_.dialect = description_of(dialect_);
    for (const Block& block : blocks_) {
      const std::string name = "scan " + std::to_string(info_.scans.size() + 1);
      info_.scans.push_back({name, block.points});
      info_.stations.push_back(station_of(*file_, dialect_, block, name));
      if (info_.scans.size() <= UINT16_MAX)  // as in the rows
        info_.stations.back().source_id = static_cast<std::uint16_t>(info_.scans.size());
      info_.declared_points += block.declared;
      info_.points += block.points;
    }
    set_points(info_, info_.points);
    if (!walk.problem.empty()) info_.warnings.push_back(walk.problem + "; the file is read up to there");
    plan_rows();
    rewind();
  }

  const CloudInfo& info() const override { return info_; }
  bool random_access() const override { return false; }
  std::vector<std::uint64_t> boundaries() const override {
    return info_.points == 0 ? std::vector<std::uint64_t>{0} : std::vector<std::uint64_t>{0, info_.points};
  }

  std::size_t read(std::uint64_t first, std::span<std::byte> records, std::span<std::uint8_t> valid) override {
    if (first < row_) rewind();
    std::string_view line;
    while (row_ < first && next_row(line)) {
    }
    const std::size_t length = info_.layout.record_length;
    const std::size_t rows = std::min(records.size() / length, valid.size());
    std::size_t done = 0;
    for (; done < rows && next_row(line); ++done) {
      const std::span<std::byte> record = records.subspan(done * length, length);
      valid[done] = parse_row(line) && plan_->encode(values_, record);
      if (!valid[done]) std::fill(record.begin(), record.end(), std::byte{0});
    }
    if (row_ == info_.points) {
      report_malformed();
      lines_.release();
    }
    return done;
  }

 private:
  void rewind() {
    row_ = in_block_ = malformed_ = 0;
    block_ = 0;
    if (!blocks_.empty()) enter(0);
  }

  void enter(std::size_t block) {
    block_ = block;
    in_block_ = 0;
    line_ = blocks_[block].line - 1;
    lines_ = LineReader(*file_, blocks_[block].offset);
  }

  // Finds the next line of a point.
  bool next_row(std::string_view& line) {
    while (block_ < blocks_.size() && in_block_ == blocks_[block_].points) {
      if (block_ + 1 == blocks_.size()) return false;
      enter(block_ + 1);
    }
    while (block_ < blocks_.size() && lines_.next(line)) {
      ++line_;
      if (is_empty_line(line)) continue;
      ++in_block_;
      ++row_;
      return true;
    }
    return false;
  }

  // Reads the values of the columns; false for cells without a return and for lines that are not points.
  bool parse_row(std::string_view line) {
    Numbers n{};
    const std::size_t count = parse_line(line, dialect_, fields_, n);
    const auto content = content_of(count);
    if (!content) {
      if (malformed_++ == 0) first_malformed_ = line_;
      return false;
    }
    if (n[0] == 0 && n[1] == 0 && n[2] == 0) return false;
    const std::array<Vec3, 4>& m = blocks_[block_].matrix;
    const Vec3 p = n[0] * m[0] + n[1] * m[1] + n[2] * m[2] + m[3];
    std::size_t at = 0;
    for (const double v : {p.x, p.y, p.z, static_cast<double>(block_ + 1)}) values_[at++] = v;
    if (content_.intensity) values_[at++] = content->intensity ? std::clamp(n[3], 0.0, 1.0) * 65535 : 0;
    if (content_.colour)
      for (std::size_t i = 0; i < 3; ++i) values_[at++] = content->colour ? n[count - 3 + i] : 0;
    return true;
  }

  // The columns follow from the first points of every block, the lattice from some points of each.
  void plan_rows() {
    std::string_view line;
    Numbers n{};
    const std::size_t each = blocks_.empty() ? 0 : std::max<std::size_t>(1, kSample / blocks_.size());
    for (std::size_t b = 0; b < std::min(blocks_.size(), kSample); ++b) {
      enter(b);
      if (blocks_[b].points == 0 || !next_row(line)) continue;
      const auto content = content_of(parse_line(line, dialect_, fields_, n));
      content_.intensity = content_.intensity || (content && content->intensity);
      content_.colour = content_.colour || (content && content->colour);
    }
    std::vector<TableColumn> columns{
        {"x", FieldType::f64}, {"y", FieldType::f64}, {"z", FieldType::f64}, {"point source id", FieldType::u16}};
    if (content_.intensity) columns.push_back({"intensity", FieldType::u16});
    if (content_.colour)
      for (const char* name : {"red", "green", "blue"}) columns.push_back({name, FieldType::u8});
    values_.resize(columns.size());
    plan_.emplace(info_.path, columns, sample(each));
    info_.layout = plan_->layout();
    note_lattice(info_, plan_->lattice());
  }

  // Grids usually begin with cells without a return, so it reads more cells than it takes as points.
  std::vector<double> sample(std::size_t each) {
    constexpr std::size_t kLookFarther = 1000;
    std::vector<double> values;
    std::string_view line;
    for (std::size_t b = 0; b < std::min(blocks_.size(), kSample); ++b) {
      enter(b);
      std::size_t taken = 0;
      for (std::size_t i = 0; i < kLookFarther * each && taken < each && in_block_ < blocks_[b].points; ++i) {
        if (!next_row(line)) break;
        if (!parse_row(line)) continue;
        values.insert(values.end(), values_.begin(), values_.end());
        ++taken;
      }
    }
    return values;
  }

  void report_malformed() {
    if (malformed_ == 0 || reported_) return;
    reported_ = true;
    info_.warnings.push_back(std::to_string(malformed_) + " lines are not points of a PTX file and are rejected, the " +
                             "first is line " + std::to_string(first_malformed_));
  }

  std::unique_ptr<InputFile> file_;
  TextDialect dialect_;
  std::vector<Block> blocks_;
  LineReader lines_;
  CloudInfo info_;
  Content content_;
  std::optional<TablePlan> plan_;
  std::vector<double> values_;
  std::vector<std::string_view> fields_;
  std::size_t block_ = 0;
  std::uint64_t in_block_ = 0, row_ = 0, line_ = 0, malformed_ = 0, first_malformed_ = 0;
  bool reported_ = false;
};

}  // namespace

std::unique_ptr<PointReader> open_ptx(std::unique_ptr<InputFile> file, const OpenOptions& options) {
  const TextDialect dialect = dialect_of(*file, options);
  Walk walk = walk_blocks(*file, dialect);
  if (walk.blocks.empty())
    throw Error(file->path().string() + ": is not a PTX file (its first ten lines are not columns, rows, position, " +
                "axes and matrix); export it again");
  return std::make_unique<PtxReader>(std::move(file), dialect, std::move(walk));
}

}  // namespace ilot
