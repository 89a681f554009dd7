#include "engine/gltf/buffer_store.h"

#include <algorithm>
#include <cctype>
#include <string>
#include <utility>

#include "engine/gltf/byte_range.h"
#include "engine/gltf/file_bytes.h"
#include "engine/gltf/load_error.h"
#include "engine/gltf/meshopt_view.h"
#include "engine/gltf/safe_path.h"

namespace palpate::gltf {
namespace {

// Schemes are compared without regard to case (RFC 3986, section 3.1).
bool is_data_uri(const std::string& uri) {
  constexpr std::string_view kScheme = "data:";
  return uri.size() >= kScheme.size() &&
         std::equal(kScheme.begin(), kScheme.end(), uri.begin(), [](char a, char b) {
           return a == static_cast<char>(std::tolower(static_cast<unsigned char>(b)));
         });
}

std::vector<std::byte> decode_data_uri(const std::string& uri) {
  std::vector<unsigned char> decoded;
  std::string mime_type;
  if (!tinygltf::DecodeDataURI(&decoded, mime_type, uri, 0, false))
    fail(ErrorCode::kBadFormat, "data URI ", quoted(uri), " is not base64 of a known kind");
  const auto* first = reinterpret_cast<const std::byte*>(decoded.data());
  return {first, first + decoded.size()};
}

}  // namespace

BufferStore::BufferStore(const GltfDocument& document, const Container& container,
                         std::filesystem::path folder, LoadBudget& budget)
    : document_(document),
      container_(container),
      folder_(std::move(folder)),
      budget_(budget),
      owned_(document.buffers.size()),
      buffers_(document.buffers.size()),
      decoded_(document.model.bufferViews.size()) {}

ViewBytes BufferStore::view(int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= decoded_.size())
    fail(ErrorCode::kBadFormat, "bufferView ", index, " does not exist");
  const auto at = static_cast<std::size_t>(index);
  return within("bufferView", at, [&]() -> ViewBytes {
    const tinygltf::BufferView& view = document_.model.bufferViews[at];
    const std::optional<MeshoptBlock>& block = document_.meshopt[at];
    if (!block) return {part(view.buffer, view.byteOffset, view.byteLength), view.byteStride};
    if (!decoded_[at])
      decoded_[at] =
          decode_meshopt(*block, part(block->buffer, block->byte_offset, block->byte_length), budget_);
    return {*decoded_[at], block->mode == MeshoptMode::kAttributes ? block->byte_stride : 0};
  });
}

std::span<const std::byte> BufferStore::part(int buffer_index, std::uint64_t offset, std::uint64_t length) {
  const std::span<const std::byte> whole = buffer(buffer_index);
  if (!range_fits(offset, length, whole.size()))
    fail(ErrorCode::kBadFormat, length, " bytes at ", offset, " lie past the ", whole.size(), " of buffer ",
         buffer_index);
  return whole.subspan(offset, length);
}

std::span<const std::byte> BufferStore::buffer(int index) {
  if (index < 0 || static_cast<std::size_t>(index) >= buffers_.size())
    fail(ErrorCode::kBadFormat, "buffer ", index, " does not exist");
  const auto at = static_cast<std::size_t>(index);
  if (!buffers_[at]) buffers_[at] = within("buffer", at, [&] { return load_buffer(at); });
  return *buffers_[at];
}

std::span<const std::byte> BufferStore::load_buffer(std::size_t index) {
  const BufferSource& source = document_.buffers[index];
  std::span<const std::byte> bytes = container_.chunk;
  if (source.uri) {
    owned_[index] = load_uri(*source.uri);
    bytes = owned_[index];
  } else if (index != 0 || !container_.has_chunk) {
    fail(ErrorCode::kBadFormat, "neither a URI nor a binary chunk holds its bytes");
  }
  if (bytes.size() < source.byte_length)
    fail(ErrorCode::kBadFormat, "it should have ", source.byte_length, " bytes and has ", bytes.size());
  return bytes.first(source.byte_length);
}

std::vector<std::byte> BufferStore::load_uri(const std::string& uri) {
  if (is_data_uri(uri)) return decode_data_uri(uri);
  if (folder_.empty())
    fail(ErrorCode::kFileNotFound, "there is no folder for the external file ", quoted(uri));
  const std::filesystem::path path = resolve_uri(uri, folder_);
  try {
    return read_file_bytes(path, budget_);
  } catch (const LoadError& error) {
    fail(error.code(), "external file ", quoted(uri), ": ", error.what());
  }
}

}  // namespace palpate::gltf
