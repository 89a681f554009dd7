#pragma once

#include "tests/bench/scenes.h"
#include "tests/bench/turns.h"

namespace palpate::bench {

// Coal's distance between two triangle models, with nearest points. Null where this build has not found Coal.
std::unique_ptr<Method> coal_method(const ModelPair& pair);

}  // namespace palpate::bench
