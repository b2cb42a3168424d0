// SPDX-License-Identifier: Apache-2.0
#include "engine/run/packed_layers.h"

#include <malloc.h>

#include <algorithm>
#include <cassert>
#include <memory>
#include <span>

#include "engine/store/column_file.h"

namespace ilot {
namespace {

constexpr std::size_t kLeastRun = 4;

// A word 2 n + 1 and a value: n times the value; a word 2 n: n values follow.
void pack(std::span<const Height> row, std::vector<std::uint32_t>& words) {
  std::size_t literal = 0;  // first value that is not yet written
  const auto flush = [&](std::size_t end) {
    if (literal == end) return;
    words.push_back(static_cast<std::uint32_t>(2 * (end - literal)));
    for (std::size_t i = literal; i < end; ++i) words.push_back(static_cast<std::uint32_t>(row[i]));
  };
  for (std::size_t i = 0; i < row.size();) {
    std::size_t end = i + 1;
    while (end < row.size() && row[end] == row[i]) ++end;
    if (end - i >= kLeastRun) {
      flush(i);
      words.push_back(static_cast<std::uint32_t>(2 * (end - i) + 1));
      words.push_back(static_cast<std::uint32_t>(row[i]));
      literal = end;
    }
    i = end;
  }
  flush(row.size());
}

// Puts the values [from, from + length) of a row behind those of `out`.
void unpack(std::span<const std::uint32_t> words, std::uint64_t from, std::uint64_t length, std::vector<Height>& out) {
  const std::uint64_t end = from + length;
  std::uint64_t at = 0;
  for (std::size_t w = 0; w < words.size() && at < end;) {
    const std::uint64_t n = words[w] >> 1;
    const bool run = (words[w] & 1) != 0;
    const std::uint64_t first = std::max(at, from), last = std::min(at + n, end);
    if (first < last) {
      const std::uint32_t* values = words.data() + w + 1;
      if (run)
        out.insert(out.end(), last - first, static_cast<Height>(*values));
      else
        out.insert(out.end(), values + (first - at), values + (last - at));
    }
    at += n;
    w += run ? 2 : 1 + n;
  }
}

}  // namespace

PackedLayers::PackedLayers(std::filesystem::path folder, std::uint64_t budget_bytes)
    : folder_(std::move(folder)), budget_(budget_bytes) {
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
}

PackedLayers::~PackedLayers() {
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
  tiles_.clear();
  malloc_trim(0);  // rows are small blocks that the allocator would keep, and --memory counts them
}

std::filesystem::path PackedLayers::path(const Key& key) const {
  return folder_ / (key.first + "_" + std::to_string(key.second));
}

void PackedLayers::write(const char* layer, std::size_t tile, const Image& image) {
  auto packed = std::make_shared<Packed>();
  for (std::uint32_t y = 0; y < image.height; ++y) {
    packed->rows.push_back(static_cast<std::uint32_t>(packed->words.size()));
    pack(std::span(image.values).subspan(std::size_t{y} * image.width, image.width), packed->words);
  }
  packed->rows.push_back(static_cast<std::uint32_t>(packed->words.size()));
  packed->words.shrink_to_fit();
  const Key key{layer, tile};
  const std::uint64_t bytes = packed->words.size() * sizeof(std::uint32_t);
  std::unique_lock lock(mutex_);
  auto& entry = tiles_[key];
  if (entry != nullptr) held_ -= entry->words.size() * sizeof(std::uint32_t);
  if (held_ + bytes <= budget_) {
    held_ += bytes;
    entry = std::move(packed);
    return;
  }
  entry = nullptr;
  lock.unlock();
  write_column<std::uint32_t>(path(key), packed->words);
  packed->words = {};
  lock.lock();
  tiles_[key] = std::move(packed);
}

Image PackedLayers::read(const char* layer, std::size_t tile, const TileFrame& part) const {
  const Key key{layer, tile};
  std::shared_ptr<const Packed> packed;
  {
    const std::lock_guard lock(mutex_);
    const auto entry = tiles_.find(key);
    assert(entry != tiles_.end());
    packed = entry->second;
  }
  Image image{part.width, part.height, {}};
  image.values.reserve(std::size_t{part.width} * part.height);
  const std::uint32_t first = packed->rows[part.y], last = packed->rows[part.y + part.height];
  std::vector<std::uint32_t> loaded;
  if (packed->words.empty() && last > first) {
    loaded.resize(last - first);
    ColumnReader(path(key)).read<std::uint32_t>(first, loaded);
  }
  const std::span<const std::uint32_t> words =
      loaded.empty() ? std::span(packed->words).subspan(first, last - first) : std::span<const std::uint32_t>(loaded);
  for (std::uint32_t y = 0; y < part.height; ++y) {
    const std::uint32_t from = packed->rows[part.y + y] - first, to = packed->rows[part.y + y + 1] - first;
    unpack(words.subspan(from, to - from), part.x, part.width, image.values);
  }
  return image;
}

void PackedLayers::drop(const char* layer) {
  const std::lock_guard lock(mutex_);
  for (auto entry = tiles_.lower_bound({layer, 0}); entry != tiles_.end() && entry->first.first == layer;) {
    held_ -= entry->second->words.size() * sizeof(std::uint32_t);
    if (entry->second->words.empty()) {
      std::error_code ignored;
      std::filesystem::remove(path(entry->first), ignored);
    }
    entry = tiles_.erase(entry);
  }
}

}  // namespace ilot
