// SPDX-License-Identifier: Apache-2.0
#include "engine/deliverables/report/html.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/markup.h"

namespace ilot {
namespace {

bool is_plain_in_url(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') || c == '-' || c == '_' ||
         c == '.' || c == '~' || c == '/';
}

}  // namespace

std::string html_text(std::string_view text) {
  std::string clean(text);
  for (char& c : clean)
    if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f) c = ' ';
  return escaped_markup(clean);
}

std::string url_of_path(std::string_view path) {
  std::string url;
  for (const char c : path)
    url += is_plain_in_url(c) ? std::string(1, c) : fmt::format("%{:02X}", static_cast<unsigned char>(c));
  return url;
}

std::string file_link(std::string_view path, std::string_view shown) {
  return fmt::format("<a href=\"{}\">{}</a>", url_of_path(path), html_text(shown));
}

std::string bytes_text(std::uint64_t bytes) {
  constexpr std::array<const char*, 4> kUnits{"kB", "MB", "GB", "TB"};
  if (bytes < 1000) return fmt::format("{} B", bytes);
  double value = static_cast<double>(bytes) / 1000;
  std::size_t unit = 0;
  for (; value >= 999.5 && unit + 1 < kUnits.size(); ++unit) value /= 1000;
  return fmt::format("{:.{}f} {}", value, value < 9.95 ? 1 : 0, kUnits[unit]);
}

std::string number_text(double value, int digits) {
  if (!std::isfinite(value)) return "";
  std::string text = fmt::format("{:.{}f}", value, digits);
  if (text.find('.') != std::string::npos) {
    while (text.back() == '0') text.pop_back();
    if (text.back() == '.') text.pop_back();
  }
  return text == "-0" ? "0" : text;
}

void HtmlTable::add(std::span<const std::string> cells, std::string_view id) {
  rows_ += id.empty() ? "<tr>" : fmt::format("<tr id=\"{}\">", html_text(id));
  for (std::size_t i = 0; i < columns_.size(); ++i)
    rows_ += (columns_[i].number ? "<td class=\"n\">" : "<td>") + (i < cells.size() ? cells[i] : "") + "</td>";
  rows_ += "</tr>\n";
}

std::string HtmlTable::html() const {
  std::string head;
  for (const HtmlColumn& column : columns_)
    head += (column.number ? "<th class=\"n\">" : "<th>") + html_text(column.head) + "</th>";
  return fmt::format("<div class=\"wide\"><table{}><thead><tr>{}</tr></thead><tbody>\n{}</tbody></table></div>\n",
                     sortable_ ? " class=\"sortable\"" : "", head, rows_);
}

std::string html_section(std::string_view id, std::string_view title, std::string_view content) {
  return fmt::format("<section id=\"{}\"><h2>{}</h2>\n{}</section>\n", id, html_text(title), content);
}

std::string html_note(std::string_view text) {
  return fmt::format("<p class=\"note\">{}</p>\n", html_text(text));
}

}  // namespace ilot
