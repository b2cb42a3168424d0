// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/product.h"

namespace ilot {

const Product& planes_product();

// The settings with which planes are searched. Where planes are not asked for and are made for another product, no
// curved shapes are looked for, unless the settings ask for them.
Settings settings_of_planes(Settings settings, bool asked);

}  // namespace ilot
