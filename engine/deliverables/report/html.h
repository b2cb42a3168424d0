// SPDX-License-Identifier: Apache-2.0
// Small pieces of HTML. Every text is escaped here, so that no name of a file, building or attribute becomes markup.
#pragma once
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ilot {

// Text of any origin: control characters become blanks, markup is escaped.
std::string html_text(std::string_view text);

// A link to a file of the result. `path` is relative to the report; bytes that are not plain in a URL are escaped.
std::string file_link(std::string_view path, std::string_view shown);
std::string url_of_path(std::string_view path);

// "3.4 MB"; decimal multiples, as file managers show them.
std::string bytes_text(std::uint64_t bytes);

// A number for people with at most `digits` digits behind the point, without zeros at its end.
std::string number_text(double value, int digits);

// A table of ready HTML cells. Columns of numbers are set to the right. With `sortable` a click on a head sorts it.
struct HtmlColumn {
  std::string head;
  bool number = false;
};
class HtmlTable {
 public:
  explicit HtmlTable(std::vector<HtmlColumn> columns, bool sortable = false)
      : columns_(std::move(columns)), sortable_(sortable) {}
  void add(std::span<const std::string> cells, std::string_view id = {});
  void add(std::initializer_list<std::string> cells, std::string_view id = {}) {
    add(std::span<const std::string>(cells.begin(), cells.size()), id);
  }
  bool empty() const { return rows_.empty(); }
  std::string html() const;

 private:
  std::vector<HtmlColumn> columns_;
  std::string rows_;
  bool sortable_;
};

// One section of the report: its anchor, its title and its content.
std::string html_section(std::string_view id, std::string_view title, std::string_view content);

// A sentence for people below a title.
std::string html_note(std::string_view text);

}  // namespace ilot
