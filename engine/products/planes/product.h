// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/product.h"

namespace ilot {

const Product& planes_product();

}  // namespace ilot
