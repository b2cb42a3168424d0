// SPDX-License-Identifier: Apache-2.0
// Bar charts as SVG. Colours come from the page (classes series-0, series-1 ...), so that they follow light and dark.
#pragma once
#include <span>
#include <string>
#include <vector>

namespace ilot {

struct ChartBar {
  std::string label;          // below the bar
  std::vector<double> parts;  // one value a series, stacked from below
};

struct Chart {
  std::string title, across;        // across: what the labels are, with the unit
  std::vector<std::string> series;  // names, for the legend; one name needs no legend
  std::vector<ChartBar> bars;
};

std::string chart_svg(const Chart& chart);

// Counts values between the given edges, which increase. The first bar has what is below the first edge, the last what
// reaches the last edge. `series` has the number of the series of each value; values that are not finite are left out.
std::vector<ChartBar> histogram(std::span<const double> values, std::span<const int> series, std::size_t count,
                                std::span<const double> edges, double shown_per_unit, int digits);

}  // namespace ilot
