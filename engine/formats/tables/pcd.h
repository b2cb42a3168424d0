// SPDX-License-Identifier: Apache-2.0
// PCD of the Point Cloud Library, version 0.5 to 0.7: ascii, binary and binary_compressed.
#pragma once
#include <cstddef>
#include <memory>
#include <span>

#include "engine/formats/file.h"
#include "engine/formats/reader.h"

namespace ilot {

// Binary files are random access, ascii files are read front to back. binary_compressed is one block and is kept in
// memory, at most 1 GiB. The packed colours rgb and rgba become LAS colours. Throws Error when the header is not
// understood or the compressed block is damaged.
std::unique_ptr<PointReader> open_pcd(std::unique_ptr<InputFile> file);

bool looks_like_pcd(std::span<const std::byte> beginning);

// Expands a block of LZF: literal runs of up to 32 bytes, and copies of up to 264 bytes from up to 8 KiB behind. True
// when the result fills `out` exactly and uses all of `in`. O(out); never reads or writes outside the buffers.
bool expand_lzf(std::span<const std::byte> in, std::span<std::byte> out);

}  // namespace ilot
