// SPDX-License-Identifier: Apache-2.0
#include "engine/replay/kept_planes.h"

#include <algorithm>

#include "engine/products/planes/product.h"
#include "engine/products/product.h"
#include "engine/run/products.h"

namespace ilot {

std::shared_ptr<PlanesResult> kept_planes(const KeptRun& run, Progress& progress) {
  RunRecord record;
  const std::filesystem::path folder = run.store().folder() / "replayed";  // for tables that the run already has
  std::filesystem::create_directories(folder);
  ProductRun work{run.store(),
                  run.inputs(),
                  run.options().settings,
                  run.context(),
                  nullptr,
                  nullptr,
                  [&](const char* product) { return run.made(product); },
                  std::ranges::any_of(products_to_make(run.options().products), &Product::found_among_planes),
                  folder,
                  progress,
                  record};
  planes_product().make(work);
  return work.planes;
}

}  // namespace ilot
