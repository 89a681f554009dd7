#pragma once

#include "tests/bench/scenes.h"
#include "tests/bench/turns.h"

namespace palpate::bench {

// FCL's distance between two triangle models, with nearest points, on one kind of bounding volume.
std::unique_ptr<Method> fcl_obbrss_method(const ModelPair& pair);
std::unique_ptr<Method> fcl_rss_method(const ModelPair& pair);

// What FCL's hierarchy of a model costs.
struct HierarchyCost {
  double build_us;
  double bytes;
};
HierarchyCost fcl_hierarchy_cost(const Mesh& mesh);

}  // namespace palpate::bench
