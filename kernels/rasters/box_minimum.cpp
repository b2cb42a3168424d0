// SPDX-License-Identifier: Apache-2.0
#include "kernels/rasters/box_minimum.h"

#include <algorithm>
#include <span>

namespace ilot {
namespace {

// Windows that reach over `line` on both sides, which is padded with kAboveAll to whole blocks of a window's length.
// The minimum of any window is that of the end of one block and the start of the next.
class Windows {
 public:
  Windows(std::size_t length, std::size_t reach)
      : length_(length),
        reach_(reach),
        block_(2 * reach + 1),
        line_((length + 2 * reach + block_ - 1) / block_ * block_, kAboveAll),
        to_here_(line_.size()),
        from_here_(line_.size()) {}

  template <typename At>
  void lower(const At& at) {
    for (std::size_t i = 0; i < length_; ++i) line_[i + reach_] = at(i);
    for (std::size_t i = 0; i < line_.size(); ++i)
      to_here_[i] = i % block_ == 0 ? line_[i] : std::min(to_here_[i - 1], line_[i]);
    for (std::size_t i = line_.size(); i-- > 0;)
      from_here_[i] = i % block_ + 1 == block_ ? line_[i] : std::min(from_here_[i + 1], line_[i]);
    for (std::size_t i = 0; i < length_; ++i) at(i) = std::min(from_here_[i], to_here_[i + 2 * reach_]);
  }

 private:
  std::size_t length_, reach_, block_;
  std::vector<Height> line_, to_here_, from_here_;
};

}  // namespace

Image box_minimum(const Image& image, std::uint32_t reach) {
  Image out = image;
  for (Height& v : out.values)
    if (v == kNoHeight) v = kAboveAll;
  Windows rows(image.width, std::min(reach, image.width)), columns(image.height, std::min(reach, image.height));
  for (std::uint32_t y = 0; y < image.height; ++y)
    rows.lower([&](std::size_t x) -> Height& { return out.values[std::size_t{y} * image.width + x]; });
  for (std::uint32_t x = 0; x < image.width; ++x)
    columns.lower([&](std::size_t y) -> Height& { return out.values[y * image.width + x]; });
  for (Height& v : out.values)
    if (v == kAboveAll) v = kNoHeight;
  return out;
}

}  // namespace ilot
