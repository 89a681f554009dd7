#pragma once

#include <string>
#include <utility>

#include "palpate/palpate.h"
#include "samples/cli/failure.h"

namespace palpate::cli {

// Owns a handle of the library.
template <class Handle, plp_result (*kRelease)(Handle)>
class Owned {
 public:
  Owned() = default;
  ~Owned() { kRelease(handle_); }
  Owned(Owned&& other) noexcept : handle_(std::exchange(other.handle_, nullptr)) {}
  Owned& operator=(Owned&&) = delete;

  Handle get() const { return handle_; }
  Handle* receive() { return &handle_; }

 private:
  Handle handle_ = nullptr;
};

using OwnedModel = Owned<plp_model, plp_model_release>;
using OwnedScene = Owned<plp_scene, plp_scene_release>;
using OwnedQueryResult = Owned<plp_query_result, plp_query_result_release>;

// Loads a glTF file, multiplies its positions by `scale`, and builds its hierarchy, so that no search that is
// timed has to.
inline OwnedModel load_model(const std::string& path, double scale) {
  plp_model_options options;
  plp_model_options_init(&options, sizeof options);
  options.scale = scale;
  OwnedModel model;
  check(plp_model_load_file(path.c_str(), &options, model.receive()));
  check(plp_model_prepare(model.get()));
  return model;
}

}  // namespace palpate::cli
