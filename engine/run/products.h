// SPDX-License-Identifier: Apache-2.0
// The list of products. It is the only place that names them all.
#pragma once
#include <span>
#include <string>
#include <vector>

#include "engine/products/product.h"

namespace ilot {

// Returns them in the order in which they are shown to people, and in which their classes of points count.
std::span<const Product* const> all_products();

// Returns the products that are asked for and the planes that they need, in the order in which they are made.
std::vector<const Product*> products_to_make(const std::vector<std::string>& asked);

}  // namespace ilot
