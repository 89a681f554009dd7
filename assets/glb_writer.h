#pragma once

#include <string>

#include "engine/mesh/triangle_soup.h"

namespace palpate {

// The bytes of a binary glTF 2.0 file with one node and one mesh: float32 positions, uint32 indices, and a
// second, double-sided primitive if some triangles are. Same soup, same bytes. Positions must be exact in
// float32.
std::string glb_bytes(const TriangleSoup& soup, const std::string& name);

}  // namespace palpate
