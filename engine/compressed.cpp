// SPDX-License-Identifier: Apache-2.0
#include "engine/compressed.h"

#include <zlib.h>

#include "engine/error.h"

namespace ilot {
namespace {

constexpr int kLevel = 6;  // Choice: zlib's own default; 9 takes three times as long for one part in a hundred

}  // namespace

std::string compressed(std::string_view bytes) {
  std::string small(compressBound(bytes.size()), '\0');
  uLongf size = small.size();
  if (compress2(reinterpret_cast<Bytef*>(small.data()), &size, reinterpret_cast<const Bytef*>(bytes.data()),
                bytes.size(), kLevel) != Z_OK)
    throw Error("data for a page or a map cannot be compressed: out of memory");
  small.resize(size);
  return small;
}

}  // namespace ilot
