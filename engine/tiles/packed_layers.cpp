// SPDX-License-Identifier: Apache-2.0
#include "engine/tiles/packed_layers.h"

#include <algorithm>
#include <cassert>
#include <span>
#include <utility>
#include "engine/pass/resident.h"

namespace ilot {
namespace {

constexpr std::uint64_t kBytesOfEntry = 160;  // bytes of an image beside its rows and words, with block heads

std::uint64_t bytes_of(const PackedImage& packed) {
  return packed.words.size() * sizeof(std::uint16_t) + packed.rows.size() * sizeof(std::uint32_t) + kBytesOfEntry;
}

// Loads rows [first, end] and their words as they are in the file.
PackedImage loaded(const ScratchFile& file, std::uint64_t offset, std::uint32_t height, const TileFrame& part) {
  PackedImage packed;
  packed.rows.resize(std::size_t{part.height} + 1);
  file.read(offset + part.y * sizeof(std::uint32_t), std::as_writable_bytes(std::span(packed.rows)));
  const std::uint64_t words = offset + (std::uint64_t{height} + 1) * sizeof(std::uint32_t);
  packed.words.resize(packed.rows.back() - packed.rows.front());
  file.read(words + packed.rows.front() * sizeof(std::uint16_t), std::as_writable_bytes(std::span(packed.words)));
  return packed;
}

}  // namespace

PackedLayers::PackedLayers(std::filesystem::path folder, std::uint64_t budget_bytes)
    : folder_(std::move(folder)), budget_(budget_bytes) {
  std::filesystem::remove_all(folder_);
  std::filesystem::create_directories(folder_);
}

PackedLayers::~PackedLayers() {
  layers_.clear();
  std::error_code ignored;
  std::filesystem::remove_all(folder_, ignored);
  trim_memory();  // the allocator would keep the small blocks of rows, and they count for --memory
}

std::shared_ptr<ScratchFile> PackedLayers::file_of(const std::string& layer) {
  auto& file = layers_[layer].file;
  if (file == nullptr) file = std::make_shared<ScratchFile>(folder_);
  return file;
}

std::uint64_t PackedLayers::appended(ScratchFile& file, const PackedImage& packed) {
  std::vector<std::byte> bytes;
  for (const auto part : {std::as_bytes(std::span(packed.rows)), std::as_bytes(std::span(packed.words))})
    bytes.insert(bytes.end(), part.begin(), part.end());
  return file.append(bytes);
}

void PackedLayers::put(const std::string& layer, std::size_t tile, Entry entry) {
  std::vector<Entry>& tiles = layers_[layer].tiles;
  if (tiles.size() <= tile) tiles.resize(tile + 1);
  if (tiles[tile].image != nullptr) held_ -= bytes_of(*tiles[tile].image);
  tiles[tile] = std::move(entry);
}

void PackedLayers::write(const char* layer, std::size_t tile, const Image& image) {
  auto packed = std::make_shared<PackedImage>(packed_image(image));
  Entry entry{nullptr, 0, image.height, packed->base, packed->wide};
  std::unique_lock lock(mutex_);
  if (held_ + bytes_of(*packed) <= budget_) {
    held_ += bytes_of(*packed);
    entry.image = std::move(packed);
    put(layer, tile, std::move(entry));
    return;
  }
  const std::shared_ptr<ScratchFile> file = file_of(layer);
  lock.unlock();
  entry.offset = appended(*file, *packed);
  lock.lock();
  put(layer, tile, std::move(entry));
}

void PackedLayers::read(const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out) const {
  Entry entry;
  std::shared_ptr<ScratchFile> file;
  {
    const std::lock_guard lock(mutex_);
    const Layer& of = layers_.at(layer);
    assert(tile < of.tiles.size());
    entry = of.tiles[tile];
    file = of.file;
  }
  if (part.height == 0) return;
  if (entry.image != nullptr) {
    const std::uint32_t first = entry.image->rows[part.y], last = entry.image->rows[part.y + part.height];
    unpack(*entry.image, std::span(entry.image->words).subspan(first, last - first), part, out);
    return;
  }
  PackedImage packed = loaded(*file, entry.offset, entry.height, part);
  packed.base = entry.base;
  packed.wide = entry.wide;
  unpack(packed, packed.words, {part.x, 0, part.width, part.height}, out);
}

std::uint64_t PackedLayers::unused() const {
  const std::lock_guard lock(mutex_);
  return budget_ - held_;
}

void PackedLayers::spill(std::uint64_t bytes) {
  const std::lock_guard lock(mutex_);
  const std::uint64_t from_unused = std::min(bytes, budget_ - held_);
  const std::uint64_t target = held_ - std::min(held_, bytes - from_unused);
  for (auto& [name, layer] : layers_)
    for (Entry& entry : layer.tiles) {
      if (held_ <= target) break;
      if (entry.image == nullptr) continue;
      entry.offset = appended(*file_of(name), *entry.image);
      held_ -= bytes_of(*entry.image);
      entry.image = nullptr;
    }
  budget_ = std::min(budget_ - from_unused, std::max(held_, target));
}

void PackedLayers::drop(const char* layer) {
  const std::lock_guard lock(mutex_);
  const auto found = layers_.find(layer);
  if (found == layers_.end()) return;
  for (const Entry& entry : found->second.tiles)
    if (entry.image != nullptr) held_ -= bytes_of(*entry.image);
  layers_.erase(found);
}

}  // namespace ilot
