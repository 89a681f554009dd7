#pragma once

#include "tests/bench/scenes.h"
#include "tests/bench/turns.h"

namespace palpate::bench {

// Bullet's collision of two GImpact triangle meshes, the one that takes two concave models. It has no
// distance between them: it finds the triangles that margins make overlap, here of half the cutoff each, and
// clips them against each other. The deepest of its contacts is taken. Single precision, as Debian builds it.
std::unique_ptr<Method> bullet_method(const ModelPair& pair);

}  // namespace palpate::bench
