#pragma once

#include <cstdint>

#include "engine/gltf/gltf_options.h"
#include "engine/gltf/load_tally.h"

namespace palpate::gltf {

// What one load may still take. Each call is made before the memory is taken and throws kLimit when too much
// is asked.
class LoadBudget {
 public:
  explicit LoadBudget(const GltfLimits& limits);

  void take_bytes(std::uint64_t count);

  // Elements of accessors to be decoded. Bounds the work of files whose primitives read one long accessor
  // again and again.
  void take_elements(std::uint64_t count);

  // Throws if a mesh of so many triangles could not be placed even once.
  void require_triangles(std::uint64_t count) const;

  void take_instances(std::uint64_t instances, std::uint64_t triangles_each);

  LoadTally tally;  // counted, not limited

 private:
  GltfLimits limits_;
  std::uint64_t bytes_left_;
  std::uint64_t elements_left_;
  std::uint64_t triangles_left_;
  std::uint64_t instances_left_;
};

}  // namespace palpate::gltf
