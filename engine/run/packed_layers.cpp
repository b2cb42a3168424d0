// SPDX-License-Identifier: Apache-2.0
#include "engine/run/packed_layers.h"

#include <malloc.h>

#include <cassert>
#include <memory>
#include <span>
#include <utility>

#include "engine/store/column_file.h"

namespace ilot {
namespace {

std::uint64_t bytes_of(const PackedImage& packed) {
  return packed.words.size() * sizeof(std::uint16_t);
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
  auto packed = std::make_shared<PackedImage>(packed_image(image));
  const Key key{layer, tile};
  const std::uint64_t bytes = bytes_of(*packed);
  std::unique_lock lock(mutex_);
  auto& entry = tiles_[key];
  if (entry != nullptr) held_ -= bytes_of(*entry);
  if (held_ + bytes <= budget_) {
    held_ += bytes;
    entry = std::move(packed);
    return;
  }
  entry = nullptr;
  lock.unlock();
  write_column<std::uint16_t>(path(key), packed->words);
  std::vector<std::uint16_t>().swap(packed->words);  // "= {}" would keep the memory
  lock.lock();
  tiles_[key] = std::move(packed);
}

void PackedLayers::read(const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out) const {
  const Key key{layer, tile};
  std::shared_ptr<const PackedImage> packed;
  {
    const std::lock_guard lock(mutex_);
    const auto entry = tiles_.find(key);
    assert(entry != tiles_.end());
    packed = entry->second;
  }
  const std::uint32_t first = packed->rows[part.y], last = packed->rows[part.y + part.height];
  std::vector<std::uint16_t> loaded;
  if (packed->words.empty() && last > first) {
    loaded.resize(last - first);
    ColumnReader<std::uint16_t>(path(key)).read(first, loaded);
  }
  unpack(*packed,
         loaded.empty() ? std::span(packed->words).subspan(first, last - first) : std::span(std::as_const(loaded)),
         part, out);
}

void PackedLayers::drop(const char* layer) {
  const std::lock_guard lock(mutex_);
  for (auto entry = tiles_.lower_bound({layer, 0}); entry != tiles_.end() && entry->first.first == layer;) {
    held_ -= bytes_of(*entry->second);
    if (entry->second->words.empty()) {
      std::error_code ignored;
      std::filesystem::remove(path(entry->first), ignored);
    }
    entry = tiles_.erase(entry);
  }
}

}  // namespace ilot
