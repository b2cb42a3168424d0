// SPDX-License-Identifier: Apache-2.0
#pragma once
#include <filesystem>
#include <span>
#include <string>

#include "engine/deliverables/maps/map_cover.h"
#include "engine/model/street.h"

namespace ilot {

// Returns the map of a street as PDF for the plotter and the wall: sheets of A3 at one round scale, with a grid of
// coordinates, numbers of objects, a legend, the numbers of the sheets beside, and the cover under all of it. Before
// the sheets of an area, an overview says where they lie. An area that fits on one sheet has no overview. Areas far
// apart (street_areas.h) come one after the other. The scale is the largest from 1 : 250 on at which an area has 40
// sheets or fewer. `notes` are lines below the legend. The same plan gives the same bytes. O(sheets x vertices).
std::string street_book_pdf(const StreetPlan& plan, double metres_per_unit, std::span<const std::string> notes = {},
                            const CoverSource& cover = {});

// Writes it as streets.pdf, complete or not at all.
void write_street_book(const std::filesystem::path& folder, const StreetPlan& plan, double metres_per_unit,
                       std::span<const std::string> notes = {}, const CoverSource& cover = {});

}  // namespace ilot
