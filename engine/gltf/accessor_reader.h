#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "engine/gltf/attribute_table.h"
#include "engine/gltf/buffer_store.h"
#include "engine/gltf/gltf_document.h"
#include "engine/gltf/load_budget.h"

namespace palpate::gltf {

// Reads accessors, sparse ones and those without a bufferView too. Ranges are checked before memory is taken.
class AccessorReader {
 public:
  AccessorReader(const GltfDocument& document, BufferStore& buffers, LoadBudget& budget)
      : document_(document), buffers_(buffers), budget_(budget) {}

  // Rows of `width` numbers, normalized integers scaled.
  AttributeTable table(int index, std::uint32_t width);

  // The same for positions, as shared as they are in the file: primitives of one mesh often read one
  // accessor.
  std::shared_ptr<const AttributeTable> positions(int index);

  // Vertex indices; the primitive-restart value is refused.
  std::vector<std::uint32_t> indices(int index);

  const tinygltf::Accessor& accessor(int index) const;
  BufferStore& buffers() { return buffers_; }

 private:
  template <class Out>
  std::vector<Out> read(const tinygltf::Accessor& accessor, std::uint32_t width);
  template <class Out>
  void patch(const tinygltf::Accessor& accessor, std::uint32_t width, std::vector<Out>& values);

  const GltfDocument& document_;
  BufferStore& buffers_;
  LoadBudget& budget_;
  int cached_index_ = -1;
  std::shared_ptr<const AttributeTable> cached_;
};

}  // namespace palpate::gltf
