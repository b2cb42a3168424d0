// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "engine/store/scratch_file.h"
#include "engine/tiles/packed_image.h"

namespace ilot {

// Images of tiles by layer, packed row by row: in memory up to a budget, and beyond it in one file per layer. Memory
// beside the budget: 40 bytes per tile and layer. May be called from several threads at once.
class PackedLayers {
 public:
  PackedLayers(std::filesystem::path folder, std::uint64_t budget_bytes);
  ~PackedLayers();
  PackedLayers(const PackedLayers&) = delete;
  PackedLayers& operator=(const PackedLayers&) = delete;

  void write(const char* layer, std::size_t tile, const Image& image);
  void read(const char* layer, std::size_t tile, const TileFrame& part, const PixelRows& out) const;
  void drop(const char* layer);

  // The bytes of the budget that are left for further images.
  std::uint64_t unused() const;
  // Lowers the budget: images in memory move to the files until `bytes` bytes are released, or none is left.
  void spill(std::uint64_t bytes);

 private:
  struct Entry {
    std::shared_ptr<const PackedImage> image;  // empty: the image is in the file
    std::uint64_t offset = 0;                  // position of its rows in the file; its words follow them
    std::uint32_t height = 0;
    Height base = 0;
    bool wide = false;
  };
  struct Layer {
    std::vector<Entry> tiles;
    std::shared_ptr<ScratchFile> file;
  };
  std::shared_ptr<ScratchFile> file_of(const std::string& layer);
  static std::uint64_t appended(ScratchFile& file, const PackedImage& packed);
  void put(const std::string& layer, std::size_t tile, Entry entry);

  std::filesystem::path folder_;
  std::uint64_t budget_, held_ = 0;
  mutable std::mutex mutex_;
  std::map<std::string, Layer> layers_;
};

}  // namespace ilot
