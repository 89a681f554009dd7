#pragma once

#include <string>

#include "capi/src/errors.h"
#include "engine/scene/law_springs.h"

namespace palpate::capi {

// The engine's name of a plp_law; refuses a number that is none. `name` is the argument's.
inline ForceLaw law_of(std::int32_t law, const char* name) {
  switch (law) {
    case PLP_LAW_SPRINGS:
      return ForceLaw::kSprings;
    case PLP_LAW_SMOOTH:
      return ForceLaw::kSmooth;
  }
  refuse(ErrorCode::kInvalidArgument, std::string(name) + " is no plp_law");
}

}  // namespace palpate::capi
