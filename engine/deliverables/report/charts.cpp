// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "engine/deliverables/report/html.h"
#include "engine/report/progress.h"

namespace ilot {
namespace {

constexpr double kChartWidth = 560, kChartHeight = 190, kLeft = 8, kBase = 150, kTop = 22;

std::string grouped_count(double value) {
  return grouped(static_cast<std::uint64_t>(std::llround(value)));
}

std::string bar_svg(const ChartBar& bar, const Chart& chart, double x, double width, double scale) {
  std::string svg;
  double top = kBase;
  std::string note = bar.label + ": ";
  for (std::size_t i = 0; i < bar.parts.size(); ++i) {
    const double height = bar.parts[i] * scale;
    top -= height;
    if (bar.parts[i] > 0) {
      svg += fmt::format("<rect class=\"series-{}\" x=\"{:.1f}\" y=\"{:.1f}\" width=\"{:.1f}\" height=\"{:.1f}\"/>", i,
                         x, top, width, std::max(height, 0.5));
      note += grouped_count(bar.parts[i]) + (chart.series.size() > 1 ? " " + chart.series[i] : "") + "  ";
    }
  }
  const double all = std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0), middle = x + width / 2;
  if (all > 0)
    svg +=
        fmt::format("<text class=\"count\" x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", middle, top - 4, grouped_count(all));
  svg += fmt::format("<text x=\"{:.1f}\" y=\"{:.1f}\">{}</text>", middle, kBase + 15, html_text(bar.label));
  return "<g><title>" + html_text(note) + "</title>" + svg + "</g>\n";
}

}  // namespace

std::string chart_svg(const Chart& chart) {
  double most = 1;
  for (const ChartBar& bar : chart.bars)
    most = std::max(most, std::accumulate(bar.parts.begin(), bar.parts.end(), 0.0));
  const double step = (kChartWidth - 2 * kLeft) / std::max<double>(1, static_cast<double>(chart.bars.size()));
  std::string svg = fmt::format(
      "<figure class=\"chart\"><figcaption>{}</figcaption><svg viewBox=\"0 0 {} {}\" role=\"img\" aria-label=\"{}\">\n",
      html_text(chart.title), kChartWidth, kChartHeight, html_text(chart.title));
  for (std::size_t i = 0; i < chart.bars.size(); ++i)
    svg += bar_svg(chart.bars[i], chart, kLeft + step * (static_cast<double>(i) + 0.08), 0.84 * step,
                   (kBase - kTop) / most);
  svg += fmt::format("<path class=\"axis\" d=\"M{} {}H{}\"/><text class=\"across\" x=\"{}\" y=\"{}\">{}</text></svg>\n",
                     kLeft, kBase, kChartWidth - kLeft, kChartWidth / 2, kChartHeight - 6, html_text(chart.across));
  if (chart.series.size() > 1) {
    svg += "<p class=\"legend\">";
    const auto is_used = [&](std::size_t i) {
      return std::any_of(chart.bars.begin(), chart.bars.end(), [&](const ChartBar& bar) { return bar.parts[i] > 0; });
    };
    for (std::size_t i = 0; i < chart.series.size(); ++i)
      if (is_used(i)) svg += fmt::format("<span><i class=\"series-{}\"></i>{}</span> ", i, html_text(chart.series[i]));
    svg += "</p>";
  }
  return svg + "</figure>\n";
}

std::vector<ChartBar> histogram(std::span<const double> values, std::span<const int> series, std::size_t count,
                                std::span<const double> edges, double shown_per_unit, int digits) {
  std::vector<ChartBar> bars(edges.size() + 1);
  const auto shown = [&](double edge) { return number_text(edge * shown_per_unit, digits); };
  for (std::size_t i = 0; i < bars.size(); ++i) {
    bars[i].parts.assign(count, 0);
    bars[i].label = i == 0              ? "< " + shown(edges[0])
                    : i == edges.size() ? "≥ " + shown(edges.back())
                                        : shown(edges[i - 1]) + (edges[i - 1] < 0 ? " to " : "–") + shown(edges[i]);
  }
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (!std::isfinite(values[i])) continue;
    const auto bar = std::upper_bound(edges.begin(), edges.end(), values[i]) - edges.begin();
    bars[static_cast<std::size_t>(bar)].parts[static_cast<std::size_t>(series[i])] += 1;
  }
  return bars;
}

}  // namespace ilot
