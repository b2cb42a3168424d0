// SPDX-License-Identifier: Apache-2.0
#include "engine/formats/tables/lines.h"

#include <algorithm>
#include <charconv>
#include <cstring>

namespace ilot {
namespace {

constexpr std::size_t kBuffer = std::size_t{1} << 20;
constexpr std::size_t kLongestLine = std::size_t{1} << 16;

bool is_comma(char c) {
  return c == ',' || c == ';';
}

}  // namespace

bool LineReader::fill() {
  if (buffer_.empty()) buffer_.resize(kBuffer);
  std::memmove(buffer_.data(), buffer_.data() + begin_, end_ - begin_);
  end_ -= begin_;
  begin_ = 0;
  const std::span<char> rest = std::span(buffer_).subspan(end_);
  const std::size_t got = file_->read_at(next_, std::as_writable_bytes(rest));
  next_ += got;
  end_ += got;
  return got > 0;
}

void LineReader::release() {
  next_ = offset();
  begin_ = end_ = 0;
  std::vector<char>().swap(buffer_);
}

bool LineReader::next(std::string_view& line) {
  std::size_t searched = 0;
  for (;;) {
    const char* from = buffer_.data() + begin_;
    const void* found =
        end_ - begin_ > searched ? std::memchr(from + searched, '\n', end_ - begin_ - searched) : nullptr;
    if (found) {
      const auto length = static_cast<std::size_t>(static_cast<const char*>(found) - from);
      line = {from, std::min(length, kLongestLine)};
      begin_ += length + 1;
      break;
    }
    searched = end_ - begin_;
    if (searched == kBuffer) {
      begin_ += kBuffer - kLongestLine;
      std::memmove(buffer_.data() + begin_, from, kLongestLine);
      searched = kLongestLine;
    }
    if (fill()) continue;
    // When a file has become shorter, it ends inside a line. The rest of that line is not a row.
    if (begin_ == end_ || next_ < file_->size()) return false;
    line = {buffer_.data() + begin_, std::min(end_ - begin_, kLongestLine)};
    begin_ = end_;
    break;
  }
  if (!line.empty() && line.back() == '\r') line.remove_suffix(1);
  return true;
}

void split_fields(std::string_view line, std::size_t most, std::vector<std::string_view>& fields) {
  fields.clear();
  std::size_t at = 0;
  const auto skip_blanks = [&] {
    while (at < line.size() && is_blank(line[at])) ++at;
  };
  skip_blanks();
  while (at < line.size() && fields.size() < most) {
    const std::size_t begin = at;
    if (line[at] == '"') {
      const std::size_t close = line.find('"', at + 1);
      at = close == std::string_view::npos ? line.size() : close + 1;
      fields.push_back(line.substr(begin + 1, std::max(at - begin, std::size_t{2}) - 2));
    } else {
      while (at < line.size() && !is_blank(line[at]) && !is_comma(line[at])) ++at;
      fields.push_back(line.substr(begin, at - begin));
    }
    skip_blanks();
    if (at < line.size() && is_comma(line[at])) ++at;
    skip_blanks();
  }
}

bool parse_number(std::string_view text, double& value) {
  if (!text.empty() && text.front() == '+') text.remove_prefix(1);
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  return error == std::errc{} && end == text.data() + text.size() && !text.empty();
}

}  // namespace ilot
