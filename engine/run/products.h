// SPDX-License-Identifier: Apache-2.0
// The list of products. It is the only place that names them all.
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "engine/products/product.h"

namespace ilot {

// Returns them in the order in which they are shown to people, and in which their classes of points count.
std::span<const Product* const> all_products();

// Returns the products that are asked for and the planes that they need, in the order in which they are made.
std::vector<const Product*> products_to_make(const std::vector<std::string>& asked);

// Makes these products in their order, with `make` where it is given. Sets run.outlines_wanted.
void make_all(std::span<const Product* const> products, ProductRun& run,
              const std::function<void(const Product&)>& make = {});

// What the products that were made say of points, in the order in which their classes count. Drops run.planes.
std::vector<ProductLabels> labels_of(std::span<const Product* const> made, ProductRun& run);

// A line for each product that was asked for: what was made, and the file in the folder that has it.
std::string product_lines(const std::vector<std::string>& asked, const RunRecord& record,
                          const std::filesystem::path& folder);

}  // namespace ilot
