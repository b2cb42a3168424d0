// SPDX-License-Identifier: Apache-2.0
#include <algorithm>
#include <charconv>
#include <limits>
#include <optional>
#include <string>

#include "engine/formats/tables/lines.h"
#include "engine/formats/tables/table.h"

namespace ilot {
namespace {

constexpr std::uint64_t kMostDeclared = 1'000'000'000'000'000;

bool is_blank_line(std::string_view line) {
  return line.find_first_not_of(" \t\r") == std::string_view::npos;
}

// Returns the number on a line that contains only one natural number.
std::optional<std::uint64_t> lone_count(std::string_view line) {
  const std::size_t begin = line.find_first_not_of(" \t");
  if (begin == std::string_view::npos || line.size() - begin > 24) return std::nullopt;
  line = line.substr(begin, line.find_last_not_of(" \t") + 1 - begin);
  std::uint64_t count = 0;
  const auto [end, error] = std::from_chars(line.data(), line.data() + line.size(), count);
  if (error != std::errc{} || end != line.data() + line.size()) return std::nullopt;
  return count;
}

class TextTable final : public PointReader {
 public:
  TextTable(std::unique_ptr<InputFile> file, CloudInfo info, std::vector<TableColumn> columns, TextBody body)
      : file_(std::move(file)),
        info_(std::move(info)),
        columns_(std::move(columns)),
        body_(std::move(body)),
        values_(columns_.size()),
        lines_(*file_, body_.offset) {
    survey();
    info_.layout = plan_->layout();
    set_points(info_, row_);
    report_malformed();
    note_lattice(info_, plan_->lattice());
    note_decimals();
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
      const bool whole = parse_row(line);
      if (!whole) std::fill(record.begin(), record.end(), std::byte{0});
      valid[done] = whole && plan_->encode(values_, record);
    }
    if (row_ == info_.points) lines_.release();
    return done;
  }

 private:
  void rewind() {
    lines_ = LineReader(*file_, body_.offset);
    row_ = 0;
    line_ = body_.first_line - 1;
    later_counts_ = 0;
  }

  // Finds the next line that is not blank, while rows may follow.
  bool next_row(std::string_view& line) {
    if (row_ >= body_.most_rows) return false;
    while (lines_.next(line)) {
      ++line_;
      if (is_blank_line(line) || (body_.counts_between && skip_count(line))) continue;
      ++row_;
      return true;
    }
    return false;
  }

  bool skip_count(std::string_view line) {
    const auto count = lone_count(line);
    if (count) later_counts_ += std::min(*count, kMostDeclared);
    return count.has_value();
  }

  // Reads every row once. It counts the rows and the malformed ones, and collects their places and decimals for the
  // lattice.
  void survey() {
    const std::array<std::size_t, 3> axes = coordinate_columns(columns_);
    const bool placed = has_coordinates(columns_);  // otherwise the plan throws
    LatticeSurvey lattice(body_.degrees);
    std::vector<double> sample;
    std::string_view line;
    rewind();
    for (std::size_t taken = 0; next_row(line);) {
      if (!parse_row(line)) {
        if (malformed_++ == 0) first_malformed_ = line_;
        continue;
      }
      if (taken++ < kSample) sample.insert(sample.end(), values_.begin(), values_.end());
      if (placed) lattice.add({values_[axes[0]], values_[axes[1]], values_[axes[2]]}, decimals(axes));
    }
    if (info_.declared_points > 0) info_.declared_points += std::min(later_counts_, kMostDeclared);
    plan_.emplace(info_.path, columns_, sample, std::span<const double>{}, lattice.choose());
  }

  // of the coordinates of the last parsed row
  int decimals(const std::array<std::size_t, 3>& axes) const {
    int most = TableLattice::kUnknown;
    if (body_.dialect)
      for (const std::size_t axis : axes) most = std::max(most, decimals_of(fields_[axis], *body_.dialect));
    return most;
  }

  bool parse_row(std::string_view line) {
    if (body_.dialect) {
      if (!ilot::parse_row(line, *body_.dialect, fields_, values_)) return false;
    } else {
      split_fields(line, columns_.size(), fields_);
      if (fields_.size() < columns_.size()) return false;
      for (std::size_t i = 0; i < columns_.size(); ++i)
        if (!parse_number(fields_[i], values_[i])) return false;
    }
    if (body_.convert) body_.convert(values_);
    return true;
  }

  void report_malformed() {
    if (malformed_ == 0) return;
    const std::string manner = body_.dialect ? " (" + description_of(*body_.dialect) + ")" : "";
    info_.warnings.push_back(std::to_string(malformed_) + " lines are not " + std::to_string(columns_.size()) +
                             " numbers" + manner + " and are rejected, the first is line " +
                             std::to_string(first_malformed_));
  }

  void note_decimals() {
    const TableLattice& lattice = plan_->lattice();
    if (lattice.decimals > lattice.kept)
      info_.dialect +=
          ", " + std::to_string(lattice.decimals) + " decimals of which " + std::to_string(lattice.kept) + " are kept";
  }

  std::unique_ptr<InputFile> file_;
  CloudInfo info_;
  std::vector<TableColumn> columns_;
  TextBody body_;
  std::vector<double> values_;
  std::vector<std::string_view> fields_;
  LineReader lines_;
  std::uint64_t row_ = 0, line_ = 0, malformed_ = 0, first_malformed_ = 0, later_counts_ = 0;
  std::optional<TablePlan> plan_;
};

}  // namespace

std::unique_ptr<PointReader> open_text_table(std::unique_ptr<InputFile> file, CloudInfo info,
                                             std::vector<TableColumn> columns, TextBody body) {
  return std::make_unique<TextTable>(std::move(file), std::move(info), std::move(columns), std::move(body));
}

}  // namespace ilot
