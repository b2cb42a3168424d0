// SPDX-License-Identifier: Apache-2.0
#include "tools/render/image.h"

#include <png.h>

#include <system_error>

#include "engine/error.h"

namespace ilot::render {

void write_png(const Image& image, const std::filesystem::path& path) {
  std::filesystem::path temporary = path;
  temporary += ".part";
  png_image png{};
  png.version = PNG_IMAGE_VERSION;
  png.width = static_cast<png_uint_32>(image.width);
  png.height = static_cast<png_uint_32>(image.height);
  png.format = PNG_FORMAT_RGB;
  std::error_code error;
  if (!png_image_write_to_file(&png, temporary.c_str(), 0, image.pixels.data(), 0, nullptr)) {
    std::filesystem::remove(temporary, error);
    throw Error(path.string() + " cannot be written (" + png.message + "); check the folder and the free space");
  }
  std::filesystem::rename(temporary, path, error);
  if (error) throw Error(path.string() + " cannot be written: " + error.message());
}

}  // namespace ilot::render
