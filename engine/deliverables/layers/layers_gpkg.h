// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>

#include "engine/cloud/cloud_info.h"
#include "engine/model/layer.h"

namespace ilot {

// Writes one GeoPackage with a table for every layer, in their order, also for layers without a feature. There are no
// time stamps. Throws Error when it cannot be written; then no file remains.
void write_layers(const std::filesystem::path& path, std::span<const Layer> layers, const Crs& crs);

}  // namespace ilot
