#pragma once

#include <cstddef>

namespace palpate {

// Work in pieces that do not touch each other.
class Pieces {
 public:
  virtual ~Pieces() = default;
  // `worker` counts from 0: what belongs to one is used by one thread at a time.
  virtual void run(std::size_t piece, std::size_t worker) = 0;
};

// Who runs pieces of work. The outcome must not depend on it.
class Executor {
 public:
  virtual ~Executor() = default;
  virtual std::size_t workers() const = 0;  // at least 1

  // Runs all `count` pieces and returns when the last is done. If some throw, what the first of them threw is
  // thrown again.
  virtual void run(Pieces& pieces, std::size_t count) = 0;
};

}  // namespace palpate
