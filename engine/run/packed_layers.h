// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>

#include "engine/run/packed_image.h"

namespace ilot {

// Images of tiles by layer, packed row by row, in memory up to a budget and in files beyond it. Called from several
// threads at once.
class PackedLayers {
 public:
  PackedLayers(std::filesystem::path folder, std::uint64_t budget_bytes);
  ~PackedLayers();
  PackedLayers(const PackedLayers&) = delete;
  PackedLayers& operator=(const PackedLayers&) = delete;

  void write(const char* layer, std::size_t tile, const Image& image);
  void read(const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out) const;
  void drop(const char* layer);

 private:
  using Key = std::pair<std::string, std::size_t>;
  std::filesystem::path path(const Key& key) const;

  std::filesystem::path folder_;
  std::uint64_t budget_, held_ = 0;
  mutable std::mutex mutex_;
  std::map<Key, std::shared_ptr<const PackedImage>> tiles_;  // without words: in the file
};

}  // namespace ilot
