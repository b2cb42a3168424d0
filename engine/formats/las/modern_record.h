// SPDX-License-Identifier: Apache-2.0
// Converts rows of any point format to formats 6 to 8, for files that support only these.
#pragma once
#include <cstddef>
#include <cstdint>
#include <span>

#include "engine/formats/writer.h"

namespace ilot {

// Returns the format of 6, 7 and 8 that keeps colour and near infrared: 0, 1, 4 and 9 become 6; 2, 3 and 5 become 7; 10
// becomes 8. All fields except waveforms are kept. GPS time is 0 where there was none. Class 12 of formats 0 to 5 stays
// class 12.
std::uint8_t modern_format(std::uint8_t point_format);

// Returns the same output in a modern format. Extra bytes move to the new end of the standard fields, a CRS that is
// given only by GeoTIFF keys becomes WKT, and the descriptions of waveforms are removed. Throws Error when the record
// would exceed 65,535 bytes.
CloudSpec modern_spec(const CloudSpec& spec);

// Converts rows of `from_format` with `extra` bytes behind the standard fields. `to` has space for as many rows as
// `from`.
void modernise(std::span<const std::byte> from, std::uint8_t from_format, std::size_t extra, std::span<std::byte> to);

}  // namespace ilot
