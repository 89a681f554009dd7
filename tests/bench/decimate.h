#pragma once

#include <memory>

#include "engine/snch/model.h"

namespace palpate::bench {

// The model with about a `divisor`th of its triangles, by meshoptimizer's quadric simplification.
std::shared_ptr<const Model> decimated(const Model& model, std::size_t divisor);

}  // namespace palpate::bench
