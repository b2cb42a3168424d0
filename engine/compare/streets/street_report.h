// SPDX-License-Identifier: Apache-2.0
// Trees and kerbs in the reports of an evaluation.
#pragma once
#include <nlohmann/json.hpp>
#include <string>

#include "engine/compare/streets/carriageway_areas.h"
#include "engine/compare/streets/kerb_errors.h"
#include "engine/compare/streets/pavement_errors.h"
#include "engine/compare/streets/tree_errors.h"

namespace ilot {

std::string trees_text(const TreeResult& trees);
std::string kerbs_text(const KerbResult& kerbs);
std::string pavements_text(const PavementResult& pavements);
std::string carriageways_text(const CarriagewayResult& carriageways);
nlohmann::ordered_json trees_json(const TreeResult& trees);
nlohmann::ordered_json kerbs_json(const KerbResult& kerbs);
nlohmann::ordered_json pavements_json(const PavementResult& pavements);
nlohmann::ordered_json carriageways_json(const CarriagewayResult& carriageways);

}  // namespace ilot
