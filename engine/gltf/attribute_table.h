#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

namespace palpate::gltf {

// Numbers of a vertex attribute, one row a vertex. Double precision holds every component type of glTF
// exactly.
struct AttributeTable {
  std::uint32_t width = 1;
  std::vector<double> values;

  std::size_t rows() const { return values.size() / width; }
  const double* row(std::size_t index) const { return values.data() + index * width; }
};

}  // namespace palpate::gltf
