#pragma once

#include <memory>

#include "samples/viewer/workplace.h"

namespace palpate::viewer {

// All that is loaded before anything runs. What has not been named yet is null.
struct Content {
  Arguments arguments;  // with all that was to be chosen
  std::shared_ptr<const ModelFile> scene;
  std::shared_ptr<const ModelFile> tool;
  Workplace place;  // once both are there

  bool complete() const { return scene && tool; }
};

}  // namespace palpate::viewer
