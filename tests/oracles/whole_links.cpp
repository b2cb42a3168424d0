// SPDX-License-Identifier: Apache-2.0
#include "tests/oracles/whole_links.h"

#include "kernels/morphology/flat_zones.h"

namespace ilot::test {

Image link_regions(const Image& image, const LinkRegionsParams& params) {
  if (image.size() == 0) return image;
  LinkWindow window{image, flat_zones(image, params.step, Adjacency::eight).of,
                    std::vector<std::uint8_t>(image.size(), 1)};
  window.whole_width = image.width;
  Image out = image;
  for (const RegionLink& link : links_in(window, params))
    for (const LinkPixel& p : link.way)
      if (out.values[p.pixel] == kNoHeight) out.values[p.pixel] = p.height;
  return out;
}

}  // namespace ilot::test
