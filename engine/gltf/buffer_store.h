#pragma once

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <vector>

#include "engine/gltf/gltf_container.h"
#include "engine/gltf/gltf_document.h"
#include "engine/gltf/load_budget.h"

namespace palpate::gltf {

// The bytes behind a bufferView.
struct ViewBytes {
  std::span<const std::byte> bytes;
  std::uint64_t stride = 0;  // 0: elements are tightly packed
};

// Reads buffers and decompresses bufferViews when they are first asked for, so that what only images use is
// never touched. Views stay valid as long as the store, the document and the file's bytes.
class BufferStore {
 public:
  // External buffers come from `folder`; an empty one means that there are none.
  BufferStore(const GltfDocument& document, const Container& container, std::filesystem::path folder,
              LoadBudget& budget);

  ViewBytes view(int index);

 private:
  std::span<const std::byte> buffer(int index);
  std::span<const std::byte> load_buffer(std::size_t index);
  std::vector<std::byte> load_uri(const std::string& uri);
  std::span<const std::byte> part(int buffer_index, std::uint64_t offset, std::uint64_t length);

  const GltfDocument& document_;
  const Container& container_;
  std::filesystem::path folder_;
  LoadBudget& budget_;
  std::vector<std::vector<std::byte>> owned_;  // by buffer, unless it is the binary chunk
  std::vector<std::optional<std::span<const std::byte>>> buffers_;
  std::vector<std::optional<std::vector<std::byte>>> decoded_;  // by bufferView
};

}  // namespace palpate::gltf
