#pragma once

#include <cstddef>
#include <vector>

#include "samples/cli/commands.h"
#include "samples/cli/handles.h"
#include "samples/cli/motion.h"

namespace palpate::cli {

// The models of a run, one for each body of its motion: A, or nodes of A where they were a glTF scene's, and
// B for a tool that is none of these.
class RunModels {
 public:
  RunModels(const RunArguments& arguments, const Motion& motion);  // throws Failure

  plp_model operator[](std::size_t body) const { return models_[body].get(); }
  double diagonal(std::size_t body) const;

 private:
  std::vector<OwnedModel> models_;
};

}  // namespace palpate::cli
