#pragma once

#include "tests/bench/fcl_methods.h"
#include "tests/bench/scenes.h"
#include "tests/bench/turns.h"

namespace palpate::bench {

// Point-shell sampling: each vertex of the tool asks Embree for the closest point of the other model within
// the cutoff. A spring pushes at every vertex that is no farther than all its neighbours, so that their
// number does not depend on how fine the tool is. Edges of the tool that lean over edges of the model are
// missed.
std::unique_ptr<Method> point_shell_method(const ModelPair& pair);

// What Embree's hierarchy of a model costs, its triangles included.
HierarchyCost embree_hierarchy_cost(const Mesh& mesh);

}  // namespace palpate::bench
