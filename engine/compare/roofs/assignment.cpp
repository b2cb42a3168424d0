// SPDX-License-Identifier: Apache-2.0
#include "engine/compare/roofs/assignment.h"

#include <limits>

namespace ilot {
namespace {

constexpr double kNoPath = std::numeric_limits<double>::infinity();

// A square-free problem with at most as many rows as columns. Rows and columns count from 1; 0 is no partner.
class Assignment {
 public:
  Assignment(std::size_t rows, std::size_t columns)
      : row_price_(rows + 1), column_price_(columns + 1), row_of_(columns + 1), before_(columns + 1) {}

  // Gives row `row` a column and moves other rows along the cheapest path of changes.
  template <class Cost>
  void add(std::size_t row, const Cost& cost) {
    const std::size_t columns = row_of_.size() - 1;
    std::vector<double> least(columns + 1, kNoPath);
    std::vector<char> used(columns + 1);
    row_of_[0] = row;
    std::size_t at = 0;
    do {
      used[at] = 1;
      const std::size_t i = row_of_[at];
      double step = kNoPath;
      std::size_t next = 0;
      for (std::size_t j = 1; j <= columns; ++j) {
        if (used[j]) continue;
        const double reduced = cost(i - 1, j - 1) - row_price_[i] - column_price_[j];
        if (reduced < least[j]) {
          least[j] = reduced;
          before_[j] = at;
        }
        if (least[j] < step) {
          step = least[j];
          next = j;
        }
      }
      raise_prices(step, used, least);
      at = next;
    } while (row_of_[at] != 0);
    for (; at != 0; at = before_[at]) row_of_[at] = row_of_[before_[at]];
  }

  std::size_t row_of(std::size_t column) const { return row_of_[column + 1]; }  // 0 = none

 private:
  void raise_prices(double step, const std::vector<char>& used, std::vector<double>& least) {
    for (std::size_t j = 0; j < row_of_.size(); ++j) {
      if (used[j]) {
        row_price_[row_of_[j]] += step;
        column_price_[j] -= step;
      } else {
        least[j] -= step;
      }
    }
  }

  std::vector<double> row_price_, column_price_;
  std::vector<std::size_t> row_of_, before_;  // by column
};

}  // namespace

std::vector<std::uint32_t> least_assignment(std::span<const double> costs, std::size_t rows, std::size_t columns) {
  std::vector<std::uint32_t> column_of(rows, kUnassigned);
  const bool turned = rows > columns;
  Assignment assignment(turned ? columns : rows, turned ? rows : columns);
  const auto cost = [&](std::size_t i, std::size_t j) {
    return turned ? costs[j * columns + i] : costs[i * columns + j];
  };
  for (std::size_t row = 1; row <= (turned ? columns : rows); ++row) assignment.add(row, cost);
  for (std::size_t j = 0; j < (turned ? rows : columns); ++j) {
    const std::size_t partner = assignment.row_of(j);
    if (partner == 0) continue;
    if (turned)
      column_of[j] = static_cast<std::uint32_t>(partner - 1);
    else
      column_of[partner - 1] = static_cast<std::uint32_t>(j);
  }
  return column_of;
}

}  // namespace ilot
