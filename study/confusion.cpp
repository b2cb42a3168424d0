// SPDX-License-Identifier: Apache-2.0
#include "study/confusion.h"

#include <fmt/format.h>

#include <cmath>
#include <set>

namespace ilot {
namespace {

std::string name_of(PointLabel label) {
  return class_name_of(label, {});
}

double percent(std::uint64_t part, std::uint64_t all) {
  return 100.0 * static_cast<double>(part) / static_cast<double>(all);
}

struct Row {
  std::uint64_t right = 0, total = 0;
};

Row row_of(PointLabel truth, const std::map<PointLabel, std::uint64_t>& cells) {
  Row row;
  for (const auto& [column, n] : cells) row.total += n;
  if (const auto own = cells.find(truth); own != cells.end()) row.right = own->second;
  return row;
}

}  // namespace

void add(const Confusion& m, Confusion& all) {
  for (const auto& [row, cells] : m)
    for (const auto& [column, n] : cells) all[row][column] += n;
}

void print_confusion(const Confusion& m) {
  std::set<PointLabel> columns;
  for (const auto& [row, cells] : m) {
    columns.insert(row);
    for (const auto& [column, n] : cells) columns.insert(column);
  }
  fmt::print("  {:12}", "true");
  for (const PointLabel c : columns) fmt::print("{:>12}", name_of(c));
  fmt::print("{:>10}\n", "right");
  Row all;
  for (const auto& [truth, cells] : m) {
    fmt::print("  {:12}", name_of(truth));
    for (const PointLabel c : columns) fmt::print("{:12}", cells.count(c) ? cells.at(c) : 0);
    const Row row = row_of(truth, cells);
    fmt::print("{:9.2f}%\n", percent(row.right, row.total));
    all.right += row.right, all.total += row.total;
  }
  fmt::print("  total error {:.2f} %\n", percent(all.total - all.right, all.total));
}

void note_shares(const Confusion& m, RunShares& shares) {
  Row all;
  for (const auto& [truth, cells] : m) {
    const Row row = row_of(truth, cells);
    shares[name_of(truth)].push_back(percent(row.right, row.total));
    all.right += row.right, all.total += row.total;
  }
  shares["total error"].push_back(percent(all.total - all.right, all.total));
}

void print_intervals(const RunShares& shares) {
  constexpr double kStudent[] = {0, 0, 12.71, 4.30, 3.18, 2.78, 2.57, 2.45, 2.36, 2.31, 2.26};
  for (const auto& [name, list] : shares) {
    const auto n = static_cast<double>(list.size());
    double sum = 0, squares = 0;
    for (const double v : list) sum += v;
    for (const double v : list) squares += (v - sum / n) * (v - sum / n);
    const double half =
        list.size() < 2 || list.size() > 10 ? 0 : kStudent[list.size()] * std::sqrt(squares / (n - 1) / n);
    fmt::print("  {:12} {:6.2f} +- {:.2f} %\n", name, sum / n, half);
  }
}

}  // namespace ilot
