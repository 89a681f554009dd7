#pragma once

#include "tests/capi/shapes.h"
#include "tests/fault/journey.h"

namespace palpate::test {

// What most scenarios call.
void release(Journey& journey, plp_model model);
void release(Journey& journey, plp_scene scene);
plp_model new_model(Journey& journey, const Shape& shape);
plp_scene new_scene(Journey& journey, const plp_scene_options& options);
plp_body add(Journey& journey, plp_scene scene, plp_model model, plp_body_kind kind, const plp_pose& pose);
void place(Journey& journey, plp_scene scene, plp_body body, const plp_pose& pose);

}  // namespace palpate::test
