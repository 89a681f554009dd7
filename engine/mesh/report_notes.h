#pragma once

#include <cstdint>
#include <string>

#include "engine/mesh/mesh_report.h"

namespace palpate {

// "1 edge", "3,371 edges".
std::string counted(std::uint64_t count, const std::string& singular, const std::string& plural);

// Adds a note for each count of `report` that says that something was repaired, kept or left open.
void add_notes(MeshReport& report);

}  // namespace palpate
