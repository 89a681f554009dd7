#pragma once

#include "tests/bench/scenes.h"
#include "tests/bench/turns.h"

#include "engine/descent/lmd_tracker.h"

namespace palpate::bench {

// The parts of the engine by themselves. Each keeps the models; the cutoff is in metres.
std::unique_ptr<Method> search_method(const ModelPair& pair);
std::unique_ptr<Method> front_method(const ModelPair& pair);

// Descent alone: the search that finds what it follows is every ten poses and not measured.
std::unique_ptr<Method> descent_method(const ModelPair& pair, DescentForm form);

}  // namespace palpate::bench
