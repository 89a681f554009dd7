#pragma once

#include "samples/viewer/arguments.h"
#include "samples/viewer/model_file.h"

namespace palpate::viewer {

// Finds where the tool, let down on the scene against `up`, nearly touches it, and how far a scripted hand
// goes from there.
Workplace find_workplace(const Arguments& arguments, const ModelFile& scene, const ModelFile& tool);

}  // namespace palpate::viewer
