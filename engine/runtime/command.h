#pragma once

#include "engine/exchange/mailbox.h"
#include "engine/scene/scene.h"

namespace palpate {

// A change to a scene, carried out between two ticks by the thread that steps it. It brings all the memory
// that the change needs and takes away what the change frees.
class Command : public Letter {
 public:
  virtual void execute(Scene& scene) noexcept = 0;

  // Whether it is destroyed once it is done; otherwise it may be posted again as soon as it executes.
  virtual bool ends() const { return true; }
};

}  // namespace palpate
