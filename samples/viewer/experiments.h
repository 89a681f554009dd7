#pragma once

#include <string>

#include "samples/viewer/arguments.h"

namespace palpate::viewer {

// One of the experiments of [JW04] with its models from `models`, or from PALPATE_DATA: a scripted hand moves
// one over the other, followed by local descent and the law of springs. Throws cli::Failure.
Arguments experiment(const std::string& name, const std::string& models);

std::string experiment_names();  // for people

}  // namespace palpate::viewer
