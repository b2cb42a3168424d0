// SPDX-License-Identifier: Apache-2.0
// Links in an image that is in memory as a whole: what the tiled kernel must agree with.
#pragma once
#include "kernels/morphology/region_links.h"

namespace ilot::test {

// Regions that shadows cut apart, linked along their shortest connections [Hernandez and Marcotegui 2008, 3.2]: regions
// are lambda-flat zones (corners join) of the pixels with a height; links run from side to side over pixels without
// one, the shortest first, until all regions that can be are one (a least spanning tree, Kruskal 1956). Links' pixels
// get heights between those of their two ends, in even steps. A link is sought where the pixels nearest to the one
// region meet those nearest to the other (of equally near ends the first, row by row); of equally long links the one
// with the first end goes first. All other pixels stay as they are. A chain of links that closes a gap around makes a
// hole of it: see fill_missing. Waves over the pixels without a height, O(n + c log c) for c pairs of pixels where
// regions meet; 20 bytes a pixel.
Image link_regions(const Image& image, const LinkRegionsParams& params = {});

}  // namespace ilot::test
