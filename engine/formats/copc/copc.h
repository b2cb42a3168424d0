// SPDX-License-Identifier: Apache-2.0
// COPC 1.0: a LAZ file whose chunks are the nodes of an octree, so that only a few of them are read for a box.
#pragma once
#include <cstdint>
#include <filesystem>
#include <memory>

#include "engine/formats/rows_in_box.h"
#include "engine/formats/writer.h"

namespace ilot {

// True when the file declares that it is COPC; its hierarchy may still be damaged.
bool is_copc(const CloudInfo& info);

// True when the name is that of a COPC file: any stem, then .copc.laz in upper or lower case.
bool is_copc_name(const std::filesystem::path& path);

// Takes rows of any point format and writes formats 6 to 8 (modern_record.h) as an octree (copc_octree.h). The order of
// the rows is lost, but the same rows in the same order give the same bytes. All rows stay in memory until finish().
// finish() also needs memory for the nodes in compression, one for each thread; each node is compressed by one thread.
// There is one hierarchy page. Throws Error as soon as the rows written, or the rows that spec.like declares, do not
// fit spec.octree_bytes.
std::unique_ptr<PointWriter> create_copc(const std::filesystem::path& path, const CloudSpec& spec);

}  // namespace ilot
