// SPDX-License-Identifier: Apache-2.0
// Links in an image that is in memory as a whole. The tiled kernel must give the same result.
#pragma once
#include "kernels/morphology/region_links.h"

namespace ilot::test {

// Links regions that laser shadows separate along their shortest connections [Hernandez and Marcotegui 2008, 3.2].
// Regions are lambda-flat zones (corners join) of the pixels with a height. Links run from side to side over pixels
// without a height. The shortest links come first, until all regions that can be linked are one (a least spanning tree,
// Kruskal 1956). The pixels of a link get heights between those of its two ends, in even steps. A link is sought where
// the pixels nearest to one region meet the pixels nearest to the other. Of equally near ends, the first one row by row
// is taken. Of equally long links, the one with the first end comes first. All other pixels keep their values. A chain
// of links that encloses a gap makes a hole of it: see fill_missing. The method uses waves over the pixels without a
// height. It takes O(n + c log c) for c pairs of pixels where regions meet, and 20 bytes per pixel.
Image link_regions(const Image& image, const LinkRegionsParams& params = {});

}  // namespace ilot::test
