// SPDX-License-Identifier: Apache-2.0
#pragma once
#include "engine/products/product.h"

namespace ilot {

const Product& facades_product();

}  // namespace ilot
