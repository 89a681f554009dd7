#pragma once

#include "engine/mesh/triangle_soup.h"

namespace palpate::shapes {

// A four-cylinder crankshaft along x: five main journals, four pins, eight webs with counterweights, snout
// and flange; 0.287 m long, one closed surface with concave fillets and edges. `segments` points run around
// every cross-section, a multiple of 20; 450·segments triangles: 45,000 by default.
TriangleSoup crankshaft(int segments = 100);

}  // namespace palpate::shapes
